// Different ways to the same picture agree: classic and path where their physics is the same, and
// light sampling, BSDF sampling and every combination of them.
#include <gtest/gtest.h>

#include "tests/support/paths.h"
#include "tests/support/scenes.h"
#include "tests/support/strategies.h"
#include "tests/support/temp_folder.h"
#include "tests/support/ztest.h"
#include "tracer/io/scene_json.h"

namespace glint {
namespace {

using test::grey;
using test::SceneBuilder;

/// Both integrators show the same at every pixel; were one 2 % brighter, it would be noticed.
void expectAgreement(SceneBuilder b) {
    constexpr int kSeeds = 24;
    b.scene().film.filterRadius = 1e-9;
    const auto path = test::estimatePixels(b, kSeeds);
    b.scene().render.integrator = Integrator::Classic;
    const auto classic = test::estimatePixels(b, kSeeds);
    std::vector<test::PixelTest> tests, brighter;
    for (std::size_t i = 0; i < path.pixels.size(); ++i) {
        const test::Estimate &p = path.pixels[i], &c = classic.pixels[i];
        tests.push_back({p.mean, std::hypot(p.sigma, c.sigma), c.mean});
        brighter.push_back({1.02 * p.mean, std::hypot(1.02 * p.sigma, c.sigma), c.mean});
    }
    test::expectPixels(tests, kSeeds, 0, "classic against path");
    EXPECT_FALSE(test::pixelsAre(brighter, kSeeds, 0));
}

TEST(ClassicAndPath, AgreeOnMirrorsAndGlassOverEmittersAndEnvironment) {
    SceneBuilder b;
    b.object(Box{{20, 1, 20}}, b.material(Mirror{grey(0.8)}), {0, -0.5, 0});
    b.object(Sphere{1}, b.material(Glass{1.5, Color{0.3, 0.3, 0.3}}), {-1.1, 1, 0});
    b.object(Sphere{0.9}, b.material(Mirror{grey(0.9)}), {1.1, 0.9, 0});
    b.object(Sphere{0.5}, {}, {0, 2.5, -1}, grey(2));
    b.scene().environment.color = grey(0.5);
    b.camera({0, 2, 6}, {0, 0.8, 0}, 40);
    b.film(24, 20, 16);
    expectAgreement(b);
}

TEST(ClassicAndPath, AgreeOnDirectLightAtDepthOne) {
    SceneBuilder b;
    // Not endless: of a lamp far away a BSDF sample sees so little that few of a pixel's samples,
    // or none, tell of it.
    b.object(Box{{6, 1, 6}}, b.material(Diffuse{grey(0.6)}), {0, -0.5, 0});
    b.object(Sphere{1}, b.material(Phong{}), {-1.1, 1, 0});
    b.object(Box{{1, 1, 1}}, b.material(Translucent{}), {1.1, 0.5, 0});
    b.object(Sphere{0.5}, {}, {0, 3, 1}, grey(6));
    b.pointLight({2, 3, 2}, grey(9));
    b.camera({0, 2, 6}, {0, 0.8, 0}, 40);
    b.film(24, 20, 16);
    b.scene().render.maxDepth = 1;
    expectAgreement(b);
}

using test::BsdfOnly;
using test::estimateOf;
using test::LightOnly;
using test::pixelMeans;

template <class Heuristic>
test::Estimate meanWith(const std::shared_ptr<const RenderScene>& scene) {
    return estimateOf(pixelMeans<Heuristic>(scene, test::fullRun() ? 1024 : 64));
}

/// All ways to share the work give one mean over pixels that show one point; counting light twice
/// does not.
void expectOneMean(const std::shared_ptr<const RenderScene>& scene,
                   const test::Estimate& expected) {
    const auto expectSame = [&](const test::Estimate& other, const char* name) {
        EXPECT_LE(std::abs(other.mean - expected.mean), 4 * std::hypot(other.sigma, expected.sigma))
            << name;
        EXPECT_LE(std::abs(other.mean - expected.mean), 4e-3 * expected.mean) << name;
    };
    expectSame(meanWith<BalanceHeuristic>(scene), "balance heuristic");
    expectSame(meanWith<LightOnly>(scene), "light sampling alone");
    expectSame(meanWith<BsdfOnly>(scene), "BSDF sampling alone");
    expectSame(meanWith<PowerHeuristic>(scene), "power heuristic");
    EXPECT_GT(meanWith<test::BothWhole>(scene).mean,
              1.2 * expected.mean);  // A compensated table leaves the dim part to the BSDF.
}

/// A floor, seen at one point.
SceneBuilder floorOf(const AllMaterials::Variant& material) {
    SceneBuilder b;
    b.object(Plane{}, b.scene().materials.add({"Floor", material}));
    b.camera({0, 0.01, 0}, {0, 0, 0}, 0.1);
    b.film(48, 48, 1);
    return b;
}

/// A sky three times as bright in one quarter as elsewhere, without any symmetry that could hide a
/// turn.
std::string unevenSky(const test::TempFolder& folder) {
    Image sky{64, 32, {}};
    for (int y = 0; y < sky.height; ++y)
        for (int x = 0; x < sky.width; ++x)
            for (int c = 0; c < 3; ++c)
                sky.rgb.push_back(x > 10 && x < 30 && y > 3 && y < 14
                                      ? 3.0f
                                      : 1.0f + 0.01f * static_cast<float>(y));
    const auto file = folder / "sky.exr";
    EXPECT_TRUE(saveLinear(file, sky, {}));
    return file.string();
}

TEST(Strategies, AllGiveTheClosedFormUnderABall) {  // A15
    const Result<Scene> loaded = loadScene(test::inSource("scenes/verify/strategies.json"));
    ASSERT_TRUE(loaded) << loaded.error().text();
    SceneBuilder b;
    b.scene() = loaded.value();
    b.film(48, 48, 1);
    const double distance2 = 0.5 * 0.5 + 2.5 * 2.5;
    expectOneMean(b.compile(), {0.6 * 3 * 1.2 * 1.2 / distance2 * 2.5 / std::sqrt(distance2), 0});
}

TEST(Strategies, AllGiveTheSameMeanUnderAnEnvironmentMap) {  // A15
    const test::TempFolder folder;
    SceneBuilder b = floorOf(Diffuse{grey(0.6)});
    b.scene().environment.image = unevenSky(folder);
    const auto scene = b.compile();
    const test::Estimate balance = meanWith<BalanceHeuristic>(scene);
    expectOneMean(scene, balance);
    RenderScene plain =
        *scene;  // Its table in proportion to the picture, not to what the BSDF leaves.
    auto& map = plain.lights.environment.map;
    map = std::make_shared<const EnvironmentMap>(map->image(), EnvironmentMap::Density::Plain);
    expectOneMean(std::make_shared<const RenderScene>(std::move(plain)), balance);
}

TEST(Strategies, AllGiveTheSameMeanForAMixtureUnderManyLights) {  // A15
    const test::TempFolder folder;
    SceneBuilder b = floorOf(Diffuse{});
    const MaterialId clay = b.material(Diffuse{grey(0.6)}),
                     metal = b.material(Metal{grey(0.9), 0.6});
    b.scene().materials.set(b.scene().materials.ids().front(),
                            {"Floor", Mix{{clay, false}, {metal, false}, 0.4}});
    b.scene().environment.image = unevenSky(folder);
    b.object(Sphere{1.2}, {}, {0.5, 2.5, 0}, grey(6));
    const ObjectId id = b.object(Quad{{2, 2}}, {}, {-2, 2, 0}, grey(6));
    Object lamp = b.scene().objects.at(id);
    lamp.transform.rotateDegrees = {180, 0, 0};
    b.scene().objects.set(id, lamp);
    const auto scene = b.compile();
    expectOneMean(scene, meanWith<BalanceHeuristic>(scene));
}

TEST(Strategies, AllGiveTheSameMeanUnderALampThatIsPartlyClear) {  // A15
    SceneBuilder b = floorOf(Diffuse{grey(0.6)});
    const MaterialId clay = b.material(Diffuse{grey(0.3)});
    const ObjectId id = b.object(Torus{1, 0.4}, b.material(Mix{{clay, false}, {{}, true}, 0.7}),
                                 {0.5, 2, 0}, grey(3));
    Object lamp = b.scene().objects.at(id);
    lamp.transform.rotateDegrees = {70, 0, 20};
    lamp.twoSided = true;  // Up to four faces of it shine in one direction.
    b.scene().objects.set(id, lamp);
    const auto scene = b.compile();
    const test::Estimate balance = meanWith<BalanceHeuristic>(scene),
                         alone = meanWith<BsdfOnly>(scene);
    EXPECT_LE(std::abs(balance.mean - alone.mean), 4 * std::hypot(balance.sigma, alone.sigma));
    EXPECT_LE(std::abs(balance.mean - alone.mean), 1e-2 * alone.mean);
}

// T23: what a path may cost changes no mean.
struct NoSplitting : UsualEffort {
    static constexpr int kMostSplits = 0;
};
struct NoRoulette : UsualEffort {
    static constexpr float kDim = 0, kDimBranch = 0;
};
struct EarlyRoulette : UsualEffort {
    static constexpr float kDim = 2, kDimBranch = 2;
};

/// A dim room with glass, a mirror and a lamp: paths are long, and split.
SceneBuilder roomWithGlass() {
    SceneBuilder b;
    const ObjectId id =
        b.object(Box{{6, 4, 6}}, b.material(Diffuse{grey(0.5)}), {0, 2, 0}, grey(0.2));
    Object room = b.scene().objects.at(id);
    room.twoSided = true;
    b.scene().objects.set(id, room);
    b.object(Sphere{1}, b.material(Glass{1.5, grey(0.3)}), {-1.1, 1, 0});
    b.object(Sphere{0.8}, b.material(Mirror{grey(0.7)}), {1.1, 0.8, 0});
    b.object(Sphere{0.5}, {}, {0, 3, -1}, grey(2));
    b.camera({0, 1.5, 2.9}, {0, 1, 0}, 60);
    b.film(48, 48, 1);
    return b;
}

TEST(Effort, OfSplittingAndRouletteChangesNoMean) {  // T23
    SceneBuilder b = roomWithGlass();
    const auto scene = b.compile();
    const int samples = test::fullRun() ? 1024 : 96;
    const std::vector<double> usual = pixelMeans<BalanceHeuristic>(scene, samples);
    /// Mean difference in units of its own standard error, from the differences pixel by pixel.
    const auto deviation = [&](const std::vector<double>& other) {
        std::vector<double> difference;
        for (std::size_t i = 0; i < usual.size(); ++i) difference.push_back(other[i] - usual[i]);
        const test::Estimate e = estimateOf(difference);
        EXPECT_LE(e.sigma, 2e-3 * estimateOf(usual).mean) << "too noisy to tell";
        return std::abs(e.mean) / e.sigma;
    };
    EXPECT_LE(deviation(pixelMeans<BalanceHeuristic, NoSplitting>(scene, samples)), 4);
    EXPECT_LE(deviation(pixelMeans<BalanceHeuristic, NoRoulette>(scene, samples)), 4);
    EXPECT_LE(deviation(pixelMeans<BalanceHeuristic, EarlyRoulette>(scene, samples)), 4);
    // Wrong twin: paths cut short instead of left to chance.
    b.scene().render.maxDepth = 6;
    EXPECT_GT(deviation(pixelMeans<BalanceHeuristic>(b.compile(), samples)), 4);
}

// T18: at the smallest roughness that is not polished, pictures are those of the polished material.
double relativeSquaredError(const Image& image, const Image& reference) {
    const double mean = test::estimateMean(reference).mean;
    double sum = 0;
    for (std::size_t i = 0; i < image.rgb.size(); ++i) {
        const double r = static_cast<double>(reference.rgb[i]),
                     d = static_cast<double>(image.rgb[i]) - r;
        sum += d * d / (r * r + 1e-2 * mean * mean);
    }
    return sum / static_cast<double>(image.rgb.size());
}

TEST(NarrowestLobes, ShowThePictureOfThePolishedMaterial) {
    const test::TempFolder folder;
    Image sky{64, 32, {}};
    for (int i = 0; i < 64 * 32; ++i)
        for (int c = 0; c < 3; ++c)
            sky.rgb.push_back(static_cast<float>(2 + 0.8 * std::sin(8 * kPi * (i % 64) / 64) *
                                                         std::cos(4 * kPi * (i / 64) / 32)));
    const auto file = folder / "sky.exr";
    ASSERT_TRUE(saveLinear(file, sky, {}));
    const auto picture = [&](const AllMaterials::Variant& material) {
        SceneBuilder b;
        b.object(Sphere{1}, b.scene().materials.add({"Ball", material}));
        b.scene().environment.image = file.string();
        b.camera({0, 0.5, 4}, {0, 0, 0}, 35);
        b.film(128, 128, 64);
        b.scene().render.spp = 64;
        return b.render().beauty;
    };
    constexpr double kThreshold = 0.01;  // its square is kMinAlpha
    const Color gold{0.9, 0.6, 0.2};
    EXPECT_LE(
        relativeSquaredError(picture(Metal{gold, kThreshold * 1.001}), picture(Metal{gold, 0})),
        1e-3);
    EXPECT_LE(
        relativeSquaredError(picture(Glass{1.5, Color{}, kThreshold * 1.001}), picture(Glass{})),
        1e-3);
    EXPECT_GT(
        relativeSquaredError(picture(Glass{1.7, Color{}, kThreshold * 1.001}), picture(Glass{})),
        1e-3);  // the wrong twin
}

}  // namespace
}  // namespace glint
