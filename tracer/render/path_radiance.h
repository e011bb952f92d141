// What a path of the `path` integrator brings to its pixel: light that it comes upon, and light
// that is sampled for the surfaces along it, each weighed against the other. Where paths go is
// path.h's.
#pragma once

#include <cmath>

#include "tracer/render/connections.h"
#include "tracer/render/highlights.h"
#include "tracer/render/layers.h"
#include "tracer/render/path_choices.h"
#include "tracer/render/path_record.h"
#include "tracer/render/path_state.h"
#include "tracer/render/shadow.h"

namespace glint {

/// What the path integrator does in scenes that hold these features.
template <Features F, class Effort>
struct PathWork {
    static constexpr bool kSamplesLights =
        has(F, Feature::Smooth) && (has(F, Feature::DeltaLights) || has(F, Feature::AreaLights) ||
                                    has(F, Feature::SampledSky));
    static constexpr bool kConnects = Effort::kConnects && has(F, Feature::Casters);
    static constexpr bool kHighlights = Effort::kHighlights && has(F, Feature::Highlights);
    static constexpr bool kLightsMayBePassed =
        has(F, Feature::Straight) && has(F, Feature::AreaLights);
};

/// A surface on a path that light is sampled for.
struct Receiver {
    const PathState& path;
    const HighlightStep& step;  ///< by which the path came to it
    const SurfacePoint& point;
    const CompiledMaterial& material;
    float smoothChance;  ///< that the path leaves it by the smooth part of its material
};

template <Features F, class Heuristic, class Effort>
class PathRadiance {
  public:
    PathRadiance(KernelState& state, const Sampler& sampler)
        : state_(state), scene_(state.scene), sampler_(sampler) {}

    /// Of all that was added.
    [[nodiscard]] const Rgb& sum() const { return sum_; }

    /// The environment and suns, as a path sees them that leaves the scene.
    void addSky(const PathState& path) {
        if constexpr (has(F, Feature::Sky)) {
            if (!has(F, Feature::NoSkips) && !has(scene_.features, Feature::Sky)) return;
            ++state_.work[Work::SkyLookups];
            const CompiledEnvironment& environment = scene_.lights.environment;
            if (!environment.isBlack() &&
                !(path.straightFromCamera && !environment.visibleToCamera))
                addFound(path, LightLayer::Environment, environment.group,
                         path.throughput * environment.scale * seenInSky(path, environment));
            if constexpr (has(F, Feature::SampledSky))
                for (const std::uint32_t sun : scene_.lights.sunDiscs)
                    if (const CompiledLight& light = scene_.lights.lights[sun];
                        light.discHolds(path.ray.direction))
                        addFound(path, LightLayer::Environment, light.group,
                                 path.throughput * light.emission *
                                     foundWeight(path, sun, path.ray.direction, DVec3(0.0)));
        }
    }

    /// What the surface that a path has come to emits.
    void addEmission(const PathState& path, const SurfacePoint& point) {
        if (!has(F, Feature::NoSkips) && !has(scene_.features, Feature::AreaLights)) return;
        ++state_.work[Work::EmissionTests];
        const std::uint32_t light = point.instance(scene_).light;
        if (light == ~0u) return;
        const CompiledLight& emitter = scene_.lights.lights[light];
        if (point.outside || emitter.twoSided)
            addFound(path, LightLayer::Emission, emitter.group,
                     path.throughput * emitter.emission *
                         foundWeight(path, light, point.position, point.frame.n));
    }

    /// Whether every light is sampled: at the first surface with a smooth part, see
    /// Effort::kAllLights; elsewhere one is, by choice.
    [[nodiscard]] bool sampleAll(const PathState& path) const {
        const bool wanted = Effort::kAllSized || (has(F, Feature::DeltaLights) &&
                                                  has(scene_.features, Feature::DeltaLights));
        return wanted && !path.scattered && scene_.lights.lights.size() <= Effort::kAllLights;
    }

    /// Light straight from its sources. `u`: the numbers of the first light, or of the one that is
    /// chosen. Inline, which g++ would not make it: 1 % of the time of a render.
    [[gnu::always_inline]] void addDirect(const Receiver& at, const SampleBlock& u) {
        if (sampleAll(at.path)) {
            for (std::uint32_t i = 0; i < scene_.lights.lights.size(); ++i) {
                const bool drawn = i > 0 && !scene_.lights.lights[i].isDelta();
                const SampleBlock own = drawn ? block(SampleUse::Light, at.path, i) : u;
                addLight(at, i, 1.0, {own.x, own.y});
            }
        } else {
            double chosen = 1;
            std::uint32_t light = 0;
            if (has(F, Feature::NoSkips) || scene_.lights.lights.size() > 1) {
                ++state_.work[Work::LightChoices];
                const LightChoice::Chosen choice = scene_.lights.choice.choose(
                    at.point.position, at.point.facingNormal(), static_cast<double>(u.z));
                light = choice.light;
                chosen = choice.probability;
                if (chosen == 0) return;
            }
            addLight(at, light, chosen, {u.x, u.y});
        }
    }

    /// Light by way of perfect balls and faces. `number`: for roulette, in [0, 1).
    [[gnu::noinline]] void addConnections(const Receiver& at, float number) {
        const PathState& path = at.path;
        const ConnectionVertex vertex{
            at.point,        at.material,     path.media,
            path.throughput, at.smoothChance, number,
            path.depth,      path.branch,     Effort::kMostSplits - path.splits};
        const auto weight = [](double light, double bsdf) {
            return Heuristic::lightWeight(light, bsdf);
        };
        const auto take = [&](const Connection& found) {
            addSampled(at, found.light, found.wi, false, Rgb(1.0f), found.value);
        };
        Connections<F, decltype(weight), decltype(take)>(state_, sampler_, vertex, weight, take)
            .run();
    }

    /// Light by way of its highlights in glossy surfaces. `number`: for roulette, in [0, 1).
    [[gnu::noinline]] void addHighlights(const Receiver& at, float number) {
        const PathState& path = at.path;
        // The glossy surface scatters too.
        if (path.depth + 1 >= scene_.settings.maxDepth) return;
        const HighlightVertex vertex{
            at.point.position, at.point.shape, highlightDrive(path.throughput, at.material), number,
            path.depth,        path.branch};
        drawHighlights(scene_, sampler_, vertex, state_.work,
                       [&](const GlossySurface& surface, std::uint32_t index, std::uint32_t light,
                           const HighlightAim& aim, double density) {
                           addHighlight(at, surface, index, light, aim, density);
                       });
    }

  private:
    using Does = PathWork<F, Effort>;

    [[nodiscard]] SampleBlock block(SampleUse use, const PathState& path,
                                    std::uint32_t index) const {
        return sampler_.block(sampleBlock(use, path.depth, path.branch, index));
    }

    /// Weight of light found by following the path to a light that next-event estimation, having
    /// chosen the light, would reach with density lightDensity().
    template <class Density>
    [[nodiscard]] float foundWeight(const PathState& path, std::uint32_t light,
                                    Density lightDensity) const {
        if (!has(F, Feature::Smooth) || path.pdf == 0) return 1;
        if constexpr (Does::kLightsMayBePassed)
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
    [[nodiscard]] float foundWeight(const PathState& path, std::uint32_t light, const DVec3& y,
                                    const DVec3& normal) const {
        if constexpr (Does::kConnects)
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
        if constexpr (Does::kHighlights)
            if (step.surface)
                return Heuristic::bsdfWeight(step.pdf, highlightDensity(scene_, step, light));
        return 1;
    }

    [[nodiscard]] Rgb seenInSky(const PathState& path,
                                const CompiledEnvironment& environment) const {
        if (!environment.map) return Rgb(1.0f);
        ++state_.work[Work::MapLookups];
        const EnvironmentLookup seen =
            environment.map->evaluate(environment.mapFromWorld(path.ray.direction));
        const std::uint32_t light = scene_.lights.environmentLight;
        if (path.pdf == 0)
            return seen.radiance * foundWeight(path, light, path.ray.direction, DVec3(0.0));
        return seen.radiance * foundWeight(path, light, [&] { return seen.pdf; });
    }

    /// Light that a path has come upon; `seen` is its layer if the camera sees it there itself.
    void addFound(const PathState& path, LightLayer seen, std::uint8_t group, const Rgb& value) {
        sum_ += value;
        state_.addToGroup(group, value);
        record<F>(state_, [&](PathRecord& r) {
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

    /// Light that was sampled, from the direction `wi` [local]; `share`: of it that came through.
    void addSampled(const Receiver& at, std::uint32_t light, const Vec3& wi, bool direct,
                    const Rgb& share, const Rgb& value) {
        sum_ += value;
        state_.addToGroup(scene_.lights.lights[light].group, value);
        record<F>(state_, [&](PathRecord& r) {
            r.add(at.path.vertex, scene_, PathLight::Kind::Direct, light, share, value);
        });
        if constexpr (has(F, Feature::Layers)) {
            const bool first = at.path.bounces == 0;
            state_.layers->add(
                first ? smoothShares(at.material, at.point.wo, wi, at.point.eta) : at.path.shares,
                first && direct, value);
        }
    }

    /// One sample of a light that was chosen with a probability.
    void addLight(const Receiver& at, std::uint32_t light, double chosen, const DVec2& u) {
        const SurfacePoint& point = at.point;
        Ray from{point.position, point.frame.n, point.shape, !point.outside};
        ++state_.work[Work::LightSamples];
        if (light == scene_.lights.environmentLight) ++state_.work[Work::MapLookups];
        const LightSample s =
            sampleLight(scene_.lights, scene_.shapes, light, from, at.path.media, u);
        if (!(s.pdf > 0) || isBlack(s.radiance)) return;
        const Vec3 wi = toFloat(point.frame.toLocal(s.wi));
        const BsdfSample f = evalSmooth<F>(at.material, point.wo, wi, point.eta, state_.work);
        const double density = chosen * s.pdf;
        double weight = shareOf(at.step, light);
        if (!scene_.lights.lights[light].isDelta()) {
            ++state_.work[Work::MisWeights];
            weight *= Heuristic::lightWeight(density, static_cast<double>(f.pdf) * at.smoothChance);
        }
        addSeen(at, light, s, f, weight / density);
    }

    /// Light from a place or a direction on a light, if nothing is in between; `f`: what the
    /// surface makes of it, `factor`: its weight over its density.
    void addSeen(const Receiver& at, std::uint32_t light, const LightSample& s, const BsdfSample& f,
                 double factor) {
        if (isBlack(f.f)) {
            if constexpr (!has(F, Feature::NoSkips)) return;
            ++state_.work[Work::BlackShadowRays];
        }
        const PathState& path = at.path;
        const Ray ray = at.point.ray(s.wi, f.wi.z < 0);
        const Rgb share = shadowTransmittance<F>(
            state_, ray, mediaBeyond<F>(state_, at.point, path.media, f.wi),
            {light, s.distance, s.shape}, scene_.settings.maxDepth - path.depth - 1, false);
        if (isBlack(share)) return;
        addSampled(at, light, f.wi, true, share,
                   path.throughput * f.f * s.radiance * share *
                       static_cast<float>(factor * static_cast<double>(std::abs(f.wi.z))));
    }

    /// Light by way of the point of a glossy surface that was drawn with a density.
    void addHighlight(const Receiver& at, const GlossySurface& surface, std::uint32_t index,
                      std::uint32_t light, const HighlightAim& aim, double density) {
        const SurfacePoint& point = at.point;
        const DVec3 apart = aim.point - point.position;
        const double distance = glm::length(apart);
        const Vec3 wi = toFloat(point.frame.toLocal(apart / distance));
        if (!mediaBeyond<F>(state_, point, at.path.media, wi).empty()) return;
        const BsdfSample f = evalSmooth<F>(at.material, point.wo, wi, point.eta, state_.work);
        if (isBlack(f.f)) return;
        const Ray ray = point.ray(apart / distance, wi.z < 0);
        ++state_.rays.scatter;
        const ShapeHit hit = scene_.lists->closest(ray, {}, kInfinity, state_.work);
        constexpr double kSame = 1e-6;
        if (hit.shape != surface.shape || hit.face != aim.face ||
            !(std::abs(hit.t - distance) <= kSame * distance))
            return;
        const double weight = Heuristic::lightWeight(
            density, static_cast<double>(f.pdf) * static_cast<double>(at.smoothChance));
        PathState next = at.path;
        next.throughput *=
            f.f * static_cast<float>(static_cast<double>(std::abs(wi.z)) * weight / density);
        if constexpr (has(F, Feature::Layers))
            if (next.bounces == 0) next.shares = smoothShares(at.material, point.wo, wi, point.eta);
        next.media = {};
        ++next.bounces;
        ++next.depth;
        addReflected(next, surfacePoint(scene_, ray, hit, {}), light, [&](std::uint32_t use) {
            return block(SampleUse::Caustic, at.path, 33 + use * kHighlightNumbers + index);
        });
    }

    /// What a glossy surface that the path has come to sends back of one light: from a sample of
    /// the light and one of the surface, by the blocks of numbers 1 and 2.
    template <class Numbers>
    void addReflected(const PathState& path, const SurfacePoint& point, std::uint32_t light,
                      Numbers numbers) {
        const CompiledMaterial& material = scene_.materials[point.instance(scene_).material];
        state_.materials |= material.bit;
        const HighlightStep none;
        const Receiver at{path, none, point, material, 1};
        const SampleBlock forLight = numbers(1);
        addLight(at, light, 1, {forLight.x, forLight.y});
        if (scene_.lights.lights[light].isDelta()) return;
        const SampleBlock u = numbers(2);
        const BsdfSample f =
            sampleSmooth<F>(material, point.wo, {u.x, u.y, u.z}, u.w, point.eta, state_.work);
        if (!(f.pdf > 0)) return;
        const Ray ray = point.ray(f.wi);
        const LightSample s = lightAlong(scene_.lights, scene_.shapes, light, ray, path.media);
        if (isBlack(s.radiance)) return;
        const auto density = static_cast<double>(f.pdf);
        addSeen(at, light, s, f, Heuristic::bsdfWeight(density, s.pdf) / density);
    }

    KernelState& state_;
    const RenderScene& scene_;
    const Sampler& sampler_;
    Rgb sum_{0.0f};
};

}  // namespace glint
