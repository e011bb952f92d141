// The picture's error figure, and the stop rule that goes by it.
#include <gtest/gtest.h>

#include "tests/support/scenes.h"
#include "tracer/render/tile_error.h"

namespace glint {
namespace {

using test::SceneBuilder;

/// One point in the half shadow of a ball lamp: every pixel has the same true value, which half the samples miss.
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

TEST(ErrorRule, NeedsSixteenSamples) {
    EXPECT_FALSE(meetsErrorRule(0, 15, 1));
    EXPECT_TRUE(meetsErrorRule(0, 16, 1));
    EXPECT_FALSE(meetsErrorRule(0.011, 100, 1));
    EXPECT_FALSE(meetsErrorRule(0, 100, 0)) << "no rule was set";
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
