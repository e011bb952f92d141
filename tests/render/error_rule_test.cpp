// The picture's error figure, and the stop rule that goes by it.
#include <gtest/gtest.h>

#include "tests/support/scenes.h"
#include "tracer/render/stop_rule.h"
#include "tracer/render/tile_error.h"

namespace glint {
namespace {

using test::SceneBuilder;

/// One point in the half shadow of a ball lamp: every pixel has the same true value, which half the
/// samples miss.
SceneBuilder halfShadow() {
    SceneBuilder b;
    b.object(Plane{}, b.material(Diffuse{Color{0.5, 0.5, 0.5}}));
    b.object(Sphere{1}, {}, {0, 2, 0}, {4, 4, 4});
    b.object(Box{{2, 0.1, 2}}, {}, {1, 0.7, 0});
    b.camera({0, 0.01, 0}, {0, 0, 0}, 0.01);
    b.scene().film.width = b.scene().film.height = 64;
    return b;
}

TEST(ErrorRule, StopsWhereTheErrorIsWhatItSays) {
    SceneBuilder b = halfShadow();
    b.scene().render.spp = 100000;
    b.scene().render.errorPercent = 3;
    const Rendering rendering = b.render();
    EXPECT_LE(100 * rendering.error, 3);
    EXPECT_LT(rendering.spp, 4096);
    const test::Estimate e = test::estimateMean(rendering.beauty);
    const double found = e.sigma * std::sqrt(64.0 * 64 - 1) / e.mean;
    EXPECT_NEAR(rendering.error, found, 0.15 * found);
}

TEST(ErrorRule, NeedsEnoughSamplesToBeBelieved) {
    RenderSettings rules;
    rules.errorPercent = 1;
    const auto stops = [&](int samples, double error) {
        return isDone(rules, {1, static_cast<double>(samples), samples, error});
    };
    EXPECT_FALSE(stops(15, 0));
    EXPECT_TRUE(stops(16, 0));
    EXPECT_FALSE(stops(100, 0.011));
    rules.integrator = Integrator::Classic;
    EXPECT_FALSE(stops(1, 0));
    EXPECT_TRUE(stops(2, 0));
    rules.errorPercent = 0;
    EXPECT_FALSE(stops(100, 0)) << "no rule was set";
}

/// Without noise all error is at edges, and so are the samples: the same error for a fraction of
/// them.
TEST(ErrorRule, ClassicSamplesItsEdges) {
    SceneBuilder b;
    b.object(Plane{}, b.material(Diffuse{Color{0.6, 0.6, 0.6}}));
    b.object(Sphere{1}, b.material(Mirror{}), {0, 1, 0});
    b.pointLight({2, 3, 2}, Color{9, 9, 9});
    b.camera({0, 2, 6}, {0, 0.8, 0}, 40);
    b.film(96, 96, 1024);
    b.scene().film.filter = Filter::Box;
    b.scene().render.integrator = Integrator::Classic;
    const Image exact = b.render().beauty;
    const auto errorOf = [&](const Image& image) {
        double squares = 0;
        for (std::size_t i = 0; i < image.rgb.size(); ++i)
            squares +=
                std::pow(static_cast<double>(image.rgb[i]) - static_cast<double>(exact.rgb[i]), 2);
        return squares;
    };
    b.scene().render.seed = 2;
    b.scene().render.spp = 64;
    const Rendering even = b.render();
    b.scene().render.spp = 1024;
    b.scene().render.errorPercent = 100 * even.error;
    const Rendering edges = b.render();
    EXPECT_LE(edges.error, even.error);
    EXPECT_LT(static_cast<double>(edges.rays.primary),
              0.4 * static_cast<double>(even.rays.primary));
    EXPECT_LT(errorOf(edges.beauty), 1.5 * errorOf(even.beauty));
}

TEST(ErrorRule, WithoutOneAllSamplesAreTaken) {
    SceneBuilder b;
    b.scene().environment.color = Color{1, 1, 1};
    b.scene().render.spp = 40;
    const Rendering rendering = b.render();
    EXPECT_EQ(rendering.spp, 40);
    EXPECT_EQ(rendering.error, 0);
}

}  // namespace
}  // namespace glint
