// The scenes that come with Glint load, find their files, and hold what they are meant to show.
#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "tests/support/paths.h"
#include "tracer/io/scene_json.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> sceneFiles() {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(test::inSource("scenes")))
        if (entry.path().extension() == ".json") files.push_back(entry.path());
    return files;
}

TEST(Scenes, AllLoadAndTheirEnvironmentsExist) {
    const std::vector<fs::path> files = sceneFiles();
    ASSERT_GE(files.size(), 9u);
    for (const fs::path& file : files) {
        const Result<Scene> scene = loadScene(file);
        ASSERT_TRUE(scene) << scene.error().text();
        const std::string& image = scene.value().environment.image;
        EXPECT_TRUE(image.empty() || fs::exists(file.parent_path() / image))
            << file << " " << image;
    }
}

TEST(Scenes, SurviveFormattingAndParsing) {
    for (const fs::path& file : sceneFiles()) {
        const Result<Scene> scene = loadScene(file);
        ASSERT_TRUE(scene) << scene.error().text();
        const Result<Scene> again = parseScene(formatScene(scene.value()), file.string());
        ASSERT_TRUE(again) << again.error().text();
        EXPECT_TRUE(again.value() == scene.value()) << file;
    }
}

TEST(Scenes, ReportHoldsEveryEffectOfTheReport) {
    const Result<Scene> loaded = loadScene(test::inSource("scenes/report.json"));
    ASSERT_TRUE(loaded) << loaded.error().text();
    const Scene& scene = loaded.value();

    std::set<std::string_view> shapes, materials;
    int lamps = 0;
    scene.objects.forEach([&](ObjectId, const Object& object) {
        shapes.insert(kindOf(object.shape));
        if (object.material) materials.insert(kindOf(scene.materials.at(object.material).value));
        lamps += object.emission != Color{} && std::holds_alternative<Sphere>(object.shape);
    });
    EXPECT_EQ(shapes, (std::set<std::string_view>{"box", "plane", "sphere"}));
    EXPECT_EQ(materials, (std::set<std::string_view>{"diffuse", "glass", "mirror", "mix", "phong",
                                                     "translucent"}));
    EXPECT_EQ(lamps, 1);

    int points = 0;
    scene.lights.forEach([&](LightId, const Light& light) {
        points += std::holds_alternative<PointLight>(light.value);
    });
    EXPECT_EQ(points, 1);
    EXPECT_EQ(scene.environment.image, "../resources/env/studio.exr");
}

}  // namespace
}  // namespace glint
