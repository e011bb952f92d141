// Scene files keep everything: random documents survive writing and reading, and follow the schema.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "tests/support/paths.h"
#include "tests/support/random_scene.h"
#include "tests/support/schema_check.h"
#include "tests/support/temp_folder.h"
#include "tracer/io/scene_check.h"
#include "tracer/io/scene_json.h"

namespace glint {
namespace {

constexpr std::uint64_t kSeeds = 300;

/// The names of all fields in the tables.
template <class T>
void addFieldNames(std::set<std::string>& out, const T& value = {}) {
    forEachField(value, [&](std::string_view name, const FieldMeta&, const auto&) {
        out.insert(std::string(name));
    });
}

std::set<std::string> allFieldNames() {
    std::set<std::string> out;
    addFieldNames<Object>(out), addFieldNames<Group>(out), addFieldNames<Transform>(out),
        addFieldNames<Camera>(out);
    addFieldNames<FilmSettings>(out), addFieldNames<Display>(out),
        addFieldNames<RenderSettings>(out);
    addFieldNames<Environment>(out), addFieldNames<Sky>(out), addFieldNames<Texture>(out);
    const auto add = [&](const auto& value) { addFieldNames(out, value); };
    AllShapes::forEach(add), AllMaterials::forEach(add), AllLights::forEach(add);
    return out;
}

void addKeys(const nlohmann::json& json, std::set<std::string>& out) {
    for (const auto& [key, value] : json.items()) {
        if (json.is_object()) out.insert(key);
        if (value.is_structured()) addKeys(value, out);
    }
}

TEST(SceneFile, RandomScenesAreSound) {
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed)
        for (const Error& problem : sceneProblems(test::randomScene(seed)))
            ADD_FAILURE() << "seed " << seed << ": " << problem.text();
}

TEST(SceneFile, KeepsEveryFieldThroughWritingAndReading) {
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
        const Scene scene = test::randomScene(seed);
        const std::string text = formatScene(scene);
        const Result<Scene> again = parseScene(text, "again.json");
        ASSERT_TRUE(again) << "seed " << seed << ": " << again.error().text();
        ASSERT_TRUE(again.value() == scene) << "seed " << seed << "\n" << text;
        ASSERT_EQ(formatScene(again.value()), text) << "seed " << seed;
    }
}

TEST(SceneFile, RandomScenesHoldEveryFieldOfTheTables) {
    std::set<std::string> seen;
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed)
        addKeys(nlohmann::json::parse(formatScene(test::randomScene(seed))), seen);
    // A view transform has one value so far, its default, which is left out.
    for (const std::string& name : allFieldNames())
        EXPECT_TRUE(seen.contains(name) || name == "view") << name;
}

TEST(SceneFile, FollowsTheSchema) {
    const auto schema = nlohmann::json::parse(sceneSchema());
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
        const std::string text = formatScene(test::randomScene(seed));
        ASSERT_EQ(test::schemaFault(schema, nlohmann::json::parse(text)), "")
            << "seed " << seed << "\n"
            << text;
    }
}

TEST(SceneSchema, RejectsWhatTheReaderRejects) {
    const auto schema = nlohmann::json::parse(sceneSchema());
    for (const char* text :
         {R"({})", R"({"glint": 2})", R"({"glint": 1, "objcts": []})",
          R"({"glint": 1, "film": {"width": 0}})", R"({"glint": 1, "film": {"width": 1.5}})",
          R"({"glint": 1, "camera": {"up": 1}})",
          R"({"glint": 1, "camera": {"projection": "fish"}})",
          R"({"glint": 1, "objects": [{"shape": {"type": "sphere"}}]})",
          R"({"glint": 1, "materials": [{"name": "a", "type": "difuse"}]})",
          R"({"glint": 1, "lights": [{"name": "a", "type": "point", "intensity": [-1, 0, 0]}]})"}) {
        EXPECT_NE(test::schemaFault(schema, nlohmann::json::parse(text)), "") << text;
        EXPECT_FALSE(parseScene(text, "x.json")) << text;
    }
}

TEST(SceneSchema, InResourcesIsUpToDate) {
    EXPECT_TRUE(test::fileContent(test::inSource("resources/scene.schema.json")) == sceneSchema())
        << "write it anew: glint-render --schema > resources/scene.schema.json";
}

TEST(SceneFile, LeavesDefaultsOutAndWritesNumbersShort) {
    Scene scene;
    EXPECT_EQ(formatScene(scene), "{\n  \"glint\": 1\n}\n");
    scene.render.clamp = 0.1;
    scene.film.width = 7;
    EXPECT_EQ(
        formatScene(scene),
        "{\n  \"glint\": 1,\n  \"film\": {\"width\": 7},\n  \"render\": {\"clamp\": 0.1}\n}\n");
}

TEST(SceneFile, KeepsDoublesBitForBit) {
    Scene scene;
    for (const double value : {0.1, 1.0 / 3, 5e-324, 1.7976931348623157e308, 123456789012345680.0,
                               9007199254740993.0, -1e22}) {
        scene.environment.rotationDegrees = value;
        const auto again = parseScene(formatScene(scene), "x");
        ASSERT_TRUE(again) << again.error().text();
        EXPECT_EQ(again.value().environment.rotationDegrees, value);
    }
}

TEST(SceneFile, KeepsTheEditorsPart) {
    const auto scene =
        parseScene(R"({"glint": 1, "editor": {"z": [1, {"b": null}], "a": "x"}})", "x");
    ASSERT_TRUE(scene) << scene.error().text();
    EXPECT_EQ(scene.value().editor, R"({"z": [1, {"b": null}], "a": "x"})");
    EXPECT_NE(formatScene(scene.value()).find(scene.value().editor), std::string::npos);
}

TEST(SceneFile, HashTellsScenesApartAndStaysTheSame) {
    Scene scene;
    EXPECT_EQ(sceneHash(scene), "27624737462de3ce");
    scene.render.spp = 257;
    EXPECT_NE(sceneHash(scene), sceneHash(Scene{}));
    EXPECT_EQ(sceneHash(scene).size(), 16u);
}

TEST(SceneFile, SkipsAByteOrderMark) {
    const auto scene = parseScene("\xEF\xBB\xBF{\"glint\": 1, \"film\": {\"width\": 3}}", "x");
    ASSERT_TRUE(scene) << scene.error().text();
    EXPECT_EQ(scene.value().film.width, 3);
}

TEST(SceneFile, ReadsTheExampleOfTheFormat) {
    const auto scene = parseScene(R"({
      "glint": 1,
      "camera": {"position": [0, 2.2, 7.5], "target": [0, 0.9, 0], "vertical_fov_degrees": 38},
      "environment": {"image": "../resources/env/studio.exr", "intensity": 0.4, "rotation_degrees": 0},
      "materials": [{"name": "Glass", "type": "glass", "ior": 1.5, "absorption": [0.2, 0.05, 0.1]}],
      "objects": [
        {"name": "Ball", "shape": {"type": "sphere", "radius": 1}, "material": "Glass", "transform": {"translate": [-1.9, 1, 0.6]}},
        {"name": "Lamp", "shape": {"type": "sphere", "radius": 0.5}, "emission": [60, 56, 48]}],
      "lights": [{"name": "Key", "type": "point", "position": [2, 4, 3], "intensity": [20, 20, 20]}]})",
                                  "x");
    ASSERT_TRUE(scene) << scene.error().text();
    const Object& ball = scene.value().objects.at({1});
    EXPECT_EQ(ball.transform.translate, DVec3(-1.9, 1, 0.6));
    EXPECT_EQ(std::get<Glass>(scene.value().materials.at(ball.material).value).absorption.value,
              (Color{0.2, 0.05, 0.1}));
    EXPECT_EQ(scene.value().objects.at({2}).emission, (Color{60, 56, 48}));
    EXPECT_EQ(std::get<PointLight>(scene.value().lights.at({1}).value).position, DVec3(2, 4, 3));
}

}  // namespace
}  // namespace glint
