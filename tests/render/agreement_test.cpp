// Different ways to the same picture agree: classic and path where their physics is the same, and light sampling, BSDF sampling
// and every combination of them.
#include <gtest/gtest.h>

#include "tests/support/scenes.h"
#include "tracer/render/kernel.h"
#include "tracer/render/path.h"

namespace glint {
namespace {

using test::SceneBuilder;

Color grey(double v) { return {v, v, v}; }

TEST(ClassicAndPath, AgreeOnMirrorsAndGlassOverEmittersAndEnvironment) {
    SceneBuilder b;
    b.object(Box{{20, 1, 20}}, b.material(Mirror{grey(0.8)}), {0, -0.5, 0});
    b.object(Sphere{1}, b.material(Glass{1.5, Color{0.3, 0.3, 0.3}}), {-1.1, 1, 0});
    b.object(Sphere{0.9}, b.material(Mirror{grey(0.9)}), {1.1, 0.9, 0});
    b.object(Sphere{0.5}, {}, {0, 2.5, -1}, grey(2));
    b.scene().environment.color = grey(0.5);
    b.camera({0, 2, 6}, {0, 0.8, 0}, 40);
    b.film(24, 20, 16);
    b.scene().film.filterRadius = 1e-9;
    constexpr int kSeeds = 24;
    const auto path = test::estimatePixels(b, kSeeds);
    b.scene().render.integrator = Integrator::Classic;
    const auto classic = test::estimatePixels(b, kSeeds);
    std::vector<test::PixelTest> tests;
    for (std::size_t i = 0; i < path.pixels.size(); ++i)
        tests.push_back({path.pixels[i].mean, std::hypot(path.pixels[i].sigma, classic.pixels[i].sigma), classic.pixels[i].mean});
    test::expectPixels(tests, kSeeds, 0, "classic against path");
}

TEST(ClassicAndPath, AgreeOnDirectLightAtDepthOne) {
    SceneBuilder b;
    b.object(Plane{}, b.material(Diffuse{grey(0.6)}));
    b.object(Sphere{1}, b.material(Phong{}), {-1.1, 1, 0});
    b.object(Box{{1, 1, 1}}, b.material(Translucent{}), {1.1, 0.5, 0});
    b.object(Sphere{0.5}, {}, {0, 3, 1}, grey(6));
    b.pointLight({2, 3, 2}, grey(9));
    b.camera({0, 2, 6}, {0, 0.8, 0}, 40);
    b.film(24, 20, 16);
    b.scene().film.filterRadius = 1e-9;
    b.scene().render.maxDepth = 1;
    constexpr int kSeeds = 24;
    const auto path = test::estimatePixels(b, kSeeds);
    b.scene().render.integrator = Integrator::Classic;
    const auto classic = test::estimatePixels(b, kSeeds);
    std::vector<test::PixelTest> tests;
    for (std::size_t i = 0; i < path.pixels.size(); ++i)
        tests.push_back({path.pixels[i].mean, std::hypot(path.pixels[i].sigma, classic.pixels[i].sigma), classic.pixels[i].mean});
    test::expectPixels(tests, kSeeds, 0, "classic against path");
}

// A15: other ways to share a light's contribution between the two ways to it.
struct LightOnly {
    static double lightWeight(double, double) { return 1; }
    static double bsdfWeight(double, double light) { return light > 0 ? 0 : 1; }
};
struct BsdfOnly {
    static double lightWeight(double, double bsdf) { return bsdf > 0 ? 0 : 1; }
    static double bsdfWeight(double, double) { return 1; }
};
struct PowerHeuristic {
    static double lightWeight(double light, double bsdf) { return light * light / (light * light + bsdf * bsdf); }
    static double bsdfWeight(double bsdf, double light) { return bsdf * bsdf / (light * light + bsdf * bsdf); }
};
/// Counts light twice where both ways lead to it: the wrong twin that the comparison must notice.
struct BothWhole {
    static double lightWeight(double, double) { return 1; }
    static double bsdfWeight(double, double) { return 1; }
};

template <class Heuristic>
test::Estimate meanWith(const std::shared_ptr<const RenderScene>& scene, int samples) {
    KernelState state{*scene, {}, {}, false};
    const int width = scene->film.width, pixels = width * scene->film.height;
    std::vector<double> means;
    for (int i = 0; i < pixels; ++i) {
        double sum = 0;
        for (int s = 0; s < samples; ++s) {
            const Sampler sampler = samplerFor(*scene, i % width, i / width, static_cast<std::uint32_t>(s));
            PathTracer<kAllFeatures, Heuristic> tracer(state, sampler);
            sum += tracer.radiance(cameraRay<kAllFeatures>(*scene, sampler, i % width, i / width)).x;
        }
        means.push_back(sum / samples);
    }
    double sum = 0, squares = 0;
    for (const double v : means) sum += v, squares += v * v;
    const double n = pixels, mean = sum / n;
    return {mean, std::sqrt(std::max(0.0, squares / n - mean * mean) / (n - 1))};
}

TEST(Strategies, AllGiveTheSameMean) {  // A15
    SceneBuilder b;
    b.object(Plane{}, b.material(Diffuse{grey(0.6)}));
    b.object(Sphere{1.2}, {}, {0.5, 2.5, 0}, grey(3));
    b.camera({0, 0.01, 0}, {0, 0, 0}, 0.1);  // One point, so that the spread over pixels is noise alone.
    b.film(48, 48, 1);
    const auto scene = b.compile();
    const int samples = 64;
    const test::Estimate balance = meanWith<BalanceHeuristic>(scene, samples);
    const auto expectSame = [&](const test::Estimate& other, const char* name) {
        EXPECT_LE(std::abs(other.mean - balance.mean), 4 * std::hypot(other.sigma, balance.sigma)) << name;
        EXPECT_LE(std::abs(other.mean - balance.mean), 4e-3 * balance.mean) << name;
    };
    expectSame(meanWith<LightOnly>(scene, samples), "light sampling alone");
    expectSame(meanWith<BsdfOnly>(scene, samples), "BSDF sampling alone");
    expectSame(meanWith<PowerHeuristic>(scene, samples), "power heuristic");
    EXPECT_GT(meanWith<BothWhole>(scene, samples).mean, 1.5 * balance.mean);
}

}  // namespace
}  // namespace glint
