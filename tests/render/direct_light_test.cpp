// Direct light against closed forms: a diffuse plane under a point light, a ball and a rectangle,
// in both integrators.
#include <gtest/gtest.h>

#include "tests/support/scenes.h"

namespace glint {
namespace {

using test::SceneBuilder;

constexpr double kAlbedo = 0.6;

/// A floor seen from so near straight above its middle that the picture shows one point.
SceneBuilder floorSeenAtOnePoint(Integrator integrator) {
    SceneBuilder b;
    b.object(Plane{}, b.material(Diffuse{Color{kAlbedo, kAlbedo, kAlbedo}}));
    b.camera({0, 0.1, 0}, {0, 0, 0}, 0.01);
    b.scene().render.integrator = integrator;
    b.scene().render.maxDepth = 1;
    return b;
}

class DirectLight : public testing::TestWithParam<Integrator> {};

TEST_P(DirectLight, OfAPointFollowsCosineOverDistanceSquared) {
    SceneBuilder b = floorSeenAtOnePoint(GetParam());
    b.film(4, 4, 2);
    b.pointLight({1.5, 2, 0}, {7, 7, 7});
    const double d2 = 1.5 * 1.5 + 2 * 2, cosine = 2 / std::sqrt(d2);
    const Image image = b.render().beauty;
    // The picture shows a patch of 1.7e-4 m, over which the light hardly changes.
    EXPECT_NEAR(test::estimateMean(image).mean, kAlbedo / kPi * 7 * cosine / d2, 1e-5);
}

TEST_P(DirectLight, OfABallIsTheSolidAngleFormula) {
    for (const double radius : {0.01, 0.5, 1.9}) {
        SceneBuilder b = floorSeenAtOnePoint(GetParam());
        b.film(16, 16, 256);
        b.object(Sphere{radius}, {}, {1, 2, 0.5}, {5, 5, 5});
        const double d2 = 1 + 4 + 0.25, cosine = 2 / std::sqrt(d2);
        test::expectMean(b.render().beauty, kAlbedo * 5 * radius * radius / d2 * cosine,
                         "radius " + std::to_string(radius));
    }
}

/// Irradiance from a rectangle parallel to the receiver, corner above it: the classical form factor
/// of a corner.
double cornerFormFactor(double a, double b, double h) {
    const double x = a / h, y = b / h, sx = std::sqrt(1 + x * x), sy = std::sqrt(1 + y * y);
    return (x / sx * std::atan(y / sx) + y / sy * std::atan(x / sy)) / (2 * kPi);
}

TEST_P(DirectLight, OfARectangleIsLambertsFormula) {
    SceneBuilder b = floorSeenAtOnePoint(GetParam());
    b.film(16, 16, 256);
    const ObjectId id = b.object(Quad{{2, 3}}, {}, {0, 1.5, 0}, {4, 4, 4});
    Object lamp = b.scene().objects.at(id);
    lamp.transform.rotateDegrees = {180, 0, 0};  // Facing down.
    b.scene().objects.set(id, lamp);
    b.camera({0, 0.1, 0}, {0, 0, 0}, 0.01);
    test::expectMean(b.render().beauty, kAlbedo * 4 * 4 * cornerFormFactor(1, 1.5, 1.5),
                     "rectangle");
}

TEST_P(DirectLight, FromTheBackOfARectangleIsNone) {
    SceneBuilder b = floorSeenAtOnePoint(GetParam());
    b.object(Quad{{2, 3}}, {}, {0, 1.5, 0}, {4, 4, 4});
    EXPECT_EQ(test::estimateMean(b.render().beauty).mean, 0);
}

TEST_P(DirectLight, HalfBehindAnEdgeIsHalf) {
    SceneBuilder b = floorSeenAtOnePoint(GetParam());
    b.film(16, 16, 1024);
    b.object(Sphere{0.5}, {}, {0, 3, 0}, {5, 5, 5});
    // A black box covers the half x > 0 of the ball's cone.
    b.object(Box{{2, 0.1, 2}}, {}, {1, 1.5, 0});
    test::expectMean(b.render().beauty, 0.5 * kAlbedo * 5 * 0.25 / 9, "half shadow");
}

INSTANTIATE_TEST_SUITE_P(Both, DirectLight, testing::Values(Integrator::Path, Integrator::Classic),
                         [](const auto& tested) {
                             return tested.param == Integrator::Path ? "Path" : "Classic";
                         });

/// More lights than are all sampled at a first surface: one is chosen, whatever its kind, and the
/// picture is the sum of them all.
TEST(OneOfManyLights, IsChosenSoThatTheyAddUp) {
    SceneBuilder b = floorSeenAtOnePoint(Integrator::Path);
    b.film(32, 32, 2048);
    const auto pointLight = [](double intensity, const DVec3& at) {
        return kAlbedo / kPi * intensity * at.y / std::pow(glm::length(at), 3);
    };
    double exact = 0;
    for (const DVec3& at : {DVec3(1, 2, 0), DVec3(-1, 1.5, 1)}) {
        b.pointLight(at, {3, 3, 3});
        exact += pointLight(3, at);
    }
    // A spot that the point lies in, one that it does not.
    b.scene().lights.add({"In", SpotLight{{0.5, 3, -1}, {0.2, 0, 0}, {8, 8, 8}, 30, 0}, true, ""});
    exact += pointLight(8, {0.5, 3, -1});
    b.scene().lights.add(
        {"Beside", SpotLight{{0.5, 3, -1}, {4, 0, 0}, {50, 50, 50}, 30, 0.15}, true, ""});
    b.object(Sphere{0.5}, {}, {-2, 2, -2}, {5, 5, 5});
    exact += kAlbedo * 5 * 0.25 / 12 * 2 / std::sqrt(12);
    // A rectangle that faces the floor, one that does not.
    const ObjectId down = b.object(Quad{{2, 3}}, {}, {0, 6, 0}, {20, 20, 20});
    b.object(Quad{{1, 1}}, {}, {0, 1.5, -5}, {20, 20, 20});
    Object lamp = b.scene().objects.at(down);
    lamp.transform.rotateDegrees = {180, 0, 0};
    b.scene().objects.set(down, lamp);
    exact += kAlbedo * 20 * 4 * cornerFormFactor(1, 1.5, 6);
    test::expectMean(b.render().beauty, exact, "seven lights");
}

}  // namespace
}  // namespace glint
