// Pictures of `classic` told by their outlines: against closed forms and pictures of many samples.
#include "tracer/render/outlines.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/scenes.h"
#include "tests/support/temp_folder.h"
#include "tracer/io/image_file.h"

namespace glint {
namespace {

using test::SceneBuilder;

/// Mirrors, shadows and faces, lit by points.
SceneBuilder room() {
    SceneBuilder b;
    const MaterialId grey = b.material(Diffuse{Color{0.6, 0.6, 0.5}}),
                     mirror = b.material(Mirror{});
    b.object(Plane{}, grey);
    b.object(Sphere{1}, mirror, {-1.1, 1, 0});
    b.object(Box{{1, 1, 1}}, b.material(Diffuse{Color{0.8, 0.2, 0.1}}), {1, 0.5, 0.5});
    b.object(Cylinder{0.4, 1}, grey, {0.2, 0.5, 1.6});
    b.pointLight({2, 4, 2}, {20, 20, 20});
    b.pointLight({-3, 5, 3}, {15, 10, 5});
    b.scene().environment.color = Color{0.2, 0.3, 0.4};
    b.camera({0, 2.5, 6}, {0, 0.6, 0}, 40);
    b.film(96, 72, 256);
    b.scene().render.integrator = Integrator::Classic;
    return b;
}

/// The room with glass, of which most ways are dim.
SceneBuilder glassRoom() {
    SceneBuilder b = room();
    const MaterialId glass = b.material(Glass{});
    b.object(Sphere{0.6}, glass, {0.9, 1.6, 1.2});
    b.object(Box{{0.7, 0.7, 0.7}}, glass, {-0.3, 0.4, 2.2});
    return b;
}

/// Root mean square difference of the luminance over its mean.
double differenceOf(const Image& image, const Image& exact) {
    double squares = 0, light = 0;
    for (int y = 0; y < exact.height; ++y)
        for (int x = 0; x < exact.width; ++x) {
            const double is = static_cast<double>(luminance(test::pixelAt(image, x, y))),
                         should = static_cast<double>(luminance(test::pixelAt(exact, x, y)));
            squares += (is - should) * (is - should);
            light += should;
        }
    const double pixels = static_cast<double>(exact.width) * exact.height;
    return std::sqrt(squares / pixels) / (light / pixels);
}

TEST(Outlines, TheErrorIsWhatIsAskedForByFewRays) {
    SceneBuilder b = room();
    b.scene().render.spp = 512;
    const Image exact = b.render().beauty;
    for (const auto& [percent, rays] : {std::pair{8.0, 2.0}, {2.0, 5.0}, {0.5, 12.0}}) {
        b.scene().render.errorPercent = percent;
        const Rendering told = b.render();
        EXPECT_LE(100 * told.error, percent);
        EXPECT_LT(100 * differenceOf(told.beauty, exact), 1.2 * percent);
        EXPECT_LT(differenceOf(told.beauty, exact), 2 * told.error) << percent << " %";
        EXPECT_LT(static_cast<double>(told.rays.primary), rays * 96 * 72) << percent << " %";
    }
}

/// Of a black ball before a white sky the camera sees a disc.
TEST(Outlines, TheAreaOfADiscIsExact) {
    SceneBuilder b;
    b.object(Sphere{1}, b.material(Diffuse{Color{0, 0, 0}}));
    b.scene().environment.color = Color{1, 1, 1};
    b.scene().camera.projection = Projection::Orthographic;
    b.scene().camera.orthoHeight = 4;
    b.camera({0.013, 0.007, 5}, {0.013, 0.007, 0}, 40);
    b.scene().render.integrator = Integrator::Classic;
    b.film(40, 40, 256);
    b.scene().render.errorPercent = 0.02;
    const Rendering told = b.render();
    double sum = 0;
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 40; ++x) sum += static_cast<double>(test::pixelAt(told.beauty, x, y).x);
    EXPECT_NEAR(16 * (1 - sum / 1600), kPi, 2e-4 * kPi);
    EXPECT_LT(told.rays.primary, std::uint64_t{25} * 1600);
}

TEST(Outlines, AThinLineIsFollowedThroughAllPixels) {
    // A bar of a fifth of a pixel, seen by one middle in five.
    SceneBuilder b;
    b.object(Box{{100, 0.02, 0.02}}, b.material(Diffuse{Color{0, 0, 0}}));
    b.scene().environment.color = Color{1, 1, 1};
    b.scene().camera.projection = Projection::Orthographic;
    b.scene().camera.orthoHeight = 4;
    b.camera({0, 0, 5}, {0, 0, 0}, 40);
    b.scene().camera.up = {0.1, 1, 0};
    b.film(40, 40, 256);
    b.scene().render.integrator = Integrator::Classic;
    b.scene().render.errorPercent = 0.3;
    const Image image = b.render().beauty;
    for (int x = 2; x < 38; ++x) {
        double dark = 0;
        for (int y = 0; y < 40; ++y) dark += 1 - static_cast<double>(test::pixelAt(image, x, y).x);
        EXPECT_NEAR(dark, 0.2 * std::sqrt(1.01), 0.05) << x;
    }
}

/// A torus lies before itself: outlines between its parts are seen too.
TEST(Outlines, ATorusBeforeItselfHasOutlines) {
    SceneBuilder b;
    b.object(Torus{1, 0.3}, b.material(Diffuse{Color{0.8, 0.8, 0.8}}));
    b.pointLight({3, 1, 4}, {30, 30, 30});
    b.camera({0, 1, 4}, {0, 0, 0}, 40);
    b.film(64, 48, 1024);
    b.scene().render.integrator = Integrator::Classic;
    const Image exact = b.render().beauty;
    b.scene().render.errorPercent = 1;
    const Rendering told = b.render();
    EXPECT_LT(100 * differenceOf(told.beauty, exact), 1);
    EXPECT_LT(static_cast<double>(told.rays.primary), 8.0 * 64 * 48);
}

TEST(Outlines, DimWaysOfGlassMakeLittleNoiseAndNoBias) {
    SceneBuilder b = glassRoom();
    b.scene().render.spp = 2048;
    const Image exact = b.render().beauty;
    b.scene().render.errorPercent = 1;
    double off = 0;
    constexpr int kSeeds = 6;
    for (int seed = 1; seed <= kSeeds; ++seed) {
        b.scene().render.seed = seed;
        const Rendering told = b.render();
        EXPECT_LT(100 * differenceOf(told.beauty, exact), 1.2);
        EXPECT_LT(static_cast<double>(told.rays.primary), 12.0 * 96 * 72);
        double sum = 0, should = 0;
        for (std::size_t i = 0; i < exact.rgb.size(); ++i) {
            EXPECT_GE(told.beauty.rgb[i], 0.0f);
            sum += static_cast<double>(told.beauty.rgb[i]);
            should += static_cast<double>(exact.rgb[i]);
        }
        off += (sum / should - 1) / kSeeds;
    }
    EXPECT_NEAR(off, 0, 5e-4);
}

TEST(Outlines, ThreadsKernelsAndRepetitionDoNotMatter) {
    SceneBuilder b = glassRoom();
    b.scene().render.transparentShadows = true;
    b.scene().render.errorPercent = 0.5;
    const auto scene = b.compile();
    const Image one = render(scene, {.threads = 1}).beauty;
    EXPECT_EQ(render(scene, {.threads = 3}).beauty.rgb, one.rgb);
    EXPECT_EQ(render(scene, {.threads = 2, .kernel = KernelChoice::NoSkips}).beauty.rgb, one.rgb);
    EXPECT_EQ(render(scene, {.threads = 2, .kernel = KernelChoice::Full}).beauty.rgb, one.rgb);
}

TEST(Outlines, ALightWithASizeALensAndPathsAreForSamples) {
    SceneBuilder b = room();
    EXPECT_TRUE(Outlines::suit(*b.compile()));
    b.scene().render.integrator = Integrator::Path;
    EXPECT_FALSE(Outlines::suit(*b.compile()));
    b.scene().render.integrator = Integrator::Classic;
    b.scene().camera.apertureRadius = 0.1;
    EXPECT_FALSE(Outlines::suit(*b.compile()));
    b.scene().camera.apertureRadius = 0;
    b.scene().film.filter = Filter::Tent;
    EXPECT_FALSE(Outlines::suit(*b.compile()));
    b.scene().film.filter = Filter::Box;
    EXPECT_TRUE(Outlines::suit(*b.compile()));
    b.object(Sphere{0.4}, {}, {0, 4, 1}, {20, 20, 20});
    EXPECT_FALSE(Outlines::suit(*b.compile()));
}

/// What few rays do not tell, here a picture in a mirror and behind, is left to samples; the error
/// holds all the same.
TEST(Outlines, PixelsThatSeeAPictureAreSampled) {
    SceneBuilder b = room();
    Image sky{64, 32, std::vector<float>(3 * 64 * 32)};
    for (std::size_t i = 0; i < sky.rgb.size(); ++i)
        sky.rgb[i] = 0.5f + 0.5f * std::sin(static_cast<float>(i));
    const test::TempFolder folder;
    ASSERT_TRUE(saveLinear(folder / "sky.exr", sky, {}));
    b.scene().environment = {.image = (folder / "sky.exr").string()};
    b.scene().render.errorPercent = 1;
    b.scene().render.spp = 256;
    const Rendering told = b.render();
    EXPECT_LE(100 * told.error, 1);
    EXPECT_FALSE(told.even);
    SceneBuilder all = b;
    all.scene().render.errorPercent = 0;
    EXPECT_LT(100 * differenceOf(told.beauty, all.render().beauty), 2);
}

}  // namespace
}  // namespace glint
