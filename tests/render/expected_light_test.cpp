// What dim branches are expected to bring takes noise away and changes no mean.
#include "tracer/render/expected_light.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/support/scenes.h"
#include "tracer/render/kernel.h"

namespace glint {
namespace {

TEST(ExpectedLight, LearnsByOctantWhatBranchesBring) {
    ExpectedLight expected;
    const DVec3 up{0.1, 0.9, 0.2}, down{0.1, -0.9, 0.2};
    const Rgb light(3.0f, 2.0f, 1.0f), weight(0.5f, 0.25f, 0.0f);
    for (int i = 0; i < 200; ++i)
        expected.learn(up, weight, weight * (light - expected.towards(up)));
    EXPECT_NEAR(expected.towards(up).x, 3, 1e-3);
    EXPECT_NEAR(expected.towards(up).y, 2, 1e-3);
    EXPECT_EQ(expected.towards(up).z, 0.0f) << "a weight of 0 tells nothing";
    EXPECT_EQ(expected.towards(down), Rgb(0.0f));
    const float infinite = std::numeric_limits<float>::infinity();
    expected.learn(up, weight, {infinite, std::nanf(""), 1});
    EXPECT_NEAR(expected.towards(up).x, 3, 1e-3) << "what overflows tells nothing";
    EXPECT_NEAR(expected.towards(up).y, 2, 1e-3);
}

/// Mean and variance of the light along one ray into a ball of glass.
struct Moments {
    double mean = 0, variance = 0;
};
constexpr int kSamples = 40'000;
template <class Prepare>
Moments momentsOf(const RenderScene& scene, const Prepare& prepare) {
    KernelState state{.scene = scene};
    state.dim = 0.3f;  // Nearly all branches go on by chance.
    const RayFunction trace = chooseKernel(scene).trace;
    double sum = 0, squares = 0;
    for (std::uint32_t i = 0; i < kSamples; ++i) {
        prepare(state);
        const double light = static_cast<double>(
            luminance(trace(state, scene.camera.ray(16.3, 12.1), samplerFor(scene, 16, 12, i))));
        sum += light;
        squares += light * light;
    }
    const double mean = sum / kSamples;
    return {mean, squares / kSamples - mean * mean};
}

TEST(ExpectedLight, AnythingMayBeExpectedButWhatIsLearnedIsBest) {
    test::SceneBuilder b;
    b.object(Plane{}, b.material(Diffuse{Color{0.6, 0.5, 0.4}}));
    b.object(Sphere{1}, b.material(Glass{}), {0, 1, 0});
    b.pointLight({2, 5, 2}, {40, 40, 40});
    b.scene().environment.color = {0.8, 0.9, 1};
    b.scene().render.integrator = Integrator::Classic;
    b.camera({0, 2, 6}, {0, 1, 0}, 30);
    const auto scene = b.compile();
    const Moments plain = momentsOf(*scene, [](KernelState&) {});
    ExpectedLight learned;
    const Moments better =
        momentsOf(*scene, [&](KernelState& state) { state.expected = &learned; });
    ExpectedLight wrong;
    const Moments worse = momentsOf(*scene, [&](KernelState& state) {
        wrong = {};
        for (const double x : {-1.0, 1.0})
            for (const double y : {-1.0, 1.0})
                for (const double z : {-1.0, 1.0})
                    wrong.learn({x, y, z}, Rgb(1.0f), Rgb(80.0f, 0.0f, 160.0f));
        state.expected = &wrong;
    });
    const auto sigma = [](const Moments& m) { return std::sqrt(m.variance / kSamples); };
    EXPECT_NEAR(better.mean, plain.mean, 4 * (sigma(better) + sigma(plain)));
    EXPECT_NEAR(worse.mean, plain.mean, 4 * (sigma(worse) + sigma(plain)));
    EXPECT_LT(better.variance, 0.5 * plain.variance);
    EXPECT_GT(worse.variance, plain.variance);
}

}  // namespace
}  // namespace glint
