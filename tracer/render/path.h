// The `path` integrator: unidirectional path tracing with next-event estimation, multiple
// importance sampling by the balance heuristic (Veach 1997, ch. 9) and Russian roulette. At the
// first smooth dielectrics both ways are followed. Start reading at radiance(). Where paths go is
// told here, what light they bring in path_radiance.h. Instantiated in kernels.cpp for sets of
// features; what a set lacks is not compiled.
#pragma once

#include <utility>

#include "tracer/render/camera_hit.h"
#include "tracer/render/path_radiance.h"

namespace glint {

template <Features F, class Heuristic = UsualHeuristic, class Effort = UsualEffort>
class PathTracer {
  public:
    PathTracer(KernelState& state, const Sampler& sampler)
        : state_(state), scene_(state.scene), sampler_(sampler), light_(state, sampler) {}

    /// Radiance that arrives along a camera ray.
    Rgb radiance(const Ray& cameraRay) {
        Path first;
        first.ray = cameraRay;
        if constexpr (has(F, Feature::Media)) first.media = mediaAt(scene_, cameraRay.origin);
        ++state_.rays.primary;
        record<F>(state_, [&](PathRecord& r) {
            first.vertex = r.leave(-1, PathEvent::Camera, Rgb(1.0f), 1);
        });
        follow(first);
        return light_.sum();
    }

  private:
    using Path = PathState;
    using Does = PathWork<F, Effort>;

    /// Hidden boundaries count as no interaction; this many in a row mean a path caught in
    /// rounding.
    static constexpr int kMaxHidden = 256;
    static constexpr float kLeastChance = 0.05f;
    static constexpr float kNoNumber = -1;

    void follow(Path path) {
        int hidden = 0;
        while (!state_.stop()) {
            const ShapeHit hit = hitOf<F>(state_, path.ray, path.media, path.depth);
            if constexpr (has(F, Feature::Media))
                if (!path.media.empty())
                    path.throughput *= transmittance<F>(
                        mediumOf(scene_, fillingShape(scene_, path.media)), hit.t, state_.work);
            record<F>(state_, [&](PathRecord& r) {
                r.travel(path.vertex, hit.t, mediumOf(scene_, fillingShape(scene_, path.media)));
            });
            if (!hit.found()) return light_.addSky(path);
            const SurfacePoint point = surfacePoint(scene_, path.ray, hit, path.media);
            state_.materials |= scene_.materials[point.instance(scene_).material].bit;
            if constexpr (has(F, Feature::Media)) {
                if (point.hidden) {
                    if (++hidden > kMaxHidden) return;
                    path.ray = {point.position, path.ray.direction, point.shape, point.outside};
                    path.media.cross(point.shape);
                    path.chain = {};
                    path.drive = 0;
                    continue;
                }
            }
            if constexpr (has(F, Feature::Layers))
                if (path.depth == 0) describeSurface(scene_, point, *state_.layers, state_.work);
            record<F>(state_, [&](PathRecord& r) {
                r.arrive(path.vertex, scene_, point, path.throughput);
            });
            if constexpr (has(F, Feature::AreaLights)) light_.addEmission(path, point);
            if (path.depth >= scene_.settings.maxDepth || !scatter(path, point)) return;
        }
    }

    void recordBranch(Path& path, const SurfacePoint& point, const DeltaBranch& branch,
                      double chance) {
        record<F>(state_, [&](PathRecord& r) {
            path.vertex = r.leave(path.vertex, eventOf(point, branch), branch.weight, chance);
        });
    }

    /// One surface interaction: light from the sources, then the next direction. False: the path
    /// ends.
    bool scatter(Path& path, const SurfacePoint& point) {
        const CompiledMaterial& material = scene_.materials[point.instance(scene_).material];
        const HighlightStep step = lastStep(path, point);
        Branches branches;
        if constexpr (has(F, Feature::Delta))
            if (material.hasDelta)
                branches = deltaBranches(material, point.wo, point.eta, state_.work);
        const float total = material.smoothAlbedo + branches.total;
        if (!(total > 0)) return false;
        const float smoothChance = material.smoothAlbedo / total;
        const Receiver receiver{path, step, point, material, smoothChance};

        const std::uint32_t own = sampleBlock(SampleUse::Bsdf, path.depth, path.branch);
        const bool lit = Does::kSamplesLights && (smoothChance > 0 || has(F, Feature::NoSkips)) &&
                         !scene_.lights.empty();
        SampleBlock u(0.0f);
        // The fourth of the light's numbers: sums of what each use brings stay right if they share
        // it.
        float spare = kNoNumber;
        if (lit) {
            const auto [light, bsdf] =
                sampler_.blocks(sampleBlock(SampleUse::Light, path.depth, path.branch), own);
            u = bsdf;
            if (smoothChance > 0) spare = light.w;
            if constexpr (Does::kSamplesLights) light_.addDirect(receiver, light);
        }
        if constexpr (Does::kConnects)
            if (smoothChance > 0 && !scene_.casters.empty()) light_.addConnections(receiver, spare);
        if constexpr (Does::kHighlights)
            if (smoothChance > 0 && !scene_.highlights.empty())
                light_.addHighlights(receiver, spare);
        if constexpr (has(F, Feature::Delta)) {
            if (path.splits < Effort::kMostSplits && branches.areTwo(material))
                return takeBoth(path, point, branches);
        }
        if (!lit) u = sampler_.block(own);
        const float choice = u.w * total;
        if (!has(F, Feature::Delta) || choice < material.smoothAlbedo) {
            if constexpr (has(F, Feature::Smooth)) {
                u.w = std::min(choice / material.smoothAlbedo, 0x1.fffffep-1f);
                return takeSmooth(path, receiver, u) && survives(path, Effort::kDim, spare);
            }
            return false;
        }
        const DeltaBranch& branch = branches.pick(choice - material.smoothAlbedo);
        recordBranch(path, point, branch, static_cast<double>(Branches::size(branch) / total));
        path.throughput *= branch.weight * (total / Branches::size(branch));
        takeBranch(path, point, branch,
                   branches.chanceOf(material, point.wo, sameSide(point.wo, branch.wi)));
        return survives(path, Effort::kDimBranch, spare);
    }

    /// A direction of the smooth part; the last of the numbers chooses its leaf. False: there is
    /// none.
    [[gnu::always_inline]] bool takeSmooth(Path& path, const Receiver& from, const SampleBlock& u) {
        const SurfacePoint& point = from.point;
        const CompiledMaterial& material = from.material;
        const BsdfSample s =
            sampleSmooth<F>(material, point.wo, {u.x, u.y, u.z}, u.w, point.eta, state_.work);
        if (!(s.pdf > 0)) return false;
        record<F>(state_, [&](PathRecord& r) {
            path.vertex = r.leave(path.vertex, PathEvent::Smooth, s.f * (std::abs(s.wi.z) / s.pdf),
                                  static_cast<double>(from.smoothChance));
        });
        const float drive = connectionDrive(path.throughput, material);
        if constexpr (Does::kHighlights) path.drive = highlightDrive(path.throughput, material);
        path.throughput *= s.f * (std::abs(s.wi.z) / (s.pdf * from.smoothChance));
        path.pdf = static_cast<double>(s.pdf) * from.smoothChance;
        path.from = point.position;
        path.fromNormal = point.facingNormal();
        path.step = from.step;
        if constexpr (Does::kLightsMayBePassed) path.passedLights = {};
        path.allLights = light_.sampleAll(path);
        path.scattered = true;
        if constexpr (has(F, Feature::Layers))
            if (path.bounces == 0) path.shares = smoothShares(material, point.wo, s.wi, point.eta);
        leave(path, point, s.wi, false);
        if (!path.media.empty()) path.drive = 0;
        if constexpr (Does::kConnects)
            path.chain = ChainProgress::start(scene_, point.shape, path.media, path.pdf, drive);
        return true;
    }

    /// Both ways, each with its whole weight, instead of a coin: one to its end, then the other
    /// goes on.
    bool takeBoth(Path& path, const SurfacePoint& point, const Branches& branches) {
        Path other = path;
        other.branch += 1U << path.splits;
        ++path.splits;
        ++other.splits;
        if (takeWhole(other, point, branches.at[1])) follow(other);
        return takeWhole(path, point, branches.at[0]);
    }
    bool takeWhole(Path& path, const SurfacePoint& point, const DeltaBranch& branch) {
        path.throughput *= branch.weight;
        recordBranch(path, point, branch, 1);
        takeBranch(path, point, branch, 1);
        return roulette(path, Effort::kDimBranch);
    }

    /// `chance`: of this direction among all that the path could have taken.
    void takeBranch(Path& path, const SurfacePoint& point, const DeltaBranch& branch,
                    double chance) {
        if constexpr (Does::kConnects)
            path.chain.advance(scene_, point, branch, chance, path.from, path.ray.direction);
        if constexpr (has(F, Feature::Layers))
            if (path.bounces == 0)
                path.shares =
                    sharesOf(sameSide(point.wo, branch.wi) ? Lobe::Glossy : Lobe::Transmission);
        if (branch.straight) {
            if constexpr (Does::kLightsMayBePassed)
                if (const std::uint32_t light = point.instance(scene_).light;
                    light != ~0u && !path.passedLights.contains(light))
                    path.passedLights.cross(light);
            leave(path, point, branch.wi, true);
        } else {
            path.pdf = 0;
            path.step = {};
            path.etaScale /= branch.scale;
            leave(path, point, branch.wi, false);
        }
    }

    void leave(Path& path, const SurfacePoint& point, const Vec3& wi, bool straight) {
        if constexpr (has(F, Feature::Media))
            path.media = mediaBeyond<F>(state_, point, path.media, wi);
        path.ray = straight ? point.ray(path.ray.direction, wi.z < 0) : point.ray(wi);
        path.straightFromCamera = path.straightFromCamera && straight;
        if constexpr (has(F, Feature::Layers)) path.bounces += straight ? 0 : 1;
        ++path.depth;
        ++state_.rays.scatter;
    }

    /// Whether the path goes on: surely to its second surface, beyond as roulette() says.
    bool survives(Path& path, float dim, float number) {
        return path.depth < 2 ? maxComponent(path.throughput) > 0 : roulette(path, dim, number);
    }

    /// Russian roulette: paths that carry less than `dim` go on with a chance in proportion to what
    /// they carry, to a last light surely. `number`: in [0, 1), drawn if there is none.
    bool roulette(Path& path, float dim, float number = kNoNumber) {
        const float size = maxComponent(path.throughput) * path.etaScale;
        if (!(size > 0)) return false;
        if (path.depth >= scene_.settings.maxDepth) return true;
        ++state_.work[Work::Roulettes];
        if (size >= dim) return true;
        const float chance = std::max(size / dim, kLeastChance);
        if (number == kNoNumber)
            number =
                sampler_.block(sampleBlock(SampleUse::Light, path.depth - 1, path.branch, 63)).x;
        if (number >= chance) return false;
        path.throughput /= chance;
        record<F>(state_, [&](PathRecord& r) {
            r.vertices[static_cast<std::size_t>(path.vertex)].chance *= static_cast<double>(chance);
        });
        return true;
    }

    /// The step by which the path came to the point, if a highlight could have drawn it.
    [[nodiscard]] HighlightStep lastStep(Path& path, const SurfacePoint& point) const {
        if constexpr (Does::kHighlights) {
            const float drive = std::exchange(path.drive, 0.0f);
            const GlossySurface* surface = drive > 0 && path.ray.fromShape != point.shape
                                               ? scene_.highlights.find(point.shape)
                                               : nullptr;
            if (surface) return {surface, path.from, point.position, point.face, path.pdf, drive};
        }
        return {};
    }

    KernelState& state_;
    const RenderScene& scene_;
    const Sampler& sampler_;
    PathRadiance<F, Heuristic, Effort> light_;
};

}  // namespace glint
