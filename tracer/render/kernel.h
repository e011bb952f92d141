// The contract between kernels (path.h, classic.h) and whoever runs them: one call renders one
// sample of one pixel.
#pragma once

#include <array>
#include <atomic>
#include <optional>
#include <span>
#include <string_view>

#include "tracer/compile/render_scene.h"
#include "tracer/math/sobol.h"
#include "tracer/render/expected_light.h"
#include "tracer/render/pixel_filter.h"
#include "tracer/render/render.h"
#include "tracer/scene/light_groups.h"

namespace glint {

/// Tells a kernel that its work is stale: the epoch has moved on from the one the work began in.
/// Partner: Session::publish and whoever else bumps the epoch; relaxed, because nothing is read on
/// the strength of it.
struct CancelToken {
    const std::atomic<std::uint64_t>* epoch = nullptr;  ///< null: never cancelled
    std::uint64_t begun = 0;
    [[nodiscard]] bool cancelled() const {
        return epoch && epoch->load(std::memory_order_relaxed) != begun;
    }
};

struct LayerSample;
struct PathRecord;

/// One sample's light by light group.
using GroupLight = std::array<Rgb, kMaxLightGroups>;

/// What one worker carries from sample to sample.
struct KernelState {
    const RenderScene& scene;
    CancelToken cancel;
    RayCounts rays;
    bool cancelled = false;         ///< the last sample was given up: throw its value away
    LayerSample* layers = nullptr;  ///< filled by kernels with Feature::Layers
    PathRecord* record =
        nullptr;  ///< if not null: filled by kernels with Feature::Layers, see path_record.h
    GroupLight* groups = nullptr;     ///< if not null: filled with the sample's light by group
    const FewShapes* seen = nullptr;  ///< if not null: all shapes that the camera's ray can meet
    std::optional<ShapeHit>* cameraHit =
        nullptr;  ///< if not null: what the camera's ray hits; filled where it is not known
    std::uint64_t materials =
        0;  ///< set of the materials whose values the sample rests on, see materialBit()
    float dim = 0.01f;  ///< classic's branches that are dimmer at the camera go on by chance: a
                        ///< tree of glass would grow without end
    ExpectedLight* expected = nullptr;  ///< if not null: makes these less noisy, but a sample may
                                        ///< be negative then, and its groups do not sum up to it
    std::uint32_t trail = 0;  ///< of the sample: a hash of what its rays met. Between samples of
                              ///< one trail the light changes smoothly; classic alone tells it
    float doubt = 0;  ///< of the sample: variance of its luminance by chance (roulette); infinite
                      ///< where it may jump within a trail
    WorkCounts work;

    /// To be asked at every path vertex.
    bool stop() {
        if (cancel.cancelled()) cancelled = true;
        return cancelled;
    }
    /// The sample's rays have met this: what it is in any numbering that other samples have too.
    void follow(std::uint32_t met) { trail = sobol::mix(trail ^ met); }
    void addToGroup(std::uint8_t group, const Rgb& value) {
        if (groups) (*groups)[group] += value;
    }
};

/// Radiance of sample number `sample` of pixel (x, y).
using KernelFunction = Rgb (*)(KernelState& state, int x, int y, std::uint32_t sample);

/// Radiance along a camera ray with the random numbers of `sampler`.
using RayFunction = Rgb (*)(KernelState& state, const Ray& cameraRay, const Sampler& sampler);

struct Kernel {
    std::string_view name;
    Integrator integrator = Integrator::Path;
    Features features = 0;  ///< what it can trace
    KernelFunction run = nullptr;
    RayFunction trace = nullptr;  ///< classic alone
};

/// All kernels that are built.
[[nodiscard]] std::span<const Kernel> allKernels();
/// The smallest one that covers the scene and what is wanted beside: Feature::Layers, kAllFeatures
/// for the kernel that leaves nothing out, Feature::NoSkips for the one that spares no work.
[[nodiscard]] const Kernel& chooseKernel(const RenderScene& scene, Features wanted = 0);

/// Block numbers of the sampler. A decision always uses the same block, whatever else a kernel
/// skips, so that every kernel gives the same bits.
enum class SampleUse : std::uint32_t { Camera = 0, Bsdf = 1, Light = 2, Caustic = 3 };
/// So many splits of a path have a bit of their own in its block numbers.
constexpr int kSplitBits = 4;
/// `branch`: of the path, below 2^kSplitBits.
[[nodiscard]] inline std::uint32_t sampleBlock(SampleUse use, int depth, std::uint32_t branch,
                                               std::uint32_t index = 0) {
    return static_cast<std::uint32_t>(use) + 4 * index + 256 * static_cast<std::uint32_t>(depth) +
           (branch << (32 - kSplitBits));
}

/// The camera ray of a sample.
template <Features F>
[[nodiscard]] Ray cameraRay(const RenderScene& scene, const Sampler& sampler, int x, int y,
                            WorkCounts& work) {
    const SampleBlock u = sampler.block(sampleBlock(SampleUse::Camera, 0, 0));
    const FilmSettings& film = scene.film;
    const double px = x + 0.5 + film.filterRadius * sampleFilter(film.filter, u.x);
    const double py = y + 0.5 + film.filterRadius * sampleFilter(film.filter, u.y);
    if (!has(F, Feature::Lens) || !scene.camera.hasLens()) return scene.camera.ray(px, py);
    ++work[Work::LensSamples];
    return scene.camera.ray(px, py, DVec2(u.z, u.w));
}

[[nodiscard]] inline Sampler samplerFor(const RenderScene& scene, int x, int y,
                                        std::uint32_t sample) {
    return {static_cast<std::uint32_t>(scene.settings.seed),
            static_cast<std::uint32_t>(y) * static_cast<std::uint32_t>(scene.film.width) +
                static_cast<std::uint32_t>(x),
            sample};
}

}  // namespace glint
