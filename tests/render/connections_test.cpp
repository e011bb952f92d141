// Caustics of perfect balls and faces: light found by way of them and light found by chance give
// one picture, for every caster and every kind of light.
#include <gtest/gtest.h>

#include <ostream>

#include "tests/support/strategies.h"
#include "tests/support/temp_folder.h"
#include "tests/support/ztest.h"

namespace glint {
namespace {

using test::grey;
using test::SceneBuilder;

struct NoConnections : UsualEffort {
    static constexpr bool kConnects = false;
};

enum class Lamp { Ball, Quad, Disk, Sun, Sky };
/// Pool: a box that the floor lies in.
enum class Shape { Ball, Block, Pane, Plate, Pool };

ObjectId addCaster(SceneBuilder& b, Shape shape, MaterialId material) {
    switch (shape) {
        case Shape::Ball:
            return b.object(Sphere{0.8}, material, {0, 0.9, 0});
        case Shape::Block:
            return b.object(Box{{1.2, 1.4, 0.8}}, material, {0, 0.8, 0});
        case Shape::Pane:
            return b.object(Quad{{1.8, 1.8}}, material, {0, 1, -0.6});
        case Shape::Plate:
            return b.object(Disk{1}, material, {0, 1, -0.6});
        case Shape::Pool:
            return b.object(Box{{3, 0.6, 3}}, material, {0, 0.2, 0.2});
    }
    return {};
}

/// A floor and a wall with a caster between them, seen from above; the light is on the far side.
SceneBuilder roomWith(Shape shape, const AllMaterials::Variant& material, Lamp lamp,
                      const test::TempFolder& folder) {
    SceneBuilder b;
    const MaterialId clay = b.material(Diffuse{grey(0.7)});
    b.object(Box{{6, 0.2, 6}}, clay, {0, -0.1, 0});
    b.object(Box{{6, 4, 0.2}}, clay, {0, 2, -1.6});
    const auto turn = [&](ObjectId id, const DVec3& degrees) {
        Object object = b.scene().objects.at(id);
        object.transform.rotateDegrees = degrees;
        b.scene().objects.set(id, object);
    };
    const auto facingDown = [&](ObjectId id) { turn(id, {160, 0, 20}); };
    const ObjectId caster = addCaster(b, shape, b.scene().materials.add({"Caster", material}));
    if (shape == Shape::Pane || shape == Shape::Plate) turn(caster, {70, 0, 10});
    if (shape == Shape::Block) turn(caster, {0, 25, 0});
    switch (lamp) {
        case Lamp::Ball:
            b.object(Sphere{0.35}, {}, {0.8, 2.6, 1}, grey(20));
            break;
        case Lamp::Quad:
            facingDown(b.object(Quad{{0.8, 0.5}}, {}, {0.8, 2.6, 1}, grey(20)));
            break;
        case Lamp::Disk:
            facingDown(b.object(Disk{0.35}, {}, {0.8, 2.6, 1}, grey(20)));
            break;
        case Lamp::Sun:
            b.scene().lights.add({"Sun", SunLight{.direction = {-0.5, -1, -0.6},
                                                  .irradiance = grey(3),
                                                  .angleDegrees = 14}});
            break;
        case Lamp::Sky:
            b.scene().environment.image = test::saveSky(folder, {35, 5}, {38, 8}, 60.0f);
            break;
    }
    b.camera({0, 3.2, 3.4}, {0, 0.6, -0.4}, 50);
    b.film(40, 40, 1);
    b.scene().render.maxDepth = 6;
    return b;
}

struct Case {
    std::string name;
    Shape shape;
    AllMaterials::Variant material;
    Lamp lamp;
};

void PrintTo(const Case& tested, std::ostream* out) { *out << tested.name; }

class Connections : public testing::TestWithParam<Case> {};

TEST_P(Connections, ChangeNoMean) {
    const test::TempFolder folder;
    const auto scene =
        roomWith(GetParam().shape, GetParam().material, GetParam().lamp, folder).compile();
    ASSERT_FALSE(scene->casters.empty());
    const int samples = test::fullRun() ? 2048 : 256;
    const std::vector<double> usual = test::pixelMeans<BalanceHeuristic>(scene, samples);
    const auto expectSame = [&](const std::vector<double>& other, const char* name, double noise) {
        const test::Deviation d = test::deviationOf(usual, other);
        EXPECT_LE(d.relativeSigma, noise) << name << ": too noisy to tell";
        EXPECT_LE(d.sigmas, 4) << name;
    };
    expectSame(test::pixelMeans<BalanceHeuristic, NoConnections>(scene, samples),
               "without connections", 8e-3);
    // Connections alone are without bound where a caustic folds, and a sky's dim part is the
    // surfaces': noisier.
    expectSame(test::pixelMeans<test::LightOnly>(scene, samples),
               "connections and light sampling alone", test::fullRun() ? 2e-2 : 3e-2);
}

const AllMaterials::Variant kMirror = Mirror{grey(0.9)}, kGlass = Glass{1.5},
                            kWater = Glass{1.33, Color{0.8, 0.3, 0.1}};

INSTANTIATE_TEST_SUITE_P(
    Casters, Connections,
    testing::Values(Case{"MirrorBallUnderBall", Shape::Ball, kMirror, Lamp::Ball},
                    Case{"MirrorBallUnderQuad", Shape::Ball, kMirror, Lamp::Quad},
                    Case{"MirrorBallUnderDisk", Shape::Ball, kMirror, Lamp::Disk},
                    Case{"MirrorBallUnderSun", Shape::Ball, kMirror, Lamp::Sun},
                    Case{"MirrorBallUnderSky", Shape::Ball, kMirror, Lamp::Sky},
                    Case{"GlassBallUnderBall", Shape::Ball, kGlass, Lamp::Ball},
                    Case{"WaterBallUnderQuad", Shape::Ball, kWater, Lamp::Quad},
                    Case{"GlassBallUnderDisk", Shape::Ball, kGlass, Lamp::Disk},
                    Case{"GlassBallUnderSun", Shape::Ball, kGlass, Lamp::Sun},
                    Case{"GlassBallUnderSky", Shape::Ball, kGlass, Lamp::Sky},
                    Case{"PolishedBallUnderBall", Shape::Ball,
                         Glossy{.color = grey(0.5), .roughness = 0.0}, Lamp::Ball},
                    Case{"MirrorBlockUnderBall", Shape::Block, kMirror, Lamp::Ball},
                    Case{"MirrorPaneUnderQuad", Shape::Pane, kMirror, Lamp::Quad},
                    Case{"MirrorPlateUnderDisk", Shape::Plate, kMirror, Lamp::Disk},
                    Case{"MirrorPaneUnderSun", Shape::Pane, kMirror, Lamp::Sun},
                    Case{"MirrorBlockUnderSky", Shape::Block, kMirror, Lamp::Sky},
                    Case{"WaterBlockUnderBall", Shape::Block, kWater, Lamp::Ball},
                    Case{"WaterBlockUnderSun", Shape::Block, kWater, Lamp::Sun},
                    Case{"GlassBlockUnderSky", Shape::Block, kGlass, Lamp::Sky},
                    Case{"PoolUnderSun", Shape::Pool, kWater, Lamp::Sun},
                    Case{"PoolUnderSky", Shape::Pool, kWater, Lamp::Sky},
                    Case{"PoolUnderBall", Shape::Pool, kWater, Lamp::Ball}),
    [](const auto& tested) { return tested.param.name; });

TEST(ConnectionsTwin, CountingBothWaysWholeIsNoticed) {
    const test::TempFolder folder;
    const auto scene = roomWith(Shape::Ball, Mirror{grey(0.9)}, Lamp::Ball, folder).compile();
    const std::vector<double> usual = test::pixelMeans<BalanceHeuristic>(scene, 128);
    EXPECT_GT(test::deviationOf(usual, test::pixelMeans<test::BothWhole>(scene, 128)).sigmas, 4);
}

TEST(ConnectionsTable, LeavesOutWhatItCannotConnect) {
    SceneBuilder b;
    b.object(Sphere{1}, b.material(Glass{}), {0, 1, 0});
    b.object(Box{{4, 1, 4}}, b.material(Glass{1.33}), {0, 0.5, 0});  // Reaches into the ball.
    b.object(Sphere{0.2}, {}, {0, 4, 0}, grey(9));
    EXPECT_TRUE(b.compile()->casters.empty());
    SceneBuilder alone;
    alone.object(Sphere{1}, alone.material(Glass{}), {0, 1, 0});
    alone.pointLight({0, 4, 0},
                     grey(9));  // No path but a connection would find it: the picture would change.
    EXPECT_TRUE(alone.compile()->casters.empty());
}

}  // namespace
}  // namespace glint
