// The kernels that are built: each integrator for a few sets of features.
#include "tracer/render/classic.h"
#include "tracer/render/kernel.h"
#include "tracer/render/path.h"

#include <bit>

#include "tracer/compile/compiler.h"

namespace glint {

namespace {

template <class Tracer>
Rgb traceRay(KernelState& state, const Ray& cameraRay, const Sampler& sampler) {
    const RenderScene& scene = state.scene;
    state.cancelled = false;
    state.materials = 0;
    state.trail = 0;
    state.doubt = 0;
    for (int i = 0; i < scene.cameraMedia.size(); ++i)
        state.materials |= scene.materials[scene.shapes[scene.cameraMedia[i]].material].bit;
    if (state.groups) *state.groups = {};
    Rgb value = Tracer(state, sampler).radiance(cameraRay);
    if (const auto limit = static_cast<float>(scene.settings.clamp); limit > 0)
        if (const float size = maxComponent(value); size > limit) value *= limit / size;
    return value;
}

template <class Tracer, Features F>
Rgb runKernel(KernelState& state, int x, int y, std::uint32_t sample) {
    const Sampler sampler = samplerFor(state.scene, x, y, sample);
    return traceRay<Tracer>(state, cameraRay<F>(state.scene, sampler, x, y, state.work), sampler);
}

template <Features F>
constexpr Kernel path(std::string_view name) {
    return {name, Integrator::Path, F, runKernel<PathTracer<F>, F>};
}
template <Features F>
constexpr Kernel classic(std::string_view name) {
    return {name, Integrator::Classic, F, runKernel<ClassicTracer<F>, F>,
            traceRay<ClassicTracer<F>>};
}

constexpr Features bits(auto... features) { return (static_cast<Features>(features) | ...); }

constexpr Features kDiffuse = bits(Feature::Smooth, Feature::DeltaLights, Feature::AreaLights,
                                   Feature::Sky, Feature::SampledSky, Feature::Lens);
constexpr Features kMirrors = kDiffuse | bits(Feature::Delta);
constexpr Features kGlass = kMirrors | bits(Feature::Media);
constexpr Features kCaustics = kGlass | bits(Feature::Casters);
constexpr Features kRough = kDiffuse | bits(Feature::Rough);
constexpr Features kRoughGlass = kGlass | bits(Feature::Rough);
constexpr Features kRoughCaustics = kCaustics | bits(Feature::Rough);
constexpr Features kHighlights = kMirrors | bits(Feature::Rough, Feature::Highlights);
constexpr Features kLayers = kAllFeatures | bits(Feature::Layers);
constexpr Features kNoSkips = kAllFeatures | bits(Feature::NoSkips);

constexpr std::array kKernels = {
    path<kDiffuse>("path: diffuse"),
    path<kMirrors | bits(Feature::Casters)>("path: mirrors"),
    path<kGlass>("path: glass"),
    path<kCaustics>("path: caustics"),
    path<kRough>("path: rough"),
    path<kRoughGlass>("path: rough, glass"),
    path<kRoughCaustics>("path: rough, caustics"),
    path<kHighlights>("path: highlights"),
    path<kAllFeatures>("path: all"),
    path<kLayers>("path: layers"),
    path<kNoSkips>("path: no skips"),
    classic<kMirrors>("classic: mirrors"),
    classic<kGlass>("classic: glass"),
    classic<kLayers>("classic: layers"),
    classic<kAllFeatures>("classic: all"),
    classic<kNoSkips>("classic: no skips"),
};

}  // namespace

std::span<const Kernel> allKernels() { return kKernels; }

const Kernel& chooseKernel(const RenderScene& scene, Features wanted) {
    const Kernel* best = nullptr;
    for (const Kernel& kernel : kKernels)
        if (kernel.integrator == scene.settings.integrator &&
            ((scene.features | wanted) & ~kernel.features) == 0 &&
            (!best || std::popcount(kernel.features) < std::popcount(best->features)))
            best = &kernel;
    GLINT_CHECK(best != nullptr);
    return *best;
}

std::string kernelName(const RenderScene& scene) { return std::string(chooseKernel(scene).name); }

}  // namespace glint
