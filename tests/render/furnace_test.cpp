// Scenes whose light is known everywhere in closed form: furnaces, closed rooms, concentric balls,
// mirrors in series.
#include <gtest/gtest.h>

#include "tests/support/scenes.h"

namespace glint {
namespace {

using test::grey;
using test::SceneBuilder;

/// A camera within a closed emissive shape, looking at its wall.
SceneBuilder insideOf(const Shape& shape, double albedo, double emission, const DVec3& from,
                      const DVec3& to) {
    SceneBuilder b;
    const ObjectId id =
        b.object(shape, b.material(Diffuse{grey(albedo)}), DVec3(0.0), grey(emission));
    Object wall = b.scene().objects.at(id);
    wall.twoSided = true;
    b.scene().objects.set(id, wall);
    b.camera(from, to, 60);
    b.film(32, 32, 512);
    b.scene().render.maxDepth = 1000;
    return b;
}

struct ClosedShape {
    const char* name;
    Shape shape;
    DVec3 from, to;
};
void PrintTo(const ClosedShape& c, std::ostream* out) { *out << c.name; }
class ClosedFurnace : public testing::TestWithParam<ClosedShape> {};

TEST_P(ClosedFurnace, GlowsAsEmissionOverOneMinusAlbedo) {  // A1
    const ClosedShape& c = GetParam();
    test::expectMean(insideOf(c.shape, 0.5, 0.8, c.from, c.to).render().beauty, 0.8 / (1 - 0.5),
                     c.name);
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, ClosedFurnace,
    testing::Values(ClosedShape{"Sphere", Sphere{2}, {0.3, 0.2, 0.1}, {1, 0.5, -1}},
                    ClosedShape{"Box", Box{{2, 3, 4}}, {0.3, 0.2, 0.1}, {1, 0.5, -1}},
                    ClosedShape{"Cylinder", Cylinder{1, 2}, {0.3, 0.2, 0.1}, {1, 0.5, -1}},
                    ClosedShape{"Cone", Cone{1, 2}, {0.1, -0.5, 0.1}, {1, 0.5, -1}},
                    ClosedShape{"Torus", Torus{1, 0.4}, {1, 0.1, 0}, {0.2, 0, 1}}),
    [](const auto& tested) { return std::string(tested.param.name); });

TEST(ClosedRoom, OfSixQuadsIsAFurnace) {  // A1
    SceneBuilder b;
    const MaterialId white = b.material(Diffuse{grey(0.5)});
    const DVec3 turns[6] = {{0, 0, 0},   {180, 0, 0}, {90, 0, 0},
                            {-90, 0, 0}, {0, 0, 90},  {0, 0, -90}};
    const DVec3 places[6] = {{0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}, {1, 0, 0}, {-1, 0, 0}};
    for (int i = 0; i < 6; ++i) {
        const ObjectId id = b.object(Quad{{2, 2}}, white, places[i], grey(0.8));
        Object wall = b.scene().objects.at(id);
        wall.transform.rotateDegrees = turns[i];
        b.scene().objects.set(id, wall);
    }
    b.camera({0.2, 0.1, 0.3}, {1, 0.5, -1}, 70);
    b.film(32, 32, 512);
    b.scene().render.maxDepth = 1000;
    test::expectMean(b.render().beauty, 1.6, "room");
}

/// A2: radiance of the wall of a closed ball with a point light of intensity I in its centre, all
/// bounces.
constexpr double kRadius = 1.5, kIntensity = 3, kAlbedo = 0.7;
double firstBounce() { return kAlbedo * kIntensity / (kPi * kRadius * kRadius); }

SceneBuilder lampInBall(Integrator integrator = Integrator::Path) {
    SceneBuilder b;
    b.object(Sphere{kRadius}, b.material(Diffuse{grey(kAlbedo)}));
    b.pointLight({0, 0, 0}, grey(kIntensity));
    b.camera({0.5, 0.2, 0.1}, {-1, 0.3, 1}, 60);
    b.film(32, 32, 256);
    b.scene().render.integrator = integrator;
    return b;
}

TEST(LampInBall, ShinesAsTheGeometricSeries) {  // A2
    SceneBuilder b = lampInBall();
    b.scene().render.maxDepth = 1000;
    test::expectMean(b.render().beauty, firstBounce() / (1 - kAlbedo), "all bounces");
}

TEST(LampInBall, CutAtADepthIsTheSeriesCut) {  // A3
    for (const int depth : {0, 1, 2, 5}) {
        SceneBuilder b = lampInBall();
        b.scene().render.maxDepth = depth;
        double exact = 0;
        for (int i = 0; i < depth; ++i) exact += firstBounce() * std::pow(kAlbedo, i);
        const Image image = b.render().beauty;
        if (depth == 0)
            EXPECT_EQ(test::estimateMean(image).mean, 0);
        else
            test::expectMean(image, exact, "depth " + std::to_string(depth));
    }
}

TEST(LampInBall, IsOneBounceInClassic) {
    SceneBuilder b = lampInBall(Integrator::Classic);
    b.film(8, 8, 4);
    EXPECT_NEAR(test::estimateMean(b.render().beauty).mean, firstBounce(), 2e-6 * firstBounce());
}

TEST(ConcentricBalls, ExchangeLightByTheirViewFactors) {  // A4
    const double r1 = 0.7, r2 = 2, e1 = 1.5, e2 = 0.3, a1 = 0.4, a2 = 0.6, f = r1 * r1 / (r2 * r2);
    const double b2 = (e2 + a2 * f * e1) / (1 - a2 * (1 - f + f * a1)), b1 = e1 + a1 * b2;
    SceneBuilder b;
    b.object(Sphere{r1}, b.material(Diffuse{grey(a1)}), {}, grey(e1));
    const ObjectId outer = b.object(Sphere{r2}, b.material(Diffuse{grey(a2)}), {}, grey(e2));
    Object wall = b.scene().objects.at(outer);
    wall.twoSided = true;
    b.scene().objects.set(outer, wall);
    b.film(32, 32, 1024);
    b.scene().render.maxDepth = 1000;
    b.camera({0, 0, 1.2}, {0, 0, 2}, 30);
    test::expectMean(b.render().beauty, b2, "outer wall");
    b.camera({0, 0, 1.2}, {0, 0, 0}, 20);
    test::expectMean(b.render().beauty, b1, "inner ball");
}

TEST(WhiteFurnace, HidesEverythingThatLosesNothing) {  // A5
    SceneBuilder b;
    const MaterialId white = b.material(Diffuse{grey(1)}), mirror = b.material(Mirror{grey(1)}),
                     glass = b.material(Glass{});
    const MaterialId sheet = b.material(Translucent{grey(0.3), grey(0.7)});
    b.object(Sphere{1}, white, {-2, 0, 0});
    b.object(Box{{1, 1, 1}}, mirror, {0, 0, 0});
    b.object(Sphere{0.8}, glass, {2, 0, 0});
    b.object(Torus{0.6, 0.2}, white, {0, 1.5, 0});
    b.object(Cone{0.5, 1}, glass, {-1, -1.4, 0});
    b.object(Cylinder{0.4, 1}, sheet, {1.2, -1.4, 0});
    b.object(Disk{0.6}, b.material(Mix{{white, false}, {{}, true}, 0.3}), {2.5, 1.5, 0});
    b.scene().environment.color = grey(1);
    b.camera({0, 0, 8}, {0, 0, 0}, 40);
    b.scene().render.maxDepth = 100000;
    b.film(48, 48, 64);
    test::expectMean(b.render().beauty, 1, "white furnace");
}

TEST(WhiteFurnace, HidesRoughGlassAndCoats) {  // A5
    SceneBuilder b;
    b.object(Sphere{1}, b.material(Glass{1.5, grey(0), 0.6}), {-2.2, 0, 0});
    b.object(Cone{0.8, 1.4}, b.material(Glass{2.4, grey(0), 0.3}), {0, 1.3, 0});
    b.object(Box{{1.2, 1.2, 1.2}}, b.material(Glossy{grey(1), 1.5, 0.5}), {0, -1, 0});
    b.object(Cylinder{0.6, 1.5}, b.material(Metal{grey(1), 0.8}), {2.2, 0, 0});
    b.scene().environment.color = grey(1);
    b.camera({0, 0, 8}, {0, 0, 0}, 40);
    b.scene().render.maxDepth = 100000;
    b.film(48, 48, 64);
    const test::Estimate found = test::estimateMean(b.render().beauty);
    EXPECT_NEAR(found.mean, 1, 2e-3 + 4 * found.sigma);
    EXPECT_LE(found.sigma, 1e-3);
}

/// A1 in the upper part of a cone that a disk divides.
TEST(ClosedRoom, OfAConeAndADiskIsAFurnace) {
    SceneBuilder b = insideOf(Cone{1, 2}, 0.5, 0.8, {0.1, 0.3, 0}, {0.3, -0.1, 0.2});
    b.object(Disk{0.5}, b.scene().objects.at(b.scene().objects.ids().front()).material, {0, 0, 0},
             grey(0.8));
    test::expectMean(b.render().beauty, 1.6, "cone over disk");
}

TEST(ConvexDiffuse, InConstantLightIsAlbedoWithoutNoise) {  // A6
    SceneBuilder b;
    b.object(Sphere{1}, b.material(Diffuse{grey(0.37)}));
    b.scene().environment.color = grey(2);
    b.camera({0, 0, 4}, {0, 0, 0}, 20);  // The ball fills the picture.
    b.film(32, 32, 4);
    const Image image = b.render().beauty;
    for (const float v : image.rgb) ASSERT_NEAR(v, 0.74, 1e-6);
}

TEST(TranslucentSheet, InConstantLightIsTheSumOfItsShares) {  // A11
    SceneBuilder b;
    b.object(Quad{{100, 100}}, b.material(Translucent{grey(0.3), grey(0.45)}));
    b.scene().environment.color = grey(2);
    b.camera({0, 3, 3}, {0, 0, 0}, 20);
    b.film(16, 16, 4);
    for (const float v : b.render().beauty.rgb) ASSERT_NEAR(v, 1.5, 1e-5);
}

TEST(MirrorCorridor, DimsByEachReflection) {  // A10
    const double reflectance = 0.8, length = 10;
    for (const Integrator integrator : {Integrator::Path, Integrator::Classic})
        for (const double slope :
             {0.57, 1.03, 2.37, 4.17} /* none at the edge between two numbers of bounces */) {
            SceneBuilder b;
            const MaterialId mirror = b.material(Mirror{grey(reflectance)});
            for (const double side : {-1.0, 1.0}) {
                const ObjectId id = b.object(Quad{{2 * length, 2}}, mirror, {side, 0, 0});
                Object wall = b.scene().objects.at(id);
                wall.transform.rotateDegrees = {0, 90, side * 90};  // Its x along the corridor's z.
                b.scene().objects.set(id, wall);
            }
            b.scene().environment.color = grey(1);
            b.scene().render.integrator = integrator;
            b.scene().render.maxDepth = 100;
            b.camera({0, 0, 0}, {slope, 0, -1}, 0.001);
            b.film(16, 16, 128);  // Roulette makes noise in path.
            const int bounces = static_cast<int>(std::floor((length * slope + 1) / 2));
            const double exact = std::pow(reflectance, bounces);
            const test::Estimate found = test::estimateMean(b.render().beauty);
            EXPECT_NEAR(found.mean, exact, 4 * found.sigma + 2e-6 * bounces * exact)
                << "slope " << slope;
            EXPECT_LE(found.sigma, 0.03 * exact) << "slope " << slope;
        }
}

TEST(WhiteFurnace, HidesWhiteMetalInClassicToo) {
    // Rough lobes go on as the perfect ones that they are near to.
    for (const double roughness : {0.0, 0.3}) {
        SceneBuilder b;
        b.object(Sphere{1}, b.material(Metal{grey(1), roughness}));
        b.scene().environment.color = grey(1);
        b.scene().render.integrator = Integrator::Classic;
        b.camera({0, 0, 4}, {0, 0, 0}, 40);
        b.film(16, 16, 4);
        for (const float v : b.render().beauty.rgb) ASSERT_NEAR(v, 1, 1e-5) << roughness;
    }
}

}  // namespace
}  // namespace glint
