// The scenes of scenes/verify against the closed form that stands in each file, under `editor`:
//   "verify": {"source", "formula", "channel_mean", "twin": {"what", "set", "to"}}
// Four things hold for each: the number in the file is the formula's, worked out anew here; the
// picture's mean is that number; the same scene with the twin's one thing wrong is rejected by the
// same check; and every kernel that can trace the scene gives the same bits. Files without the
// block belong to other tests.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>

#include <nlohmann/json.hpp>

#include "tests/support/paths.h"
#include "tests/support/scenes.h"
#include "tests/support/temp_folder.h"
#include "tracer/io/image_file.h"
#include "tracer/io/scene_json.h"
#include "tracer/render/kernel.h"
#include "tracer/render/layers.h"

namespace glint {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

double squared(double v) { return v * v; }

/// The radiance within a closed room that emits `emission` everywhere.
double furnace(double emission, double albedo) { return emission / (1 - albedo); }

/// Radiance of the wall of a ball with a lamp in its centre, lit directly.
double lampInBall(double albedo, double intensity, double radius) {
    return albedo * intensity / (kPi * squared(radius));
}

/// Radiances of two concentric balls, by their view factors.
struct ConcentricBalls {
    double inner = 0, outer = 0;
    ConcentricBalls(double r1, double r2, double e1, double e2, double a1, double a2) {
        const double f = squared(r1 / r2);
        outer = (e2 + a2 * f * e1) / (1 - a2 * (1 - f + f * a1));
        inner = e1 + a1 * outer;
    }
};

/// Fresnel's reflectance on entering glass of index n, for unpolarised light.
double fresnel(double sine, double n) {
    const double c = std::sqrt(1 - squared(sine)), ct = std::sqrt(1 - squared(sine / n));
    return 0.5 * (squared((c - n * ct) / (c + n * ct)) + squared((n * c - ct) / (n * c + ct)));
}

/// An absorbing ball of glass in constant light of 1, hit at the angle of that sine: every inner
/// chord has the same length.
double glassBall(double sine, double n, double absorption, double radius) {
    const double f = fresnel(sine, n),
                 a = std::exp(-absorption * 2 * radius * std::sqrt(1 - squared(sine / n)));
    return f + squared(1 - f) * a / (1 - f * a);
}

/// What a stack of layers passes and reflects at normal incidence, with all inner reflections,
/// added without interference. `indices` has one entry more than there are boundaries; `share` is
/// what one layer lets through, 1 for clear ones.
struct Stack {
    double transmitted = 1, reflected = 0;
    explicit Stack(const std::vector<double>& indices, double share = 1) {
        for (std::size_t i = 0; i + 1 < indices.size(); ++i) {
            const double r = squared((indices[i] - indices[i + 1]) / (indices[i] + indices[i + 1]));
            const double a = i == 0 ? 1 : share;
            // Boundary r behind a layer `a`, added to the stack so far; seen from the front, and
            // from behind.
            const double series = 1 / (1 - fromBehind_ * r * a * a);
            reflected += transmitted * transmitted * r * a * a * series;
            fromBehind_ = r + squared(1 - r) * fromBehind_ * a * a * series;
            transmitted *= a * (1 - r) * series;
        }
    }

  private:
    double fromBehind_ = 0;
};

/// A diffuse floor under a ball wholly above the horizon.
double underBall(double albedo, double emission, double radius, const DVec3& at) {
    const double d2 = glm::dot(at, at);
    return albedo * emission * squared(radius) / d2 * at.y / std::sqrt(d2);
}

/// A diffuse floor `h` metres below a spot that shines straight down, seen `x` metres beside it,
/// where its edge fades.
double underSpot(double albedo, double intensity, double h, double x, double outerDegrees,
                 double innerDegrees) {
    const double d2 = h * h + x * x, cosine = h / std::sqrt(d2),
                 outer = std::cos(degreesToRadians(outerDegrees));
    const double t = (cosine - outer) / (std::cos(degreesToRadians(innerDegrees)) - outer);
    return albedo / kPi * intensity * t * t * (3 - 2 * t) * cosine / d2;
}

/// Form factor of a rectangle parallel to the receiver with a corner right above it; sides over
/// height (Lambert).
double cornerFormFactor(double x, double y) {
    const double sx = std::sqrt(1 + x * x), sy = std::sqrt(1 + y * y);
    return (x / sx * std::atan(y / sx) + y / sy * std::atan(x / sy)) / (2 * kPi);
}

/// The closed forms by the names of the files, with the numbers of the scenes.
const std::map<std::string, double>& closedForms() {
    static const ConcentricBalls balls(0.7, 2, 1.5, 0.3, 0.4, 0.6);
    static const Stack slab({1, 1.5, 1}, std::exp(-0.7));
    static const std::map<std::string, double> forms = {
        {"furnace_sphere", furnace(0.8, 0.4)},
        {"furnace_box", furnace(0.8, 0.4)},
        {"furnace_cylinder", furnace(0.8, 0.4)},
        {"furnace_cone", furnace(0.8, 0.4)},
        {"furnace_torus", furnace(0.8, 0.4)},
        {"furnace_quads", furnace(0.8, 0.4)},
        {"lamp_in_ball", furnace(lampInBall(0.7, 3, 1.5), 0.7)},
        {"lamp_in_ball_two_bounces", lampInBall(0.7, 3, 1.5) * (1 + 0.7)},
        {"concentric_balls_inner", balls.inner},
        {"concentric_balls_outer", balls.outer},
        {"white_furnace", 1.0},
        {"convex_diffuse", 0.37 * 2},
        {"glass_ball", glassBall(0.6, 1.5, 1, 1)},
        {"slab_transmission", slab.transmitted},
        {"slab_reflection", slab.reflected},
        {"floor_under_point", 0.6 / kPi * 7 * 2 / std::pow(1.5 * 1.5 + 2 * 2, 1.5)},
        {"floor_under_ball", underBall(0.6, 5, 0.5, {1, 2, 0.5})},
        {"floor_under_disk", 0.6 * 5 * squared(0.8) / (squared(0.8) + squared(1.5))},
        {"floor_under_rectangle", 0.6 * 4 * 4 * cornerFormFactor(1 / 1.5, 1.5 / 1.5)},
        {"floor_under_spot", underSpot(0.6, 7, 2, 1, 40, 16)},
        {"floor_under_sun", 0.6 / kPi * 3 * 2 / std::sqrt(5.25)},
        {"floor_under_sun_disc", 0.6 / kPi * 3 * 2 / std::sqrt(5.25)},
        {"mirror_corridor", std::pow(0.8, 5)},
        {"translucent_sheet", (0.3 + 0.45) * 2},
        {"phong_lobe", 0.9 * 2},
        {"absorbing_medium", 3 * std::exp(-0.3 * 3)},
        {"touching_glass", Stack({1, 1.33, 1.5, 1}).transmitted},
        {"bubble_in_glass", Stack({1, 1.5, 1, 1.5, 1}).transmitted},
        {"strategies", underBall(0.6, 3, 1.2, {0.5, 2.5, 0})},
    };
    return forms;
}

/// The `verify` block of a scene; null without one.
json verifyBlock(const Scene& scene) {
    const json editor = json::parse(scene.editor, nullptr, false);
    return editor.is_object() && editor.contains("verify") ? editor["verify"] : json();
}

/// Names of the files with a closed form, and of those that cannot be read, which then fail by
/// name.
std::vector<std::string> verifyScenes() {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(test::inSource("scenes/verify"))) {
        if (entry.path().extension() != ".json") continue;
        const Result<Scene> scene = loadScene(entry.path());
        if (!scene || !verifyBlock(scene.value()).is_null())
            names.push_back(entry.path().stem().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

/// The picture, with 16 times the samples in the full form.
Image rendered(const Scene& scene) {
    test::SceneBuilder b;
    b.scene() = scene;
    b.film(scene.film.width, scene.film.height, scene.render.spp);
    return b.render().beauty;
}

class Verify : public testing::TestWithParam<std::string> {
  protected:
    void SetUp() override {
        const Result<Scene> loaded =
            loadScene(test::inSource("scenes/verify") / (GetParam() + ".json"));
        ASSERT_TRUE(loaded) << loaded.error().text();
        scene_ = loaded.value();
        block_ = verifyBlock(scene_);
        exact_ = block_.value("channel_mean", 0.0);
    }
    Scene scene_;
    json block_;
    double exact_ = 0;
};

TEST_P(Verify, NumberIsThatOfTheFormula) {
    const auto form = closedForms().find(GetParam());
    ASSERT_NE(form, closedForms().end()) << "a scene without a formula in this test";
    EXPECT_NEAR(exact_, form->second, 1e-12 * form->second);
    EXPECT_FALSE(block_.value("formula", "").empty());
    EXPECT_FALSE(block_.value("source", "").empty());
}

/// Adds a row to the table that `./glint.sh closed-forms` puts into tests/render/README.md, if it
/// asks for one.
void addRow(const std::string& name, const std::string& source, double exact,
            const test::Estimate& found) {
    const char* file = std::getenv("GLINT_CLOSED_FORMS");
    if (!file) return;
    char row[256];
    std::snprintf(row, sizeof row, "| %s | `%s` | %.7g | %.7g | %+.1e | %.1e |\n", source.c_str(),
                  name.c_str(), exact, found.mean, found.mean / exact - 1, found.sigma / exact);
    std::ofstream(file, std::ios::app) << row;
}

TEST_P(Verify, PictureIsTheClosedForm) {
    const Image picture = rendered(scene_);
    test::expectMean(picture, exact_, GetParam());
    addRow(GetParam(), block_.value("source", ""), exact_, test::estimateMean(picture));
}

TEST_P(Verify, WrongTwinIsRejected) {
    const json& twin = block_.at("twin");
    const Result<Scene> wrong =
        withSetting(scene_, twin.at("set").get<std::string>(), twin.at("to").dump());
    ASSERT_TRUE(wrong) << wrong.error().text();
    ASSERT_FALSE(wrong.value() == scene_) << "the twin changes nothing";
    EXPECT_FALSE(test::meanIs(rendered(wrong.value()), exact_)) << twin.at("what");
}

// With the tests above: the closed form holds for every kernel that can trace the scene.
TEST_P(Verify, EveryKernelThatCoversItGivesTheSameBits) {
    test::SceneBuilder b;
    b.scene() = scene_;
    const auto scene = b.compile();
    const Kernel& chosen = chooseKernel(*scene);
    for (const Kernel& kernel : allKernels()) {
        const bool covers = (scene->features & ~kernel.features) == 0;
        if (!covers || kernel.integrator != scene_.render.integrator) continue;
        for (int i = 0; i < 64; ++i) {
            LayerSample layers;
            KernelState one{*scene, {}, {}, false}, other{*scene, {}, {}, false, &layers};
            const int x = i % scene_.film.width, y = i / 8 % scene_.film.height;
            const auto sample = static_cast<std::uint32_t>(i);
            ASSERT_EQ(chosen.run(one, x, y, sample), kernel.run(other, x, y, sample))
                << kernel.name << " at " << x << ", " << y << ", sample " << i;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Scene, Verify, testing::ValuesIn(verifyScenes()),
                         [](const auto& tested) { return tested.param; });

TEST(VerifyScenes, HaveAFileForEveryClosedForm) {
    const std::vector<std::string> names = verifyScenes();
    for (const auto& [name, exact] : closedForms())
        EXPECT_TRUE(std::binary_search(names.begin(), names.end(), name)) << name;
}

/// A floor under a sky that is black but for one texel of radiance `emission`, in row `row` of 64.
Image underTexel(const fs::path& file, int row, float emission) {
    Image sky{128, 64, std::vector<float>(std::size_t{3} * 128 * 64, 0.0f)};
    for (std::size_t c = 0; c < 3; ++c)
        sky.rgb[3 * (static_cast<std::size_t>(row) * 128 + 37) + c] = emission;
    EXPECT_TRUE(saveLinear(file, sky, {}));
    test::SceneBuilder b;
    b.object(Plane{}, b.material(Diffuse{Color{0.6, 0.6, 0.6}}));
    b.camera({0, 0.1, 0}, {0, 0, 0}, 0.01);
    b.scene().environment.image = file.string();
    b.scene().render.maxDepth = 1;
    b.film(16, 16, 256);
    return b.render().beauty;
}

TEST(VerifyScenes, FloorUnderOneTexelOfTheSky) {  // A9
    // Looked up bilinearly, the texel is a tent of half width D = pi / H about its centre t: the
    // integral of the tent times sin t cos t is sin(2 t) / 2 * sin(D)^2 / D, and that over the tent
    // in longitude 2 pi / W.
    constexpr int kRow = 14;
    constexpr double kD = kPi / 64, kCentre = (kRow + 0.5) * kD;
    const double exact = 0.6 / kPi * 2000 * (2 * kPi / 128) * 0.5 * std::sin(2 * kCentre) *
                         squared(std::sin(kD)) / kD;
    const test::TempFolder folder;
    test::expectMean(underTexel(folder / "texel.exr", kRow, 2000), exact, "texel");
    EXPECT_FALSE(test::meanIs(underTexel(folder / "brighter.exr", kRow, 2040), exact));
    EXPECT_FALSE(test::meanIs(underTexel(folder / "lower.exr", kRow + 1, 2000), exact));
}

}  // namespace
}  // namespace glint
