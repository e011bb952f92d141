// The kernels that are built: each integrator for a few sets of features.
#include "tracer/render/classic.h"
#include "tracer/render/kernel.h"
#include "tracer/render/path.h"

#include <bit>

#include "tracer/compile/compiler.h"

namespace glint {

namespace {

template <class Tracer, Features F>
Rgb runKernel(KernelState& state, int x, int y, std::uint32_t sample) {
    const RenderScene& scene = state.scene;
    const Sampler sampler = samplerFor(scene, x, y, sample);
    state.cancelled = false;
    state.materials = 0;
    for (int i = 0; i < scene.cameraMedia.size(); ++i) state.materials |= scene.materials[scene.shapes[scene.cameraMedia[i]].material].bit;
    if (state.groups) *state.groups = {};
    Rgb value = Tracer(state, sampler).radiance(cameraRay<F>(scene, sampler, x, y, state.work));
    if (const auto limit = static_cast<float>(scene.settings.clamp); limit > 0)
        if (const float size = maxComponent(value); size > limit) value *= limit / size;
    return value;
}

constexpr Features bits(auto... features) { return (static_cast<Features>(features) | ...); }

constexpr Features kDiffuse = bits(Feature::Smooth, Feature::DeltaLights, Feature::AreaLights, Feature::Sky, Feature::SampledSky, Feature::Lens);
constexpr Features kMirrors = kDiffuse | bits(Feature::Delta);
constexpr Features kGlass = kMirrors | bits(Feature::Media);
constexpr Features kRough = kMirrors | bits(Feature::Rough);
constexpr Features kRoughGlass = kGlass | bits(Feature::Rough);
constexpr Features kLayers = kAllFeatures | bits(Feature::Layers);
constexpr Features kNoSkips = kAllFeatures | bits(Feature::NoSkips);

constexpr std::array kKernels = {
    Kernel{"path: diffuse", Integrator::Path, kDiffuse, runKernel<PathTracer<kDiffuse>, kDiffuse>},
    Kernel{"path: mirrors", Integrator::Path, kMirrors, runKernel<PathTracer<kMirrors>, kMirrors>},
    Kernel{"path: glass", Integrator::Path, kGlass, runKernel<PathTracer<kGlass>, kGlass>},
    Kernel{"path: rough", Integrator::Path, kRough, runKernel<PathTracer<kRough>, kRough>},
    Kernel{"path: rough, glass", Integrator::Path, kRoughGlass, runKernel<PathTracer<kRoughGlass>, kRoughGlass>},
    Kernel{"path: all", Integrator::Path, kAllFeatures, runKernel<PathTracer<kAllFeatures>, kAllFeatures>},
    Kernel{"path: layers", Integrator::Path, kLayers, runKernel<PathTracer<kLayers>, kLayers>},
    Kernel{"path: no skips", Integrator::Path, kNoSkips, runKernel<PathTracer<kNoSkips>, kNoSkips>},
    Kernel{"classic: mirrors", Integrator::Classic, kMirrors, runKernel<ClassicTracer<kMirrors>, kMirrors>},
    Kernel{"classic: layers", Integrator::Classic, kLayers, runKernel<ClassicTracer<kLayers>, kLayers>},
    Kernel{"classic: all", Integrator::Classic, kAllFeatures, runKernel<ClassicTracer<kAllFeatures>, kAllFeatures>},
    Kernel{"classic: no skips", Integrator::Classic, kNoSkips, runKernel<ClassicTracer<kNoSkips>, kNoSkips>},
};

}  // namespace

std::span<const Kernel> allKernels() { return kKernels; }

const Kernel& chooseKernel(const RenderScene& scene, Features wanted) {
    const Kernel* best = nullptr;
    for (const Kernel& kernel : kKernels)
        if (kernel.integrator == scene.settings.integrator && ((scene.features | wanted) & ~kernel.features) == 0 &&
            (!best || std::popcount(kernel.features) < std::popcount(best->features)))
            best = &kernel;
    GLINT_CHECK(best != nullptr);
    return *best;
}

std::string kernelName(const RenderScene& scene) { return std::string(chooseKernel(scene).name); }

}  // namespace glint
