// Classic pictures without noise spend their samples at edges.
#include <gtest/gtest.h>

#include "tests/support/scenes.h"
#include "tracer/render/edge_plan.h"
#include "tracer/render/picture_error.h"

namespace glint {
namespace {

using test::SceneBuilder;

constexpr int kWidth = 64, kHeight = 48;

/// Mirror, matt and dim things under point lights.
SceneBuilder pictureWithEdges() {
    SceneBuilder b;
    b.object(Plane{}, b.material(Diffuse{Color{0.5, 0.5, 0.5}}));
    b.object(Sphere{0.8}, b.material(Mirror{Color{0.9, 0.9, 0.9}}), {-1, 0.8, 0});
    b.object(Box{{1, 1, 1}}, b.material(Diffuse{Color{0.7, 0.2, 0.1}}), {1.2, 0.5, 0});
    b.pointLight({3, 4, 3}, {60, 60, 60});
    b.pointLight({-4, 5, 1}, {40, 40, 40});
    b.scene().environment.color = {0.3, 0.4, 0.5};
    b.scene().render.integrator = Integrator::Classic;
    b.scene().render.maxDepth = 4;
    b.camera({0, 2, 6}, {0, 0.6, 0}, 40);
    b.film(kWidth, kHeight, 64);
    return b;
}

/// A crop of the whole picture has the same samples in every pixel.
Rendering uniform(const SceneBuilder& b) { return render(b.compile(), {.threads = 2, .crop = PixelRect{0, 0, kWidth, kHeight}}); }

TEST(EdgePlan, TakesAThirdOfTheSamplesForNearlyTheSamePicture) {
    SceneBuilder b = pictureWithEdges();
    ASSERT_TRUE(isPiecewiseSmooth(*b.compile()));
    const Rendering adaptive = b.render(), all = uniform(b);
    EXPECT_LT(static_cast<double>(adaptive.rays.primary), static_cast<double>(all.rays.primary) / 3);
    b.film(kWidth, kHeight, 1024);
    const Rendering many = uniform(b);
    const Reference reference{many.beauty, std::vector<float>(many.beauty.rgb.size())};
    EXPECT_LT(pictureErrors(adaptive.beauty, reference).relMse, 1.5 * pictureErrors(all.beauty, reference).relMse);
}

TEST(EdgePlan, DoesNotDependOnThreads) {
    const SceneBuilder b = pictureWithEdges();
    const Rendering one = b.render(1), three = b.render(3);
    EXPECT_EQ(one.beauty.rgb, three.beauty.rgb);
    EXPECT_EQ(one.rays.primary, three.rays.primary);
    EXPECT_EQ(one.spp, 64);
}

TEST(EdgePlan, IsNotForPicturesWithNoise) {
    SceneBuilder lamp = pictureWithEdges();
    lamp.object(Sphere{0.4}, {}, {0, 4, 0}, {5, 5, 5});
    EXPECT_FALSE(isPiecewiseSmooth(*lamp.compile()));
    SceneBuilder path = pictureWithEdges();
    path.scene().render.integrator = Integrator::Path;
    EXPECT_FALSE(isPiecewiseSmooth(*path.compile()));
}

TEST(EdgePlan, GoesOnWhereSamplesTookAChance) {
    Film film(4, 1);
    for (int x = 0; x < 4; ++x)
        for (int i = 0; i < 4; ++i) film.add(x, 0, Rgb(1.0f), {}, 0);
    const std::vector<std::uint32_t> goals = edgeGoals(film, {0, 0, 4, 1}, {0, 1, 0, 0}, 64);
    EXPECT_EQ(goals, (std::vector<std::uint32_t>{4, 8, 4, 4}));
}

}  // namespace
}  // namespace glint
