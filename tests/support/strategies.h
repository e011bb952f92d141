// Tracing a scene with other weights and efforts than the built kernels use.
#pragma once

#include <vector>

#include "tests/support/scenes.h"
#include "tests/support/temp_folder.h"
#include "tests/support/ztest.h"
#include "tracer/render/kernel.h"
#include "tracer/render/path.h"

namespace glint::test {

// A15: other ways to share a light's contribution between the two ways to it.
struct LightOnly {
    static double lightWeight(double, double) { return 1; }
    static double bsdfWeight(double, double light) { return light > 0 ? 0 : 1; }
};
struct BsdfOnly {
    static double lightWeight(double, double bsdf) { return bsdf > 0 ? 0 : 1; }
    static double bsdfWeight(double, double) { return 1; }
};
/// The wrong twin: what each of the two ways brings counts whole.
struct BothWhole {
    static double lightWeight(double, double) { return 1; }
    static double bsdfWeight(double, double) { return 1; }
};

/// Saves a sky of 64 x 32 texels that is dim but in the texels from `first` to `last`, and answers
/// with the file.
inline std::string saveSky(const TempFolder& folder, const glm::ivec2& first,
                           const glm::ivec2& last, float radiance) {
    Image sky{64, 32, {}};
    for (int y = 0; y < sky.height; ++y)
        for (int x = 0; x < sky.width; ++x)
            for (int c = 0; c < 3; ++c)
                sky.rgb.push_back(
                    x >= first.x && x <= last.x && y >= first.y && y <= last.y ? radiance : 0.1f);
    const auto file = folder / "sky.exr";
    EXPECT_TRUE(saveLinear(file, sky, {}));
    return file.string();
}

/// Every pixel's mean (red) by another tracer; pixel by pixel the same random numbers for all.
template <class Heuristic, class Effort = UsualEffort>
std::vector<double> pixelMeans(const std::shared_ptr<const RenderScene>& scene, int samples) {
    KernelState state{*scene, {}, {}, false};
    const int width = scene->film.width, pixels = width * scene->film.height;
    std::vector<double> means;
    for (int i = 0; i < pixels; ++i) {
        double sum = 0;
        for (int s = 0; s < samples; ++s) {
            const Sampler sampler =
                samplerFor(*scene, i % width, i / width, static_cast<std::uint32_t>(s));
            PathTracer<kAllFeatures, Heuristic, Effort> tracer(state, sampler);
            sum += static_cast<double>(tracer
                                           .radiance(cameraRay<kAllFeatures>(
                                               *scene, sampler, i % width, i / width, state.work))
                                           .x);
        }
        means.push_back(sum / samples);
    }
    return means;
}

/// Mean of numbers that share one expected value, and its standard error.
inline Estimate estimateOf(const std::vector<double>& values) {
    RunningMoments moments;
    for (const double v : values) moments.add(v);
    return {moments.mean(), std::sqrt(moments.varianceOfMean())};
}

/// Mean difference of two pictures in units of its own standard error, from the differences pixel
/// by pixel.
struct Deviation {
    double sigmas = 0,
           relativeSigma = 0;  ///< relativeSigma: the standard error over the picture's mean
};
inline Deviation deviationOf(const std::vector<double>& a, const std::vector<double>& b) {
    std::vector<double> difference;
    for (std::size_t i = 0; i < a.size(); ++i) difference.push_back(b[i] - a[i]);
    const Estimate e = estimateOf(difference);
    return {std::abs(e.mean) / e.sigma, e.sigma / estimateOf(a).mean};
}

}  // namespace glint::test
