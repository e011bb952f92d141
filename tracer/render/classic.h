// The `classic` integrator: the recursive algorithm of the original report. Direct light with 1/d^2
// and a shadow ray to every light (a ball light's visible share by sampling its area), Lambert and
// Phong, mirror rays R = V - 2 (V . N) N, refraction by Snell's law with the index of the medium
// left over that of the medium entered, total reflection, absorption over the distance inside,
// recursion to a depth, the environment where a ray leaves the scene. Start reading at trace().
#pragma once

#include <limits>

#include "tracer/render/camera_hit.h"
#include "tracer/render/layers.h"
#include "tracer/render/path_record.h"
#include "tracer/render/shadow.h"

namespace glint {

template <Features F>
class ClassicTracer {
  public:
    ClassicTracer(KernelState& state, const Sampler& sampler)
        : state_(state), scene_(state.scene), sampler_(sampler) {}

    /// Radiance that arrives along a camera ray.
    Rgb radiance(const Ray& cameraRay) {
        MediaStack media;
        if constexpr (has(F, Feature::Media)) media = mediaAt(scene_, cameraRay.origin);
        ++state_.rays.primary;
        Branch first{cameraRay, media, Rgb(1.0f), 1.0f, 0, 1, true, true};
        record<F>(state_, [&](PathRecord& r) {
            first.vertex = r.leave(-1, PathEvent::Camera, Rgb(1.0f), 1);
        });
        trace(first);
        return sum_;
    }

  private:
    struct Branch {
        Ray ray;
        MediaStack media;
        Rgb weight;        ///< factor on its light at the camera
        float importance;  ///< largest factor between here and the camera, for the roulette of dim
                           ///< branches
        int depth;         ///< surface interactions so far
        std::uint32_t
            key;  ///< place in the tree of rays: the children of k are 32 k + 1, 32 k + 2 ...
        bool straightFromCamera;
        bool seesLights;  ///< false behind a rough lobe, which has taken the lights' share directly
        int vertex = -1;  ///< the record's (layers only)
    };

    /// Light found at the end of the branch; `light` is the source if it was sampled, of which
    /// `visible` comes through.
    void add(const Branch& branch, PathLight::Kind kind, std::uint8_t group, const Rgb& value,
             std::uint32_t light = ~0u, const Rgb& visible = Rgb(1.0f)) {
        sum_ += value;
        state_.addToGroup(group, value);
        record<F>(state_, [&](PathRecord& r) {
            r.add(branch.vertex, scene_, kind, light, visible, value);
        });
    }

    /// Notes what the branch has met. Dim branches, which are there by chance, count for nothing.
    void follow(const Branch& branch, std::uint32_t met) {
        if (branch.importance > state_.dim) state_.follow(branch.key ^ sobol::mix(met));
    }

    /// One shape may lie before itself, a torus: one of 16 parts (its quarter, upper or lower,
    /// inner or outer), so that there is a change of trail between what is in front and what is
    /// behind. Other shapes are convex: 0.
    [[nodiscard]] std::uint32_t partOf(const SurfacePoint& point) const {
        const ShapeInstance& instance = point.instance(scene_);
        if (!std::holds_alternative<CanonicalTorus>(instance.shape)) return 0;
        const DVec3 p = instance.localPoint(point.position);
        return (p.x > 0 ? 1u : 0u) + (p.y > 0 ? 2u : 0u) + (p.z > 0 ? 4u : 0u) +
               (p.x * p.x + p.z * p.z > 1 ? 8u : 0u);
    }

    /// Adds the light that arrives along the branch, which is followed and so changed.
    void trace(Branch& branch) {
        if (state_.stop()) return;
        const ShapeHit hit = hitOf<F>(state_, branch.ray, branch.media, branch.depth);
        if constexpr (has(F, Feature::Media))
            if (!branch.media.empty())
                branch.weight *= transmittance<F>(
                    mediumOf(scene_, fillingShape(scene_, branch.media)), hit.t, state_.work);
        record<F>(state_, [&](PathRecord& r) {
            r.travel(branch.vertex, hit.t, mediumOf(scene_, fillingShape(scene_, branch.media)));
        });
        if (!hit.found()) {
            follow(branch, ~0u);
            return addSky(branch);
        }
        const SurfacePoint point = surfacePoint(scene_, branch.ray, hit, branch.media);
        const CompiledMaterial& material = scene_.materials[point.instance(scene_).material];
        state_.materials |= material.bit;
        if (point.hidden) {
            branch.ray = {point.position, branch.ray.direction, point.shape, point.outside};
            branch.media.cross(point.shape);
            return trace(branch);
        }
        follow(branch, (point.shape * 16 + partOf(point)) * 16 +
                           static_cast<std::uint32_t>(2 * point.face) + (point.outside ? 1 : 0));
        if constexpr (has(F, Feature::Layers))
            if (branch.depth == 0) describeSurface(scene_, point, *state_.layers, state_.work);
        record<F>(state_,
                  [&](PathRecord& r) { r.arrive(branch.vertex, scene_, point, branch.weight); });
        if (branch.seesLights) addEmission(branch, point);
        if (branch.depth >= scene_.settings.maxDepth) return;
        if (material.hasSmooth()) addDirect(branch, point, material);
        reflectAndRefract(branch, point, material);
    }

    void addSky(const Branch& branch) {
        if (!has(F, Feature::NoSkips) && !has(scene_.features, Feature::Sky)) return;
        ++state_.work[Work::SkyLookups];
        const CompiledEnvironment& environment = scene_.lights.environment;
        if (!environment.isBlack() && !(branch.straightFromCamera && !environment.visibleToCamera))
            add(branch, PathLight::Kind::Environment, environment.group,
                branch.weight * seenInSky(environment, branch.ray.direction));
        if (!branch.seesLights) return;
        for (const std::uint32_t sun : scene_.lights.sunDiscs) {
            const CompiledLight& light = scene_.lights.lights[sun];
            if (light.discHolds(branch.ray.direction))
                add(branch, PathLight::Kind::Environment, light.group,
                    branch.weight * light.emission);
        }
    }

    Rgb seenInSky(const CompiledEnvironment& environment, const DVec3& direction) const {
        if (environment.map) {
            ++state_.work[Work::MapLookups];
            state_.doubt = std::numeric_limits<float>::infinity();
        }
        return environment.radiance(direction);
    }

    void addEmission(const Branch& branch, const SurfacePoint& point) {
        if (!has(F, Feature::NoSkips) && !has(scene_.features, Feature::AreaLights)) return;
        ++state_.work[Work::EmissionTests];
        const std::uint32_t light = point.instance(scene_).light;
        if (light == ~0u) return;
        const CompiledLight& emitter = scene_.lights.lights[light];
        if (point.outside || emitter.twoSided)
            add(branch, PathLight::Kind::Emission, emitter.group, branch.weight * emitter.emission);
    }

    /// Light straight from every source but the environment.
    void addDirect(const Branch& branch, const SurfacePoint& point,
                   const CompiledMaterial& material) {
        const std::vector<CompiledLight>& lights = scene_.lights.lights;
        for (std::uint32_t i = 0; i < lights.size(); ++i) {
            if (i == scene_.lights.environmentLight) continue;
            ++state_.work[Work::LightSamples];
            const LightSample s = lights[i].isDelta() ? sampleDelta(lights[i], point.position)
                                                      : sampleSized(branch, point, i);
            if (!(s.pdf > 0) || isBlack(s.radiance)) continue;
            const Vec3 wi = toFloat(point.frame.toLocal(s.wi));
            const Rgb f = smoothValue<F>(material, point.wo, wi, point.eta, state_.work);
            if (isBlack(f)) {
                if constexpr (!has(F, Feature::NoSkips)) continue;
                ++state_.work[Work::BlackShadowRays];
            }
            const Ray ray = point.ray(s.wi, wi.z < 0);
            const Rgb share = shadowTransmittance<F>(
                state_, ray, mediaBeyond<F>(state_, point, branch.media, wi),
                {i, s.distance, s.shape}, scene_.settings.maxDepth - branch.depth - 1,
                scene_.settings.transparentShadows);
            if (isBlack(share) && !isBlack(f)) follow(branch, 0x80000000u + i);
            const float cosine = std::abs(wi.z);
            const Rgb value =
                branch.weight * f * s.radiance * share *
                (s.pdf == 1 ? cosine : static_cast<float>(static_cast<double>(cosine) / s.pdf));
            add(branch, PathLight::Kind::Direct, lights[i].group, value, i, share);
        }
    }

    /// A place on a light that has a size.
    [[nodiscard, gnu::noinline]] LightSample sampleSized(const Branch& branch,
                                                         const SurfacePoint& point,
                                                         std::uint32_t light) const {
        const SampleBlock u =
            sampler_.block(sobol::mix(branch.key) ^ sampleBlock(SampleUse::Light, 0, 0, light));
        const Ray from{point.position, point.frame.n, point.shape, !point.outside};
        return sampleLight(scene_.lights, scene_.shapes, light, from, branch.media, {u.x, u.y});
    }

    /// The delta branches, and for rough lobes the perfect ones that they are near to.
    void reflectAndRefract(const Branch& branch, const SurfacePoint& point,
                           const CompiledMaterial& material) {
        if (has(F, Feature::NoSkips) || material.hasDelta) {
            const Branches delta = deltaBranches(material, point.wo, point.eta, state_.work);
            for (int i = 0; i < delta.count; ++i) {
                const DeltaBranch& way = delta.at[static_cast<std::size_t>(i)];
                follow(branch, point, way, i, branch.seesLights || !way.straight);
            }
        }
        if (!has(F, Feature::Rough) || !material.isRough) return;
        const Branches perfect = perfectBranches(material, point);
        for (int i = 0; i < perfect.count; ++i)
            follow(branch, point, perfect.at[static_cast<std::size_t>(i)], Branches::kCapacity + i,
                   false);
    }

    void follow(const Branch& branch, const SurfacePoint& point, const DeltaBranch& way, int number,
                bool seesLights) {
        Branch next{point.ray(way.wi),
                    mediaBeyond<F>(state_, point, branch.media, way.wi),
                    branch.weight * way.weight,
                    branch.importance * maxComponent(way.weight),
                    branch.depth + 1,
                    branch.key * 32 + static_cast<std::uint32_t>(number) + 1,
                    branch.straightFromCamera && way.straight,
                    seesLights};
        float chance = 1;
        Rgb expected(0.0f);
        if (next.importance < state_.dim) {
            chance = next.importance / state_.dim;
            if (state_.expected) expected = state_.expected->towards(way.wi);
            sum_ += next.weight * expected;
            if (sampler_.block(sobol::mix(next.key) ^ sampleBlock(SampleUse::Bsdf, 0, 0)).x >=
                chance)
                return;
            next.weight /= chance;
            next.importance = state_.dim;
        }
        ++state_.rays.scatter;
        record<F>(state_, [&](PathRecord& r) {
            next.vertex = r.leave(branch.vertex, eventOf(point, way), way.weight,
                                  static_cast<double>(chance));
        });
        if (chance == 1) return trace(next);
        const Rgb before = sum_, weight = next.weight;
        trace(next);
        const Rgb foreseen = weight * expected, more = sum_ - before - foreseen;
        sum_ -= foreseen;
        if (state_.expected) state_.expected->learn(way.wi, weight, more);
        // The variance of what comes with this chance, as told by one that has come.
        const float light = luminance(more);
        state_.doubt += light * light * (1 - chance);
    }

    static Branches perfectBranches(const CompiledMaterial& material, const SurfacePoint& point) {
        Branches out;
        for (const WeightedLeaf& weighted : material.leaves)
            std::visit(
                [&]<class Leaf>(const Leaf& leaf) {
                    if constexpr (requires(DeltaBranch * b) {
                                      leaf.perfectBranches(point.wo, point.eta, b);
                                  }) {
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
    Rgb sum_{0.0f};
};

}  // namespace glint
