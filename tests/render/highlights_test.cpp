// Light by way of highlights in glossy surfaces: drawn towards them and found by chance give one
// picture, for every shape and every kind of light.
#include <gtest/gtest.h>

#include <ostream>

#include "tests/support/strategies.h"
#include "tests/support/temp_folder.h"
#include "tests/support/ztest.h"

namespace glint {
namespace {

using test::grey;
using test::SceneBuilder;

struct NoHighlights : UsualEffort {
    static constexpr bool kHighlights = false;
};

enum class Lamp { Point, Spot, HardSun, Sun, Sky, Ball, Quad };

struct Case {
    std::string name;
    Shape shape;
    AllMaterials::Variant material;
    Lamp lamp;
};
void PrintTo(const Case& tested, std::ostream* out) { *out << tested.name; }

/// A floor and a wall with the glossy shape before them.
SceneBuilder roomWith(const Case& tested, const test::TempFolder& folder) {
    SceneBuilder b;
    const MaterialId clay = b.material(Diffuse{grey(0.7)});
    b.object(Box{{6, 0.2, 6}}, clay, {0, -0.1, 0});
    b.object(Box{{6, 4, 0.2}}, clay, {0, 2, -1.6});
    const ObjectId id =
        b.object(tested.shape, b.scene().materials.add({"Glossy", tested.material}), {0.2, 0.9, 0});
    Object object = b.scene().objects.at(id);
    object.transform.rotateDegrees = {20, 10, 15};
    b.scene().objects.set(id, object);
    switch (tested.lamp) {
        case Lamp::Point:
            b.pointLight({0.8, 2.6, 1}, grey(20));
            break;
        case Lamp::Spot:
            b.scene().lights.add({"Spot", SpotLight{.position = {0.8, 2.8, 1},
                                                    .target = {0.2, 0.9, 0},
                                                    .intensity = grey(20),
                                                    .coneDegrees = 50}});
            break;
        case Lamp::HardSun:
            b.scene().lights.add(
                {"Sun", SunLight{.direction = {-0.5, -1, -0.6}, .irradiance = grey(3)}});
            break;
        case Lamp::Sun:
            b.scene().lights.add({"Sun", SunLight{.direction = {-0.5, -1, -0.6},
                                                  .irradiance = grey(3),
                                                  .angleDegrees = 4}});
            break;
        case Lamp::Ball:
            b.object(Sphere{0.15}, {}, {0.8, 2.6, 1}, grey(60));
            break;
        case Lamp::Quad: {
            const ObjectId lamp = b.object(Quad{{0.4, 0.3}}, {}, {0.8, 2.6, 1}, grey(40));
            Object facing = b.scene().objects.at(lamp);
            facing.transform.rotateDegrees = {160, 0, 20};
            b.scene().objects.set(lamp, facing);
            break;
        }
        case Lamp::Sky:
            b.scene().environment.image = test::saveSky(folder, {35, 6}, {36, 7}, 120.0f);
            break;
    }
    b.camera({0, 3.2, 3.4}, {0, 0.6, -0.4}, 50);
    b.film(32, 32, 1);
    b.scene().render.maxDepth = 5;
    return b;
}

/// Without the pixels in which the camera itself sees a highlight: their noise is no concern of
/// this.
std::vector<double> calm(const std::vector<double>& pixels, const std::vector<double>& reference) {
    std::vector<double> out;
    for (std::size_t i = 0; i < pixels.size(); ++i)
        if (reference[i] < 3) out.push_back(pixels[i]);
    return out;
}

class Highlights : public testing::TestWithParam<Case> {};

TEST_P(Highlights, ChangeNoMean) {
    const test::TempFolder folder;
    const auto scene = roomWith(GetParam(), folder).compile();
    ASSERT_FALSE(scene->highlights.empty());
    const int samples = test::fullRun() ? 4096 : 256;
    const std::vector<double> usual = test::pixelMeans<BalanceHeuristic>(scene, samples);
    const auto expectSame = [&](const std::vector<double>& other, const char* name, double noise) {
        const test::Deviation d = test::deviationOf(calm(usual, usual), calm(other, usual));
        EXPECT_LE(d.relativeSigma, noise) << name << ": too noisy to tell";
        EXPECT_LE(d.sigmas, 4) << name;
    };
    expectSame(test::pixelMeans<BalanceHeuristic, NoHighlights>(scene, samples),
               "without highlights", 1.5e-2);
    const bool delta = GetParam().lamp == Lamp::Point || GetParam().lamp == Lamp::Spot ||
                       GetParam().lamp == Lamp::HardSun;
    if (!delta) expectSame(test::pixelMeans<test::BsdfOnly>(scene, samples), "surfaces alone", 0.1);
}

const AllMaterials::Variant kSteel = Metal{grey(0.9), 0.25}, kBrushed = Metal{grey(0.9), 0.38},
                            kLacquer = Glossy{.color = grey(0.5), .roughness = 0.25};

INSTANTIATE_TEST_SUITE_P(
    Surfaces, Highlights,
    testing::Values(Case{"BallUnderPoint", Sphere{0.7}, kSteel, Lamp::Point},
                    Case{"BallUnderSpot", Sphere{0.7}, kBrushed, Lamp::Spot},
                    Case{"BallUnderHardSun", Sphere{0.7}, kBrushed, Lamp::HardSun},
                    Case{"BallUnderSun", Sphere{0.7}, kSteel, Lamp::Sun},
                    Case{"BallUnderSky", Sphere{0.7}, kSteel, Lamp::Sky},
                    Case{"BallUnderBall", Sphere{0.7}, kSteel, Lamp::Ball},
                    Case{"BallUnderQuad", Sphere{0.7}, kSteel, Lamp::Quad},
                    Case{"LacqueredBallUnderSun", Sphere{0.7}, kLacquer, Lamp::Sun},
                    Case{"BoxUnderBall", Box{{1.2, 1, 0.8}}, kSteel, Lamp::Ball},
                    Case{"BoxUnderSun", Box{{1.2, 1, 0.8}}, kSteel, Lamp::Sun},
                    Case{"QuadUnderSpot", Quad{{1.6, 1.6}}, kBrushed, Lamp::Spot},
                    Case{"DiskUnderSky", Disk{0.8}, kSteel, Lamp::Sky},
                    Case{"CylinderUnderSun", Cylinder{0.5, 1.4}, kSteel, Lamp::Sun},
                    Case{"CylinderUnderBall", Cylinder{0.5, 1.4}, kSteel, Lamp::Ball},
                    Case{"ConeUnderSun", Cone{0.7, 1.4}, kSteel, Lamp::Sun},
                    Case{"ConeUnderPoint", Cone{0.7, 1.4}, kBrushed, Lamp::Point},
                    Case{"TorusUnderSun", Torus{0.6, 0.25}, kSteel, Lamp::Sun},
                    Case{"TorusUnderBall", Torus{0.6, 0.25}, kSteel, Lamp::Ball}),
    [](const auto& tested) { return tested.param.name; });

TEST(HighlightsTwin, CountingBothWaysWholeIsNoticed) {
    const test::TempFolder folder;
    const auto scene = roomWith({"", Sphere{0.7}, kBrushed, Lamp::Sun}, folder).compile();
    const std::vector<double> usual = test::pixelMeans<BalanceHeuristic>(scene, 256);
    EXPECT_GT(test::deviationOf(calm(usual, usual),
                                calm(test::pixelMeans<test::BothWhole>(scene, 256), usual))
                  .sigmas,
              4);
}

TEST(HighlightsTable, LeavesOutWhatIsNotNarrowAndWhatRefracts) {
    SceneBuilder b;
    b.object(Sphere{1}, b.material(Metal{grey(0.9), 0.6}), {0, 1, 0});
    b.object(Sphere{1}, b.material(Glass{.roughness = 0.2}), {3, 1, 0});
    b.pointLight({0, 4, 0}, grey(9));
    EXPECT_TRUE(b.compile()->highlights.empty());
    b.object(Sphere{1}, b.material(Metal{grey(0.9), 0.2}), {6, 1, 0});
    EXPECT_EQ(b.compile()->highlights.surfaces.size(), 1u);
}

TEST(HighlightsTable, LeavesOutASkyWithSunsOnOppositeSides) {
    const test::TempFolder folder;
    SceneBuilder b;
    b.object(Sphere{1}, b.material(Metal{grey(0.9), 0.2}), {0, 1, 0});
    b.object(Plane{}, b.material(Diffuse{grey(0.5)}));
    for (const int suns : {1, 2}) {
        Image sky{64, 32, std::vector<float>(64 * 32 * 3, 0.0f)};
        for (int i = 0; i < suns; ++i)
            for (int c = 0; c < 3; ++c)
                sky.rgb[static_cast<std::size_t>(((15 + i) * 64 + 10 + 32 * i) * 3 + c)] = 1e4f;
        const auto file = folder / ("sky" + std::to_string(suns) + ".exr");
        ASSERT_TRUE(saveLinear(file, sky, {}));
        b.scene().environment.image = file.string();
        EXPECT_EQ(b.compile()->highlights.empty(), suns == 2);
    }
}

TEST(HighlightsTable, IsNotKeptForWhatTheyHardlyLight) {
    for (const double apart : {0.8, 40.0}) {
        SceneBuilder b;
        b.object(Sphere{0.2}, b.material(Metal{grey(0.9), 0.2}), {0, 0.2, 0});
        b.object(Box{{1, 1, 1}}, b.material(Diffuse{grey(0.5)}), {apart, 0.5, 0});
        b.pointLight({0, 4, 0}, grey(9));
        EXPECT_EQ(b.compile()->highlights.empty(), apart > 1) << apart;
    }
}

TEST(HighlightsTable, CountsALampByItsShareOfAllLight) {
    SceneBuilder b;
    b.object(Sphere{0.7}, b.material(Metal{grey(0.9), 0.2}), {0, 0.7, 0});
    b.object(Plane{}, b.material(Diffuse{grey(0.5)}));
    b.pointLight({0, 4, 0}, grey(9));
    EXPECT_FALSE(b.compile()->highlights.empty());
    b.pointLight({30, 40, 0}, grey(9e3));
    const auto scene = b.compile();
    ASSERT_EQ(scene->highlights.lights.size(), 2u);
    EXPECT_LT(scene->highlights.worthOfAll[0], 0.01 * scene->highlights.worthOfAll[1]);
}

TEST(HighlightsNoise, IsAFractionOfThatOfLuck) {
    const test::TempFolder folder;
    SceneBuilder b = roomWith({"", Sphere{0.7}, Metal{grey(0.9), 0.2}, Lamp::HardSun}, folder);
    const std::vector<double> reference = test::pixelMeans<BalanceHeuristic>(b.compile(), 1024);
    b.scene().render.seed = 2;
    const auto error = [&](const std::vector<double>& pixels) {
        const std::vector<double> found = calm(pixels, reference),
                                  truth = calm(reference, reference);
        double sum = 0;
        for (std::size_t i = 0; i < found.size(); ++i)
            sum += (found[i] - truth[i]) * (found[i] - truth[i]);
        return sum;
    };
    const auto scene = b.compile();
    EXPECT_LE(error(test::pixelMeans<BalanceHeuristic>(scene, 64)),
              0.2 * error(test::pixelMeans<BalanceHeuristic, NoHighlights>(scene, 64)));
}

}  // namespace
}  // namespace glint
