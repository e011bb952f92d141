// Films that do not fit into memory: rendered in bands of rows, with the same bits, or refused with
// a remedy.
#include <gtest/gtest.h>

#include "tests/support/scenes.h"
#include "tracer/render/bands.h"
#include "tracer/render/film.h"

namespace glint {
namespace {

test::SceneBuilder litScene(int width, int height) {
    test::SceneBuilder b;
    b.object(Plane{}, b.material(Diffuse{}));
    b.object(Sphere{1}, b.material(Metal{{}, 0.2}), {0, 1, 0});
    b.pointLight({2, 4, 3}, {20, 20, 20});
    b.scene().environment.color = Color{0.3, 0.4, 0.5};
    b.camera({0, 2, 6}, {0, 0.8, 0}, 40);
    b.scene().film.width = width, b.scene().film.height = height, b.scene().render.spp = 4;
    return b;
}
/// Memory for the picture and for the film of so many rows.
double bytesForRows(const RenderScene& scene, int rows) {
    const double pixels = static_cast<double>(scene.film.width) * scene.film.height;
    return 24 * pixels + static_cast<double>(Film::kBytesAPixel) * scene.film.width * rows + 1;
}

TEST(Bands, GiveTheBitsOfThePictureRenderedAtOnce) {
    const auto scene = litScene(50, 200).compile();
    const Rendering whole = render(scene, {.threads = 2});
    for (const std::optional<PixelRect>& crop :
         {std::optional<PixelRect>(), std::optional(PixelRect{7, 20, 30, 150})}) {
        double least = 0;
        int reports = 0, most = 0;
        RenderRequest request{.threads = 2, .crop = crop, .memory = bytesForRows(*scene, 64)};
        request.progress = [&](const RenderProgress& p) {
            EXPECT_GE(p.fraction, least);
            least = p.fraction;
            most = std::max(most, p.spp);
            ++reports;
        };
        ASSERT_LT(rowsAtOnce(*scene, request, request.memory).value(), crop ? crop->height : 200)
            << "must be in bands";
        const Rendering bands = render(scene, request);
        const Rendering atOnce = render(scene, {.threads = 2, .crop = crop});
        EXPECT_EQ(bands.beauty.rgb, atOnce.beauty.rgb);
        EXPECT_EQ(bands.rays.total(), atOnce.rays.total());
        EXPECT_EQ(bands.spp, 4);
        EXPECT_TRUE(bands.even);
        EXPECT_FALSE(bands.interrupted);
        EXPECT_NEAR(bands.error, atOnce.error, 1e-4 * atOnce.error);
        EXPECT_GT(reports, 2);
        EXPECT_EQ(most, 4);
        EXPECT_NEAR(least, 1, 1e-9);
    }
    EXPECT_EQ(whole.spp, 4);
}

TEST(Bands, AreForgottenWhereTheFilmFits) {
    const auto scene = litScene(50, 200).compile();
    EXPECT_EQ(rowsAtOnce(*scene, {}, 1e12).value(), 200);
    EXPECT_EQ(rowsAtOnce(*scene, {}, bytesForRows(*scene, 100)).value(), 96) << "whole tiles";
}

TEST(Bands, APictureThatCannotFitIsRefusedWithARemedy) {
    const auto huge = litScene(16384, 16384).compile();
    // The picture of 16k x 16k pixels and its planes take 6.4 GB, its film 20 GB more.
    const Result<int> rows = rowsAtOnce(*huge, {}, 8e9);
    ASSERT_TRUE(rows.ok());
    EXPECT_GT(rows.value(), 500);
    EXPECT_LT(rows.value(), 16384);
    const Result<int> tooSmall = rowsAtOnce(*huge, {}, 4e9);
    ASSERT_FALSE(tooSmall.ok());
    EXPECT_NE(
        tooSmall.error().text().find("16384 x 16384 pixels needs 7 GB of memory; 4 GB are free"),
        std::string::npos)
        << tooSmall.error().text();
    EXPECT_NE(tooSmall.error().remedy.find("smaller"), std::string::npos);
    // A region of it takes the memory of the region's film alone.
    EXPECT_EQ(rowsAtOnce(*huge, {.crop = PixelRect{8000, 8000, 100, 100}}, 7e9).value(), 100);

    auto byError = litScene(16384, 16384);
    byError.scene().render.errorPercent = 1;
    const Result<int> refused = rowsAtOnce(*byError.compile(), {}, 8e9);
    ASSERT_FALSE(refused.ok());
    EXPECT_NE(refused.error().remedy.find("by number of samples"), std::string::npos)
        << refused.error().text();
    const Result<int> layers = rowsAtOnce(*huge, {.layers = true}, 8e9);
    ASSERT_FALSE(layers.ok());
    EXPECT_NE(layers.error().remedy.find("without layers"), std::string::npos);
}

/// Stopped in the first band: the others are black and the picture says that not every pixel has a
/// sample.
TEST(Bands, AStopLeavesTheOtherBandsBlack) {
    const auto scene = litScene(50, 200).compile();
    std::atomic<bool> stop{false};
    RenderRequest request{.threads = 2, .stop = &stop, .memory = bytesForRows(*scene, 64)};
    request.progress = [&](const RenderProgress&) { stop = true; };
    const Rendering out = render(scene, request);
    EXPECT_TRUE(out.interrupted);
    EXPECT_FALSE(out.even);
    EXPECT_EQ(out.spp, 0);
    EXPECT_GT(out.rays.primary, 0u);
    EXPECT_EQ(test::pixelAt(out.beauty, 25, 190), Rgb(0.0f));
}

}  // namespace
}  // namespace glint
