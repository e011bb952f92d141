// The `path` integrator: unidirectional path tracing with next-event estimation, multiple
// importance sampling by the balance heuristic (Veach 1997, ch. 9) and Russian roulette. At the
// first smooth dielectrics both ways are followed. Start reading at radiance(). Instantiated in
// kernels.cpp for sets of features; what a set lacks is not compiled.
#pragma once

#include "tracer/render/camera_hit.h"
#include "tracer/render/connections.h"
#include "tracer/render/highlights.h"
#include "tracer/render/layers.h"
#include "tracer/render/path_choices.h"
#include "tracer/render/path_record.h"
#include "tracer/render/path_state.h"
#include "tracer/render/shadow.h"

namespace glint {

template <Features F, class Heuristic = UsualHeuristic, class Effort = UsualEffort>
class PathTracer {
  public:
    PathTracer(KernelState& state, const Sampler& sampler)
        : state_(state), scene_(state.scene), sampler_(sampler) {}

    /// Radiance that arrives along a camera ray.
    Rgb radiance(const Ray& cameraRay) {
        Path first;
        first.ray = cameraRay;
        if constexpr (has(F, Feature::Media)) first.media = mediaAt(scene_, cameraRay.origin);
        ++state_.rays.primary;
        record([&](PathRecord& r) { first.vertex = r.leave(-1, PathEvent::Camera, Rgb(1.0f), 1); });
        follow(first);
        return sum_;
    }

  private:
    using Path = PathState;

    static constexpr bool kSamplesLights =
        has(F, Feature::DeltaLights) || has(F, Feature::AreaLights) || has(F, Feature::SampledSky);
    static constexpr bool kConnects = Effort::kConnects && has(F, Feature::Casters);
    static constexpr bool kHighlights = Effort::kHighlights && has(F, Feature::Highlights);
    static constexpr bool kLightsMayBePassed =
        has(F, Feature::Straight) && has(F, Feature::AreaLights);
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
            record([&](PathRecord& r) {
                r.travel(path.vertex, hit.t, mediumOf(scene_, fillingShape(scene_, path.media)));
            });
            if (!hit.found()) return addSky(path);
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
            record([&](PathRecord& r) { r.arrive(path.vertex, scene_, point, path.throughput); });
            if constexpr (has(F, Feature::AreaLights)) addEmission(path, point);
            if (path.depth >= scene_.settings.maxDepth || !scatter(path, point)) return;
        }
    }

    /// Weight of light found by following the path to a light that next-event estimation, having
    /// chosen the light, would reach with density lightDensity().
    template <class Density>
    [[nodiscard]] float foundWeight(const Path& path, std::uint32_t light,
                                    Density lightDensity) const {
        if (!has(F, Feature::Smooth) || path.pdf == 0) return 1;
        if constexpr (kLightsMayBePassed)
            if (path.passedLights.contains(light)) return 1;
        ++state_.work[Work::MisWeights];
        const double chosen =
            path.allLights || scene_.lights.lights.size() == 1
                ? 1.0
                : scene_.lights.choice.probability(path.from, path.fromNormal, light);
        return static_cast<float>(Heuristic::bsdfWeight(path.pdf, chosen * lightDensity()) *
                                  shareOf(path.step, light));
    }
    /// The same for light that a connection over a perfect ball would reach at `y`, or in that
    /// direction.
    [[nodiscard]] float foundWeight(const Path& path, std::uint32_t light, const DVec3& y,
                                    const DVec3& normal) const {
        if constexpr (kConnects)
            if (const ChainProgress& chain = path.chain;
                chain.state == ChainProgress::State::Complete) {
                const double pdf =
                    connectionPdf(scene_, chain, light, path.from, y, path.ray.direction, normal);
                return pdf > 0 ? static_cast<float>(Heuristic::bsdfWeight(chain.pdf, pdf)) : 1;
            }
        return foundWeight(path, light, [&] {
            return lightPdf(scene_.lights, scene_.shapes, light, path.from, path.ray.direction);
        });
    }

    /// Weight of light that a path brings by a step that a highlight could have drawn.
    [[nodiscard]] double shareOf(const HighlightStep& step, std::uint32_t light) const {
        if constexpr (kHighlights)
            if (step.surface)
                return Heuristic::bsdfWeight(step.pdf, highlightDensity(scene_, step, light));
        return 1;
    }

    void addSky(const Path& path) {
        if constexpr (has(F, Feature::Sky)) {
            if (!has(F, Feature::NoSkips) && !has(scene_.features, Feature::Sky)) return;
            ++state_.work[Work::SkyLookups];
            const CompiledEnvironment& environment = scene_.lights.environment;
            if (!environment.isBlack() &&
                !(path.straightFromCamera && !environment.visibleToCamera))
                add(path, LightLayer::Environment, environment.group,
                    path.throughput * environment.scale * seenInSky(path, environment));
            if constexpr (has(F, Feature::SampledSky))
                for (const std::uint32_t sun : scene_.lights.sunDiscs)
                    if (const CompiledLight& light = scene_.lights.lights[sun];
                        light.discHolds(path.ray.direction))
                        add(path, LightLayer::Environment, light.group,
                            path.throughput * light.emission *
                                foundWeight(path, sun, path.ray.direction, DVec3(0.0)));
        }
    }

    [[nodiscard]] Rgb seenInSky(const Path& path, const CompiledEnvironment& environment) const {
        if (!environment.map) return Rgb(1.0f);
        ++state_.work[Work::MapLookups];
        const EnvironmentLookup seen =
            environment.map->evaluate(environment.mapFromWorld(path.ray.direction));
        const std::uint32_t light = scene_.lights.environmentLight;
        if (path.pdf == 0)
            return seen.radiance * foundWeight(path, light, path.ray.direction, DVec3(0.0));
        return seen.radiance * foundWeight(path, light, [&] { return seen.pdf; });
    }

    void addEmission(const Path& path, const SurfacePoint& point) {
        if (!has(F, Feature::NoSkips) && !has(scene_.features, Feature::AreaLights)) return;
        ++state_.work[Work::EmissionTests];
        const std::uint32_t light = point.instance(scene_).light;
        if (light == ~0u) return;
        const CompiledLight& emitter = scene_.lights.lights[light];
        if (point.outside || emitter.twoSided)
            add(path, LightLayer::Emission, emitter.group,
                path.throughput * emitter.emission *
                    foundWeight(path, light, point.position, point.frame.n));
    }

    /// Tells the record, if one is kept (layers only).
    template <class Tell>
    void record(Tell&& tell) {
        if constexpr (has(F, Feature::Layers))
            if (state_.record) tell(*state_.record);
    }
    void recordBranch(Path& path, const SurfacePoint& point, const DeltaBranch& branch,
                      double chance) {
        record([&](PathRecord& r) {
            path.vertex = r.leave(path.vertex, eventOf(point, branch), branch.weight, chance);
        });
    }

    /// Light found where the path has come to; `seen` is its layer if the camera sees it there
    /// itself.
    void add(const Path& path, LightLayer seen, std::uint8_t group, const Rgb& value) {
        sum_ += value;
        state_.addToGroup(group, value);
        record([&](PathRecord& r) {
            r.add(path.vertex, scene_,
                  seen == LightLayer::Emission ? PathLight::Kind::Emission
                                               : PathLight::Kind::Environment,
                  ~0u, Rgb(1.0f), value);
        });
        if constexpr (has(F, Feature::Layers)) {
            if (path.bounces == 0)
                state_.layers->add(seen, value);
            else
                state_.layers->add(path.shares, path.bounces == 1, value);
        }
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

        const std::uint32_t own = sampleBlock(SampleUse::Bsdf, path.depth, path.branch);
        const bool lit = has(F, Feature::Smooth) && kSamplesLights &&
                         (smoothChance > 0 || has(F, Feature::NoSkips)) && !scene_.lights.empty();
        SampleBlock u(0.0f);
        float spare = kNoNumber;  // The fourth of the light's numbers: sums of what each use brings
                                  // stay right if they share it.
        if (lit) {
            const auto [light, bsdf] =
                sampler_.blocks(sampleBlock(SampleUse::Light, path.depth, path.branch), own);
            u = bsdf;
            if (smoothChance > 0) spare = light.w;
            if constexpr (has(F, Feature::Smooth) && kSamplesLights)
                addDirect(path, step, point, material, smoothChance, light);
        }
        if constexpr (kConnects)
            if (smoothChance > 0 && !scene_.casters.empty())
                addConnections(path, point, material, smoothChance, spare);
        if constexpr (kHighlights)
            if (smoothChance > 0 && !scene_.highlights.empty())
                addHighlights(path, point, material, smoothChance, spare);
        if constexpr (has(F, Feature::Delta)) {
            if (path.splits < Effort::kMostSplits && branches.areTwo(material))
                return takeBoth(path, point, branches);
        }
        if (!lit) u = sampler_.block(own);
        const float choice = u.w * total;
        if (!has(F, Feature::Delta) || choice < material.smoothAlbedo) {
            if constexpr (has(F, Feature::Smooth)) {
                const float leafChoice = std::min(choice / material.smoothAlbedo, 0x1.fffffep-1f);
                const BsdfSample s = sampleSmooth<F>(material, point.wo, {u.x, u.y, u.z},
                                                     leafChoice, point.eta, state_.work);
                if (!(s.pdf > 0)) return false;
                record([&](PathRecord& r) {
                    path.vertex =
                        r.leave(path.vertex, PathEvent::Smooth, s.f * (std::abs(s.wi.z) / s.pdf),
                                static_cast<double>(smoothChance));
                });
                const float drive = connectionDrive(path.throughput, material);
                if constexpr (kHighlights) path.drive = highlightDrive(path.throughput, material);
                path.throughput *= s.f * (std::abs(s.wi.z) / (s.pdf * smoothChance));
                path.pdf = static_cast<double>(s.pdf) * smoothChance;
                path.from = point.position;
                path.fromNormal = point.facingNormal();
                path.step = step;
                if constexpr (kLightsMayBePassed) path.passedLights = {};
                path.allLights = sampleAll(path);
                path.scattered = true;
                if constexpr (has(F, Feature::Layers))
                    if (path.bounces == 0)
                        path.shares = smoothShares(material, point.wo, s.wi, point.eta);
                leave(path, point, s.wi, false);
                if (!path.media.empty()) path.drive = 0;
                if constexpr (kConnects)
                    path.chain =
                        ChainProgress::start(scene_, point.shape, path.media, path.pdf, drive);
                return survives(path, Effort::kDim, spare);
            }
            return false;
        } else {
            const DeltaBranch& branch = branches.pick(choice - material.smoothAlbedo);
            recordBranch(path, point, branch, static_cast<double>(Branches::size(branch) / total));
            path.throughput *= branch.weight * (total / Branches::size(branch));
            takeBranch(path, point, branch,
                       branches.chanceOf(material, point.wo, sameSide(point.wo, branch.wi)));
            return survives(path, Effort::kDimBranch, spare);
        }
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
        if constexpr (kConnects)
            path.chain.advance(scene_, point, branch, chance, path.from, path.ray.direction);
        if constexpr (has(F, Feature::Layers))
            if (path.bounces == 0)
                path.shares =
                    sharesOf(sameSide(point.wo, branch.wi) ? Lobe::Glossy : Lobe::Transmission);
        if (branch.straight) {
            if constexpr (kLightsMayBePassed)
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
        record([&](PathRecord& r) {
            r.vertices[static_cast<std::size_t>(path.vertex)].chance *= static_cast<double>(chance);
        });
        return true;
    }

    /// Every light at the first vertex with a smooth part, see Effort::kAllLights; one by choice
    /// elsewhere.
    [[nodiscard]] bool sampleAll(const Path& path) const {
        const bool wanted = Effort::kAllSized || (has(F, Feature::DeltaLights) &&
                                                  has(scene_.features, Feature::DeltaLights));
        return wanted && !path.scattered && scene_.lights.lights.size() <= Effort::kAllLights;
    }

    /// `u`: the numbers of the first light, or of the one that is chosen.
    void addDirect(const Path& path, const HighlightStep& step, const SurfacePoint& point,
                   const CompiledMaterial& material, float smoothChance, const SampleBlock& u) {
        if (sampleAll(path)) {
            for (std::uint32_t i = 0; i < scene_.lights.lights.size(); ++i) {
                const bool drawn = i > 0 && !scene_.lights.lights[i].isDelta();
                const SampleBlock own =
                    drawn
                        ? sampler_.block(sampleBlock(SampleUse::Light, path.depth, path.branch, i))
                        : u;
                addLight(path, step, point, material, smoothChance, i, 1.0, {own.x, own.y});
            }
        } else {
            double chosen = 1;
            std::uint32_t light = 0;
            if (has(F, Feature::NoSkips) || scene_.lights.lights.size() > 1) {
                ++state_.work[Work::LightChoices];
                const LightChoice::Chosen choice = scene_.lights.choice.choose(
                    point.position, point.facingNormal(), static_cast<double>(u.z));
                light = choice.light;
                chosen = choice.probability;
                if (chosen == 0) return;
            }
            addLight(path, step, point, material, smoothChance, light, chosen, {u.x, u.y});
        }
    }

    /// `step`: by which the path came to the point.
    void addLight(const Path& path, const HighlightStep& step, const SurfacePoint& point,
                  const CompiledMaterial& material, float smoothChance, std::uint32_t light,
                  double chosen, const DVec2& u) {
        Ray from{point.position, point.frame.n, point.shape, !point.outside};
        ++state_.work[Work::LightSamples];
        if (light == scene_.lights.environmentLight) ++state_.work[Work::MapLookups];
        const LightSample s = sampleLight(scene_.lights, scene_.shapes, light, from, path.media, u);
        if (!(s.pdf > 0) || isBlack(s.radiance)) return;
        const Vec3 wi = toFloat(point.frame.toLocal(s.wi));
        const BsdfSample f = evalSmooth<F>(material, point.wo, wi, point.eta, state_.work);
        const double density = chosen * s.pdf;
        double weight = shareOf(step, light);
        if (!scene_.lights.lights[light].isDelta()) {
            ++state_.work[Work::MisWeights];
            weight *= Heuristic::lightWeight(density, static_cast<double>(f.pdf) * smoothChance);
        }
        addSeen(path, point, material, light, s, f, weight / density);
    }

    /// Light from a place or a direction on a light, if nothing is in between; `f`: what the
    /// surface makes of it, `factor`: its weight over its density.
    void addSeen(const Path& path, const SurfacePoint& point, const CompiledMaterial& material,
                 std::uint32_t light, const LightSample& s, const BsdfSample& f, double factor) {
        if (isBlack(f.f)) {
            if constexpr (!has(F, Feature::NoSkips)) return;
            ++state_.work[Work::BlackShadowRays];
        }
        const Ray ray = point.ray(s.wi, f.wi.z < 0);
        const Rgb share = shadowTransmittance<F>(
            state_, ray, mediaBeyond<F>(state_, point, path.media, f.wi),
            {light, s.distance, s.shape}, scene_.settings.maxDepth - path.depth - 1, false);
        if (isBlack(share)) return;
        const Rgb value = path.throughput * f.f * s.radiance * share *
                          static_cast<float>(factor * static_cast<double>(std::abs(f.wi.z)));
        sum_ += value;
        state_.addToGroup(scene_.lights.lights[light].group, value);
        record([&](PathRecord& r) {
            r.add(path.vertex, scene_, PathLight::Kind::Direct, light, share, value);
        });
        if constexpr (has(F, Feature::Layers))
            state_.layers->add(
                path.bounces == 0 ? smoothShares(material, point.wo, f.wi, point.eta) : path.shares,
                path.bounces == 0, value);
    }

    [[gnu::noinline]] void addConnections(const Path& path, const SurfacePoint& point,
                                          const CompiledMaterial& material, float smoothChance,
                                          float number) {
        const ConnectionVertex vertex{
            point,           material,     path.media,
            path.throughput, smoothChance, number,
            path.depth,      path.branch,  Effort::kMostSplits - path.splits};
        const auto weight = [](double light, double bsdf) {
            return Heuristic::lightWeight(light, bsdf);
        };
        const auto take = [&](const Connection& found) {
            sum_ += found.value;
            state_.addToGroup(scene_.lights.lights[found.light].group, found.value);
            record([&](PathRecord& r) {
                r.add(path.vertex, scene_, PathLight::Kind::Direct, found.light, Rgb(1.0f),
                      found.value);
            });
            if constexpr (has(F, Feature::Layers))
                state_.layers->add(path.bounces == 0
                                       ? smoothShares(material, point.wo, found.wi, point.eta)
                                       : path.shares,
                                   false, found.value);
        };
        Connections<F, decltype(weight), decltype(take)>(state_, sampler_, vertex, weight, take)
            .run();
    }

    /// The step by which the path came to the point, if a highlight could have drawn it.
    [[nodiscard]] HighlightStep lastStep(Path& path, const SurfacePoint& point) const {
        if constexpr (kHighlights) {
            const float drive = std::exchange(path.drive, 0.0f);
            const GlossySurface* surface = drive > 0 && path.ray.fromShape != point.shape
                                               ? scene_.highlights.find(point.shape)
                                               : nullptr;
            if (surface) return {surface, path.from, point.position, point.face, path.pdf, drive};
        }
        return {};
    }

    [[gnu::noinline]] void addHighlights(const Path& path, const SurfacePoint& point,
                                         const CompiledMaterial& material, float smoothChance,
                                         float spare) {
        // The glossy surface scatters too.
        if (path.depth + 1 >= scene_.settings.maxDepth) return;
        const HighlightVertex vertex{
            point.position, point.shape, highlightDrive(path.throughput, material),
            spare,          path.depth,  path.branch};
        drawHighlights(
            scene_, sampler_, vertex, state_.work,
            [&](const GlossySurface& surface, std::uint32_t number, std::uint32_t light,
                const HighlightAim& aim, double density) {
                const DVec3 apart = aim.point - point.position;
                const double distance = glm::length(apart);
                const Vec3 wi = toFloat(point.frame.toLocal(apart / distance));
                if (!mediaBeyond<F>(state_, point, path.media, wi).empty()) return;
                const BsdfSample f = evalSmooth<F>(material, point.wo, wi, point.eta, state_.work);
                if (isBlack(f.f)) return;
                const Ray ray = point.ray(apart / distance, wi.z < 0);
                ++state_.rays.scatter;
                const ShapeHit hit = scene_.lists->closest(ray, {}, kInfinity, state_.work);
                constexpr double kSame = 1e-6;
                if (hit.shape != surface.shape || hit.face != aim.face ||
                    !(std::abs(hit.t - distance) <= kSame * distance))
                    return;
                const double weight = Heuristic::lightWeight(
                    density, static_cast<double>(f.pdf) * static_cast<double>(smoothChance));
                Path next = path;
                next.throughput *= f.f * static_cast<float>(static_cast<double>(std::abs(wi.z)) *
                                                            weight / density);
                if constexpr (has(F, Feature::Layers))
                    if (next.bounces == 0)
                        next.shares = smoothShares(material, point.wo, wi, point.eta);
                next.media = {};
                ++next.bounces;
                ++next.depth;
                addHighlight(next, surfacePoint(scene_, ray, hit, {}), light, number);
            });
    }

    /// What a glossy surface that the path has come to sends back of one light: from a sample of
    /// the light and one of the surface.
    void addHighlight(const Path& path, const SurfacePoint& point, std::uint32_t light,
                      std::uint32_t number) {
        const CompiledMaterial& material = scene_.materials[point.instance(scene_).material];
        state_.materials |= material.bit;
        const auto block = [&](std::uint32_t index) {
            return sampler_.block(
                sampleBlock(SampleUse::Caustic, path.depth - 1, path.branch, index + number));
        };
        const SampleBlock forLight = block(33 + kHighlightNumbers);
        addLight(path, {}, point, material, 1, light, 1, {forLight.x, forLight.y});
        if (scene_.lights.lights[light].isDelta()) return;
        const SampleBlock u = block(33 + 2 * kHighlightNumbers);
        const BsdfSample f =
            sampleSmooth<F>(material, point.wo, {u.x, u.y, u.z}, u.w, point.eta, state_.work);
        if (!(f.pdf > 0)) return;
        const Ray ray = point.ray(f.wi);
        const LightSample s = lightAlong(scene_.lights, scene_.shapes, light, ray, path.media);
        if (isBlack(s.radiance)) return;
        const auto density = static_cast<double>(f.pdf);
        addSeen(path, point, material, light, s, f,
                Heuristic::bsdfWeight(density, s.pdf) / density);
    }

    KernelState& state_;
    const RenderScene& scene_;
    const Sampler& sampler_;
    Rgb sum_{0.0f};
};

}  // namespace glint
