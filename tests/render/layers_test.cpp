// Layers: the light layers sum to the picture, and each holds what its name says.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <map>

#include "tests/support/scenes.h"

namespace glint {
namespace {

using test::grey;
using test::SceneBuilder;

using Channels = std::map<std::string, std::vector<float>>;

Channels layersOf(const SceneBuilder& b) {
    const Rendering rendering = render(b.compile(), {.threads = 2, .layers = true});
    Channels out;
    for (const ExrChannel& channel : rendering.layers) out[channel.name] = channel.values;
    return out;
}

const char* kLight[] = {"diffuse_direct",  "diffuse_indirect",    "glossy_direct",
                        "glossy_indirect", "transmission_direct", "transmission_indirect",
                        "emission",        "environment"};

SceneBuilder everything() {
    SceneBuilder b;
    b.object(Plane{}, b.material(Glossy{Color{0.5, 0.4, 0.3}}));
    b.object(Sphere{0.7}, b.material(Glass{1.5, Color{0.2, 0.4, 0.6}}), {-1.6, 0.7, 0});
    b.object(Sphere{0.7}, b.material(Metal{}), {0, 0.7, 0});
    b.object(Quad{{1, 1}}, b.material(Translucent{}),
             {1.6, 2.6, 0});  // Lit from below and from above.
    Glass sheet;
    sheet.thin = true;
    b.object(Disk{0.5}, b.material(sheet), {-0.5, 2.2, 1});
    b.object(Box{{0.6, 0.6, 0.6}}, b.material(Mix{{b.material(Phong{}), false}, {{}, true}, 0.4}),
             {0.8, 0.3, 1.4});
    b.object(Sphere{0.3}, {}, {0, 2, 0.5}, grey(8));
    b.pointLight({2, 3, 2}, grey(9));
    b.scene().environment.color = grey(0.3);
    b.camera({0, 2, 6}, {0, 0.8, 0}, 40);
    b.film(40, 30, 8);
    return b;
}

TEST(Layers, OfLightSumToThePicture) {
    const Channels layers = layersOf(everything());
    std::map<std::string, double> totals;
    for (const char* letter : {"R", "G", "B"})
        for (std::size_t i = 0; i < layers.at(letter).size(); ++i) {
            double sum = 0;
            for (const char* name : kLight) {
                const double value =
                    static_cast<double>(layers.at(std::string(name) + "." + letter)[i]);
                ASSERT_GE(value, 0);
                totals[name] += value;
                sum += value;
            }
            const double beauty = static_cast<double>(layers.at(letter)[i]);
            ASSERT_NEAR(sum, beauty, 2e-5 * beauty + 1e-7) << letter << " of pixel " << i;
        }
    for (const char* name : kLight)
        EXPECT_GT(totals[name], 0) << name << " is empty, so the sum shows nothing of it";
}

TEST(Layers, DoNotChangeThePicture) {
    const SceneBuilder b = everything();
    const Rendering with = render(b.compile(), {.threads = 2, .layers = true});
    EXPECT_EQ(with.beauty.rgb, b.render().beauty.rgb);
}

TEST(Layers, DescribeTheFirstSurface) {
    SceneBuilder b;
    const MaterialId red = b.material(Diffuse{Color{0.6, 0.2, 0.1}});
    const ObjectId ball = b.object(Sphere{1}, red, {10, 20, 30});
    b.camera({10, 20, 35}, {10, 20, 30}, 60);
    b.film(9, 9, 4);
    b.scene().film.filterRadius = 1e-9;
    const Channels layers = layersOf(b);
    const std::size_t middle = 4 * 9 + 4, corner = 0;
    EXPECT_FLOAT_EQ(layers.at("albedo.R")[middle], 0.6f);
    EXPECT_FLOAT_EQ(layers.at("albedo.B")[middle], 0.1f);
    EXPECT_NEAR(layers.at("normal.Z")[middle], 1, 1e-6);
    EXPECT_NEAR(layers.at("depth.Z")[middle], 4, 1e-6);
    EXPECT_NEAR(layers.at("position.X")[middle], 10, 1e-5);
    EXPECT_NEAR(layers.at("position.Z")[middle], 31, 1e-5);
    EXPECT_EQ(layers.at("object_id.id")[middle], static_cast<float>(ball.value));
    EXPECT_EQ(layers.at("material_id.id")[middle], 1);
    EXPECT_EQ(layers.at("sample_count.n")[middle], 4);
    EXPECT_EQ(layers.at("object_id.id")[corner], 0);
    EXPECT_EQ(layers.at("depth.Z")[corner], 1e10f);
}

TEST(Layers, DirectDiffuseIsTheClosedForm) {
    SceneBuilder b;
    b.object(Plane{}, b.material(Diffuse{grey(0.5)}));
    b.pointLight({0, 2, 0}, grey(8));
    b.camera({0, 0.5, 0}, {0, 0, 0}, 0.01);
    b.film(4, 4, 4);
    const Channels layers = layersOf(b);
    EXPECT_NEAR(layers.at("diffuse_direct.R")[5], 0.5 / kPi * 8 / 4, 1e-5);
    EXPECT_EQ(layers.at("diffuse_indirect.R")[5], 0);
    EXPECT_EQ(layers.at("glossy_direct.R")[5], 0);
}

TEST(Layers, ErrorIsTheStandardErrorOfTheMean) {
    // Over many pixels of one true value, the root mean square of the estimates must be the spread
    // of the pixels.
    SceneBuilder b;
    b.object(Plane{}, b.material(Diffuse{grey(0.5)}));
    b.object(Sphere{1}, {}, {0, 2, 0}, grey(4));
    b.object(Box{{2, 0.1, 2}}, {}, {1, 0.7, 0});
    b.camera({0, 0.01, 0}, {0, 0, 0}, 0.01);
    b.film(64, 64, 16);
    b.scene().render.spp = 16;
    const Rendering rendering = render(b.compile(), {.threads = 2, .layers = true});
    const test::Estimate spread = test::estimateMean(rendering.beauty);
    double squares = 0;
    for (const ExrChannel& channel : rendering.layers)
        if (channel.name == "error.sigma")
            for (const float v : channel.values)
                squares += static_cast<double>(v) * static_cast<double>(v);
    const double claimed = std::sqrt(squares / (64 * 64)),
                 found = spread.sigma * std::sqrt(64.0 * 64 - 1);
    EXPECT_NEAR(claimed, found, 0.1 * found);
}

TEST(Layers, AreReadByOtherPrograms) {
    if (std::system("command -v oiiotool > /dev/null") != 0)
        GTEST_SKIP() << "oiiotool is not installed";
    const auto folder = std::filesystem::temp_directory_path() / "glint-layers-test";
    std::filesystem::create_directories(folder);
    const auto file = folder / "layers.exr";
    const SceneBuilder b = everything();
    const Rendering rendering = render(b.compile(), {.threads = 2, .layers = true});
    ASSERT_TRUE(saveExr(file, {40, 30, rendering.layers, {}}));
    // oiiotool adds up the light layers' red and compares with R itself.
    std::string command = "oiiotool -i " + file.string() + " --ch R=diffuse_direct.R";
    for (std::size_t i = 1; i < std::size(kLight); ++i)
        command += " -i " + file.string() + " --ch R=" + kLight[i] + ".R --add";
    command += " -i " + file.string() + " --ch R --fail 0.001 --diff > /dev/null";
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
    std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace glint
