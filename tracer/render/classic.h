// The `classic` integrator: the recursive algorithm of the original report. Direct light with 1/d^2 and a shadow ray to every
// light (a ball light's visible share by sampling its area), Lambert and Phong, mirror rays R = V - 2 (V . N) N, refraction by
// Snell's law with the index of the medium left over that of the medium entered, total reflection, absorption over the
// distance inside, recursion to a depth, the environment where a ray leaves the scene. Start reading at trace().
#pragma once

#include "tracer/render/layers.h"
#include "tracer/render/shadow.h"

namespace glint {

template <Features F>
class ClassicTracer {
  public:
    ClassicTracer(KernelState& state, const Sampler& sampler) : state_(state), scene_(state.scene), sampler_(sampler) {}

    /// Radiance that arrives along a camera ray.
    Rgb radiance(const Ray& cameraRay) {
        MediaStack media;
        if constexpr (has(F, Feature::Media)) media = scene_.cameraMedia;
        ++state_.rays.primary;
        return trace({cameraRay, media, 1.0f, 0, 1, true});
    }

  private:
    struct Branch {
        Ray ray;
        MediaStack media;
        float importance;          ///< largest factor between here and the camera, for the roulette of dim branches
        int depth;                 ///< surface interactions so far
        std::uint32_t key;         ///< place in the tree of rays: the children of k are 16 k + 1, 16 k + 2 ...
        bool straightFromCamera;
    };

    /// Branches dimmer than this go on by chance, with their weight made up for: a tree of glass would grow without end.
    static constexpr float kDim = 0.01f;

    Rgb trace(const Branch& branch) {
        if (state_.stop()) return Rgb(0.0f);
        const ShapeHit hit = scene_.lists.closest(branch.ray, branch.media);
        Rgb share(1.0f);
        if constexpr (has(F, Feature::Media))
            if (!branch.media.empty()) share = transmittance(mediumOf(scene_, fillingShape(scene_, branch.media)), hit.t);
        if (!hit.found()) return share * sky(branch);
        const SurfacePoint point = surfacePoint(scene_, branch.ray, hit, branch.media);
        if (point.hidden) {
            Branch on = branch;
            on.ray = {point.position, branch.ray.direction, point.shape, point.outside};
            on.media.cross(point.shape);
            return share * trace(on);
        }
        if constexpr (has(F, Feature::Layers))
            if (branch.depth == 0) describeSurface(scene_, point, *state_.layers);
        Rgb sum = emission(point);
        if (branch.depth < scene_.settings.maxDepth) {
            const CompiledMaterial& material = scene_.materials[point.instance(scene_).material];
            if (material.hasSmooth()) sum += direct(branch, point, material);
            sum += reflectedAndRefracted(branch, point, material);
        }
        return share * sum;
    }

    Rgb sky(const Branch& branch) const {
        const CompiledEnvironment& environment = scene_.lights.environment;
        Rgb sum(0.0f);
        if (!environment.isBlack() && !(branch.straightFromCamera && !environment.visibleToCamera))
            sum = environment.radiance(branch.ray.direction);
        for (const std::uint32_t sun : scene_.lights.sunDiscs) {
            const CompiledLight& light = scene_.lights.lights[sun];
            if (light.discHolds(branch.ray.direction)) sum += light.emission;
        }
        return sum;
    }

    Rgb emission(const SurfacePoint& point) const {
        const std::uint32_t light = point.instance(scene_).light;
        if (light == ~0u) return Rgb(0.0f);
        const CompiledLight& emitter = scene_.lights.lights[light];
        return point.outside || emitter.twoSided ? emitter.emission : Rgb(0.0f);
    }

    /// Light straight from every source but the environment.
    Rgb direct(const Branch& branch, const SurfacePoint& point, const CompiledMaterial& material) {
        Rgb sum(0.0f);
        const Ray from{point.position, point.frame.n, point.shape, !point.outside};
        for (std::uint32_t i = 0; i < scene_.lights.lights.size(); ++i) {
            if (i == scene_.lights.environmentLight) continue;
            const SampleBlock u = sampler_.block(sobol::mix(branch.key) ^ sampleBlock(SampleUse::Light, 0, 0, i));
            const LightSample s = sampleLight(scene_.lights, scene_.shapes, i, from, branch.media, {u.x, u.y});
            if (!(s.pdf > 0) || isBlack(s.radiance)) continue;
            const Vec3 wi = toFloat(point.frame.toLocal(s.wi));
            const BsdfSample f = evalSmooth(material, point.wo, wi, point.eta);
            if (isBlack(f.f)) continue;
            const Ray ray{point.position, s.wi, point.shape, wi.z < 0};
            const Rgb share = shadowTransmittance<F>(state_, ray, mediaBeyond<F>(scene_, point, branch.media, wi), s.distance, s.shape,
                                                     scene_.settings.maxDepth - branch.depth - 1, scene_.settings.transparentShadows);
            sum += f.f * s.radiance * share * static_cast<float>(std::abs(wi.z) / s.pdf);
        }
        return sum;
    }

    Rgb reflectedAndRefracted(const Branch& branch, const SurfacePoint& point, const CompiledMaterial& material) {
        Rgb sum(0.0f);
        const Branches ways = classicBranches(material, point);
        for (int i = 0; i < ways.count; ++i) {
            const DeltaBranch& way = ways.at[static_cast<std::size_t>(i)];
            Branch next{point.ray(way.wi), mediaBeyond<F>(scene_, point, branch.media, way.wi),
                        branch.importance * maxComponent(way.weight), branch.depth + 1,
                        branch.key * 16 + static_cast<std::uint32_t>(i) + 1, branch.straightFromCamera && way.straight};
            Rgb weight = way.weight;
            if (next.importance < kDim) {
                const float chance = next.importance / kDim;
                if (sampler_.block(sobol::mix(next.key) ^ sampleBlock(SampleUse::Bsdf, 0, 0)).x >= chance) continue;
                weight /= chance;
                next.importance = kDim;
            }
            ++state_.rays.scatter;
            sum += weight * trace(next);
        }
        return sum;
    }

    /// The delta branches, and for rough lobes the perfect one that they are near to.
    static Branches classicBranches(const CompiledMaterial& material, const SurfacePoint& point) {
        Branches out = deltaBranches(material, point.wo, point.eta);
        for (const WeightedLeaf& weighted : material.leaves)
            std::visit(
                [&]<class Leaf>(const Leaf& leaf) {
                    if constexpr (requires(DeltaBranch* b) { leaf.perfectBranches(point.wo, point.eta, b); }) {
                        DeltaBranch found[kMaxBranches];
                        const int count = leaf.perfectBranches(point.wo, point.eta, found);
                        for (int i = 0; i < count; ++i) {
                            found[i].weight *= weighted.weight;
                            out.add(found[i]);
                        }
                    }
                },
                weighted.leaf);
        return out;
    }

    KernelState& state_;
    const RenderScene& scene_;
    const Sampler& sampler_;
};

}  // namespace glint
