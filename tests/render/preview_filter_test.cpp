// The preview filter: it takes most of the noise away, leaves what has none alone, and never mixes
// surfaces.
#include <gtest/gtest.h>

#include "tests/support/scenes.h"
#include "tracer/render/preview_filter.h"

namespace glint {
namespace {

using test::SceneBuilder;

Rendering filteredRender(const SceneBuilder& builder) {
    RenderRequest request;
    request.threads = 2;
    request.filter = true;
    return render(builder.compile(), request);
}

/// Mean over all values of the squared difference over the squared reference.
double relativeMse(const Image& image, const Image& reference) {
    double sum = 0;
    for (std::size_t i = 0; i < image.rgb.size(); ++i) {
        const double r = static_cast<double>(reference.rgb[i]),
                     d = static_cast<double>(image.rgb[i]) - r;
        sum += d * d / (r * r + 0.01);
    }
    return sum / static_cast<double>(image.rgb.size());
}

/// Two coloured balls on a floor in the light of a lamp and of the sky: soft shadows and light from
/// ball to floor.
SceneBuilder softShadows() {
    SceneBuilder b;
    b.object(Plane{}, b.material(Diffuse{}));
    Diffuse red;
    red.color = Color{0.8, 0.2, 0.1};
    b.object(Sphere{1}, b.material(red), {-1.1, 1, 0});
    b.object(Sphere{1}, b.material(Diffuse{}), {1.1, 1, 0});
    b.object(Sphere{0.6}, b.material(Diffuse{}), {2, 5, 3}, {20, 19, 18});
    b.scene().environment.color = Color{0.2, 0.25, 0.3};
    b.camera({0, 3, 8}, {0, 0.8, 0}, 40);
    b.scene().film.width = 240;
    b.scene().film.height = 135;
    b.scene().render.spp = 4;
    return b;
}

/// The same seen in a mirror and through glass.
SceneBuilder mirrorAndGlass() {
    SceneBuilder b = softShadows();
    b.object(Box{{6, 5, 0.2}}, b.material(Mirror{}), {0, 2.5, -3});
    b.object(Sphere{0.7}, b.material(Glass{}), {0, 0.7, 2});
    return b;
}

/// A closed room with a lamp: most light comes by way of the walls.
SceneBuilder room() {
    SceneBuilder b;
    b.object(Box{{6, 6, 6}}, b.material(Diffuse{}), {0, 3, 0});
    b.object(Sphere{0.5}, b.material(Diffuse{}), {0, 5, 0}, {10, 9, 8});
    b.object(Box{{1.5, 2, 1.5}}, b.material(Diffuse{}), {-1, 1, -0.5});
    b.camera({0, 3, 2.9}, {0, 2.5, -2}, 75);
    b.scene().film.width = 240;
    b.scene().film.height = 135;
    b.scene().render.spp = 4;
    return b;
}

TEST(PreviewFilter, LeavesAFifthOfTheErrorOfFourSamples) {
    constexpr int kReference = 32;
    for (SceneBuilder b : {softShadows(), mirrorAndGlass(), room()}) {
        const Rendering few = filteredRender(b);
        b.scene().render.spp = kReference;
        b.scene().render.seed = 7;
        const Image reference = b.render().beauty;
        const double raw = relativeMse(few.beauty, reference),
                     filtered = relativeMse(few.filtered, reference);
        // The reference's own noise is in both.
        const double noise = raw * 4 / (kReference + 4);
        EXPECT_LT(filtered - noise, (raw - noise) / 5) << raw << " " << filtered;
    }
}

TEST(PreviewFilter, LeavesThePictureItselfAlone) {
    const SceneBuilder b = softShadows();
    EXPECT_EQ(filteredRender(b).beauty.rgb, b.render().beauty.rgb);
}

TEST(PreviewFilter, ChangesNothingWhereThereIsNoNoise) {
    SceneBuilder b;
    b.object(Plane{}, b.material(Diffuse{}));
    b.object(Sphere{1}, b.material(Mirror{}), {0, 1, 0});
    b.pointLight({3, 4, 3}, {30, 30, 30});
    b.scene().environment.color = Color{0.1, 0.2, 0.3};
    b.camera({0, 2, 6}, {0, 0.8, 0}, 40);
    b.scene().film.width = 160;
    b.scene().film.height = 90;
    b.scene().film.filterRadius = 1e-6;  // every sample at the pixel's centre
    b.scene().render.integrator = Integrator::Classic;
    b.scene().render.spp = 2;
    const Rendering out = filteredRender(b);
    for (std::size_t i = 0; i < out.beauty.rgb.size(); ++i)
        ASSERT_NEAR(out.filtered.rgb[i], out.beauty.rgb[i], 2e-3f * out.beauty.rgb[i] + 1e-6f)
            << "value " << i;
}

TEST(PreviewFilter, WorksOnTheCropAlone) {
    SceneBuilder b = softShadows();
    RenderRequest request;
    request.threads = 2;
    request.filter = true;
    request.crop = PixelRect{40, 30, 100, 60};
    const Rendering out = render(b.compile(), request);
    double inside = 0;
    for (int y = 0; y < 135; ++y)
        for (int x = 0; x < 240; ++x) {
            const float value = out.filtered.rgb[static_cast<std::size_t>(3 * (y * 240 + x))];
            if (x >= 40 && x < 140 && y >= 30 && y < 90)
                inside += static_cast<double>(value);
            else
                ASSERT_EQ(value, 0.0f);
        }
    // Black from outside did not come in.
    const Rendering whole = filteredRender(b);
    double same = 0;
    for (int y = 30; y < 90; ++y)
        for (int x = 40; x < 140; ++x)
            same += static_cast<double>(
                whole.filtered.rgb[static_cast<std::size_t>(3 * (y * 240 + x))]);
    EXPECT_NEAR(inside, same, 0.01 * same);
}

TEST(GuideFilm, SeesThroughMirrorsAndGlass) {
    SceneBuilder b;
    Diffuse green;
    green.color = Color{0.1, 0.7, 0.2};
    b.object(Plane{}, b.material(green));
    const ObjectId ball = b.object(Sphere{1}, b.material(Mirror{}), {0, 1.2, 0});
    b.camera({0, 1.2, 5}, {0, 1.2, 0}, 10);
    b.film(32, 32, 1);
    const auto scene = b.compile();
    const GuideSample low =
        traceGuide(*scene, 16, 28, 0);  // the ball's lower half mirrors the floor
    EXPECT_EQ(low.object, ball.value);
    EXPECT_GT(low.albedo.x, 0.5f);
    EXPECT_LT(low.seenAlbedo.x, 0.2f);
    EXPECT_GT(low.seenNormal.y, 0.99f);
    EXPECT_GT(low.seenNearness, 0.0f);
    const GuideSample high = traceGuide(*scene, 16, 3, 0);  // and its upper one the sky
    EXPECT_EQ(high.seenNearness, 0.0f);
}

}  // namespace
}  // namespace glint
