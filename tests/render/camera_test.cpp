// The camera against closed forms: blur by a thin lens, its focus, and the weights of the pixel
// filters.
#include <gtest/gtest.h>

#include "tests/support/scenes.h"

namespace glint {
namespace {

using test::SceneBuilder;

constexpr double kAperture = 0.2, kFocus = 4, kEmission = 3;

/// A camera at the origin that looks along -z through a lens, and a small glowing disc that faces
/// it at the given distance.
SceneBuilder discBehindLens(double radius, const DVec3& at, Projection projection) {
    SceneBuilder b;
    const ObjectId id = b.object(Disk{radius}, {}, at, {kEmission, kEmission, kEmission});
    Object disc = b.scene().objects.at(id);
    disc.transform.rotateDegrees = {90, 0, 0};
    b.scene().objects.set(id, disc);
    b.camera({0, 0, 0}, {0, 0, -1}, 0.001);
    b.film(16, 16, 512);
    Camera& camera = b.scene().camera;
    camera.projection = projection;
    camera.orthoHeight = 1e-4;
    camera.apertureRadius = kAperture;
    camera.focusDistance = kFocus;
    return b;
}

class Lens : public testing::TestWithParam<Projection> {};

/// Rays through one point of the focal plane cross the disc's plane in a picture of the lens,
/// scaled by |1 - d / f|; the disc covers its share of that.
TEST_P(Lens, BlursADiscOverItsCircleOfConfusion) {
    constexpr double kShare = 0.8;  // of the circle's radius
    for (const double distance : {2.5, 3.2, 5.0, 9.0}) {
        const double spread = kAperture * std::abs(1 - distance / kFocus),
                     exact = kEmission * kShare * kShare;
        SceneBuilder b = discBehindLens(kShare * spread, {0, 0, -distance}, GetParam());
        test::expectMean(b.render().beauty, exact, "disc at " + std::to_string(distance));
        b.scene().camera.focusDistance = 1.02 * kFocus;
        EXPECT_FALSE(test::meanIs(b.render().beauty, exact)) << "the wrong twin: focus 2 % too far";
    }
}

TEST_P(Lens, TheCircleOfConfusionHasASharpEdge) {
    // Seen along the axis at distance d, the circle's radius there is the spread; a disc just
    // inside it shows, one just outside not.
    constexpr double kRadius = 0.001, kDistance = 6;
    const double spread = kAperture * std::abs(1 - kDistance / kFocus);
    const auto meanAt = [&](double x) {
        return test::estimateMean(
                   discBehindLens(kRadius, {x, 0, -kDistance}, GetParam()).render().beauty)
            .mean;
    };
    EXPECT_GT(meanAt(spread - 2 * kRadius), 0);
    EXPECT_EQ(meanAt(spread + 2 * kRadius), 0);
}

/// Also off the axis: the focus is a distance along it.
TEST_P(Lens, WhatLiesInTheFocalPlaneIsSharp) {
    constexpr int kPixels = 140;
    constexpr double kHeight = 3.5, kPixel = kHeight / kPixels;  // of the film, in the focal plane
    for (const int column : {70, 136}) {
        SceneBuilder b = discBehindLens(
            0.005, {(column + 0.5) * kPixel - kHeight / 2, kPixel / 2, -kFocus}, GetParam());
        b.scene().camera.verticalFovDegrees = 2 * std::atan(kHeight / 2 / kFocus) * 180 / kPi;
        b.scene().camera.orthoHeight = kHeight;
        b.film(kPixels, kPixels, 16);
        b.scene().film.filterRadius = 1e-3;
        const int row = kPixels / 2 - 1;
        EXPECT_NEAR(test::pixelAt(b.render().beauty, column, row).x, kEmission, 1e-5) << column;
        b.scene().camera.focusDistance = 1.05 * kFocus;  // The wrong twin.
        EXPECT_LT(test::pixelAt(b.render().beauty, column, row).x,
                  0.99f * static_cast<float>(kEmission))
            << column;
    }
}

INSTANTIATE_TEST_SUITE_P(Camera, Lens,
                         testing::Values(Projection::Perspective, Projection::Orthographic),
                         [](const auto& tested) {
                             return tested.param == Projection::Perspective ? "Perspective"
                                                                            : "Orthographic";
                         });

TEST(Focus, IsAtTheTargetUnlessSaid) {
    SceneBuilder b = discBehindLens(0.001, {0, 0, -kFocus}, Projection::Perspective);
    b.scene().camera.focusDistance.reset();
    b.scene().camera.target = {0, 0, -kFocus};
    for (const float v : b.render().beauty.rgb) ASSERT_NEAR(v, kEmission, 1e-5);
}

/// The share of a filter's weight below x, in units of its radius.
double weightBelow(Filter filter, double x) {
    if (x <= -1) return 0;
    if (x >= 1) return 1;
    switch (filter) {
        case Filter::Box:
            return 0.5 + 0.5 * x;
        case Filter::Tent:
            return x < 0 ? 0.5 * (1 + x) * (1 + x) : 1 - 0.5 * (1 - x) * (1 - x);
        case Filter::BlackmanHarris:
            break;
    }
    constexpr double a0 = 0.35875, a1 = 0.48829, a2 = 0.14128, a3 = 0.01168;
    return 0.5 + (a0 * x + a1 / kPi * std::sin(kPi * x) + a2 / (2 * kPi) * std::sin(2 * kPi * x) +
                  a3 / (3 * kPi) * std::sin(3 * kPi * x)) /
                     (2 * a0);
}

class PixelFilters : public testing::TestWithParam<Filter> {};

/// A glowing half plane: each column shows the filter's weight on its side of the edge.
TEST_P(PixelFilters, ShowAnEdgeAsTheirIntegral) {
    constexpr int kWidth = 12, kHeight = 12, kSamples = 1024;
    constexpr double kEdge = 6.3, kRadius = 2.7;  // pixels
    SceneBuilder b;
    b.object(Box{{100, 100, 1}}, {}, {50 + kEdge, 0, -10}, {1, 1, 1});
    b.camera({kWidth / 2.0, 0, 0}, {kWidth / 2.0, 0, -1}, 40);
    b.scene().camera.projection = Projection::Orthographic;
    b.scene().camera.orthoHeight = kHeight;
    b.film(kWidth, kHeight, kSamples);
    b.scene().film.filter = GetParam();
    b.scene().film.filterRadius = kRadius;
    const Image image = b.render().beauty;
    // Each half of the samples is even over the filter: no count along it is off by more than one.
    constexpr double kBound = 2.0 / (kSamples / 2);
    double right = 0, wrong = 0;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const double found = static_cast<double>(test::pixelAt(image, x, y).x),
                         place = x + 0.5 - kEdge;
            right = std::max(right, std::abs(found - weightBelow(GetParam(), place / kRadius)));
            wrong = std::max(wrong,
                             std::abs(found - weightBelow(GetParam(), place / (1.05 * kRadius))));
        }
    EXPECT_LE(right, kBound);
    EXPECT_GT(wrong, kBound) << "the wrong twin: a radius 5 % too large";
}

INSTANTIATE_TEST_SUITE_P(Film, PixelFilters,
                         testing::Values(Filter::Box, Filter::Tent, Filter::BlackmanHarris),
                         [](const auto& tested) {
                             return tested.param == Filter::Box    ? "Box"
                                    : tested.param == Filter::Tent ? "Tent"
                                                                   : "BlackmanHarris";
                         });

}  // namespace
}  // namespace glint
