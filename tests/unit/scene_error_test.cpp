// Each thing that can be wrong in a scene file is refused with its place, its reason and what to
// do.
#include <gtest/gtest.h>

#include <ostream>

#include "tracer/io/scene_json.h"

namespace glint {
namespace {

struct Case {
    const char* name;
    const char* rest;  ///< of the file, after {"glint": 1,
    const char* pointer;
    const char* message;  ///< a part of it
    const char* remedy;   ///< a part of it
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.rest; }

class SceneError : public testing::TestWithParam<Case> {};

TEST_P(SceneError, NamesPlaceReasonAndRemedy) {
    const Case& c = GetParam();
    const auto scene = parseScene(std::string("{\"glint\": 1,\n") + c.rest + "}", "a.json");
    ASSERT_FALSE(scene);
    const Error& error = scene.error();
    EXPECT_EQ(error.file, "a.json");
    EXPECT_EQ(error.line, 2) << error.text();
    EXPECT_GT(error.column, 0) << error.text();
    EXPECT_EQ(error.pointer, c.pointer) << error.text();
    EXPECT_NE(error.message.find(c.message), std::string::npos) << error.text();
    EXPECT_NE(error.remedy.find(c.remedy), std::string::npos) << error.text();
    EXPECT_EQ(error.text().find('\n'), std::string::npos);
}

const Case kCases[] = {
    {"UnknownSection", R"("objcts": [])", "/objcts", "unknown field \"objcts\"", "\"objects\""},
    {"UnknownField", R"("film": {"widht": 3})", "/film/widht", "unknown field", "\"width\""},
    {"UnknownMaterialField",
     R"("materials": [{"name": "a", "type": "diffuse", "colour": [1,1,1]}])", "/materials/0/colour",
     "unknown field", "\"color\""},
    {"UnknownShape", R"("objects": [{"name": "a", "shape": {"type": "spere"}}])",
     "/objects/0/shape/type", "\"spere\" is not known", "\"sphere\""},
    {"UnknownChoice", R"("render": {"integrator": "whitted"})", "/render/integrator",
     "is not known", "path, classic"},
    {"UnknownMaterial",
     R"("materials": [{"name": "Red", "type": "mirror"}], "objects": [{"name": "a", "shape": {"type": "sphere"}, "material": "Rde"}])",
     "/objects/0/material", "there is no material \"Rde\"", "\"Red\""},
    {"UnknownGroup", R"("objects": [{"name": "a", "shape": {"type": "sphere"}, "parent": "g"}])",
     "/objects/0/parent", "there is no group", "there is none"},
    {"UnknownTexture",
     R"("materials": [{"name": "a", "type": "mirror", "color": {"texture": "t"}}])",
     "/materials/0/color/texture", "there is no texture", ""},
    {"UnknownCamera", R"("camera": "c")", "/camera", "there is no camera", ""},
    {"MissingName", R"("objects": [{"shape": {"type": "sphere"}}])", "/objects/0",
     "\"name\" is missing", "add it"},
    {"MissingMaterialName", R"("materials": [{"type": "mirror"}])", "/materials/0",
     "\"name\" is missing", "add it"},
    {"MissingCameraName", R"("cameras": [{}])", "/cameras/0", "\"name\" is missing", "add it"},
    {"EmptyName", R"("groups": [{"name": ""}])", "/groups/0/name", "is empty", "write"},
    {"MissingShape", R"("objects": [{"name": "a"}])", "/objects/0", "\"shape\" is missing",
     "add it"},
    {"MissingType", R"("lights": [{"name": "a"}])", "/lights/0", "\"type\" is missing",
     "point, spot, sun"},
    {"MissingMixPart", R"("materials": [{"name": "a", "type": "mix", "a": "clear"}])",
     "/materials/0", "\"b\" is missing", "add it"},
    {"DuplicateName", R"("lights": [{"name": "a", "type": "sun"}, {"name": "a", "type": "point"}])",
     "/lights/1/name", "\"a\" is taken by /lights/0", "of its own"},
    {"DuplicateKey", R"("film": {"width": 3, "width": 3})", "/film/width", "stands twice",
     "keep one"},
    {"DuplicateKeyInList", R"("objects": [{"name": "x"}, {"name": "a", "name": "b"}])",
     "/objects/1/name", "stands twice", "keep one"},
    {"DuplicateKeyInLargeObject",
     R"("editor": {"1":0,"2":0,"3":0,"4":0,"5":0,"6":0,"7":0,"8":0,"9":0,"10":0,"11":0,"12":0,"13":0,"14":0,"15":0,"16":0,"17":0,"18":0,"3":0})",
     "/editor/3", "stands twice", "keep one"},
    {"ScalarForVector", R"("camera": {"position": 1})", "/camera/position",
     "expected three numbers, found a number", "[1, 2, 3]"},
    {"ScalarForColour", R"("environment": {"color": 0.5})", "/environment/color",
     "expected a colour", "[1, 0.5, 0]"},
    {"ShortVector", R"("camera": {"position": [1, 2]})", "/camera/position", "found an array of 2",
     ""},
    {"TextForNumber", R"("film": {"width": "3"})", "/film/width",
     "expected a number, found a string", ""},
    {"NullForNumber", R"("film": {"width": null})", "/film/width", "expected a number, found null",
     ""},
    {"NumberForText", R"("environment": {"image": 3})", "/environment/image", "expected a text",
     ""},
    {"NumberForFlag", R"("environment": {"visible_to_camera": 1})",
     "/environment/visible_to_camera", "expected true or false", ""},
    {"FractionForCount", R"("film": {"width": 3.5})", "/film/width", "whole number, found 3.5",
     "round"},
    {"TooSmall", R"("film": {"width": 0})", "/film/width", "0 is too small",
     "at least 1 and at most 65536"},
    {"TooLarge", R"("film": {"width": 70000})", "/film/width", "70000 is too large",
     "at most 65536"},
    {"ExclusiveBound", R"("objects": [{"name": "a", "shape": {"type": "sphere", "radius": 0}}])",
     "/objects/0/shape/radius", "0 is too small", "above 0"},
    {"HugeWholeNumber", R"("render": {"seed": 123456789012345678901234567890})", "/render/seed",
     "is too large", "2147483647"},
    {"ColourOutOfRange",
     R"("materials": [{"name": "a", "type": "diffuse", "color": [0.5, 1.5, 0]}])",
     "/materials/0/color/1", "1.5 is too large", "at most 1"},
    {"NegativeRadiance",
     R"("objects": [{"name": "a", "shape": {"type": "sphere"}, "emission": [1, 1, -1]}])",
     "/objects/0/emission/2", "-1 is too small", ""},
    {"RadianceBeyondFloats",
     R"("objects": [{"name": "a", "shape": {"type": "sphere"}, "emission": [1e31, 1, 1]}])",
     "/objects/0/emission/0", "is too large", "1e+30"},
    {"EnvironmentBeyondFloats", R"("environment": {"color": [1e20, 0, 0], "intensity": 1e20})",
     "/environment/intensity", "beyond 1e30", "smaller"},
    {"NotAList", R"("objects": {})", "/objects", "expected a list", "[...]"},
    {"NotAnObject", R"("film": [])", "/film", "expected an object", "{...}"},
    {"NotAnObjectInList", R"("objects": [3])", "/objects/0", "expected an object", ""},
    {"ZeroScale",
     R"("objects": [{"name": "a", "shape": {"type": "sphere"}, "transform": {"scale": [1, 0, 1]}}])",
     "/objects/0/transform/scale", "a scale is 0", "another"},
    {"SingularMatrix",
     R"("groups": [{"name": "a", "transform": {"matrix": [1,0,0,0, 2,0,0,0, 0,0,1,0]}}])",
     "/groups/0/transform/matrix", "cannot be inverted", ""},
    {"MatrixBesideScale",
     R"("groups": [{"name": "a", "transform": {"scale": [1,1,1], "matrix": [1,0,0,0, 0,1,0,0, 0,0,1,0]}}])",
     "/groups/0/transform", "stands beside", "alone"},
    {"TinyWithItsGroup",
     R"("groups": [{"name": "g", "transform": {"scale": [1e-90, 1e-90, 1e-90]}}], "objects": [{"name": "a", "shape": {"type": "sphere"}, "parent": "g", "transform": {"scale": [1e-90, 1e-90, 1e-90]}}])",
     "/objects/0/transform", "together with its groups'", ""},
    {"GroupInItself", R"("groups": [{"name": "a", "parent": "a"}])", "/groups/0/parent",
     "contains itself", "another group"},
    {"GroupCycle",
     R"("groups": [{"name": "a", "parent": "c"}, {"name": "b", "parent": "a"}, {"name": "c", "parent": "b"}])",
     "/groups/1/parent", "contains itself", "another group"},
    {"MixOfItself", R"("materials": [{"name": "a", "type": "mix", "a": "a", "b": "clear"}])",
     "/materials/0", "contains itself", ""},
    {"MixCycle",
     R"("materials": [{"name": "a", "type": "mix", "a": "clear", "b": "b"}, {"name": "b", "type": "mix", "a": "a", "b": "clear"}])",
     "/materials/1", "contains itself", ""},
    {"MaterialNamedClear", R"("materials": [{"name": "clear", "type": "mirror"}])",
     "/materials/0/name", "\"clear\"", "another name"},
    {"TranslucentGivesTooMuch",
     R"("materials": [{"name": "a", "type": "translucent", "reflectance": [0.5, 0.6, 0.5], "transmittance": [0.5, 0.5, 0.5]}])",
     "/materials/0", "sum to more than 1", "lower"},
    {"EmittingPlane",
     R"("objects": [{"name": "a", "shape": {"type": "plane"}, "emission": [1, 1, 1]}])",
     "/objects/0/emission", "plane cannot emit", "quad"},
    {"GlassQuad",
     R"("materials": [{"name": "g", "type": "glass"}], "objects": [{"name": "a", "shape": {"type": "quad"}, "material": "g"}])",
     "/objects/0/material", "glass on a quad", "\"thin\""},
    {"GlassDiskThroughMixes",
     R"("materials": [{"name": "m", "type": "mix", "a": "n", "b": "clear"}, {"name": "n", "type": "mix", "a": "clear", "b": "g"}, {"name": "g", "type": "glass"}], "objects": [{"name": "a", "shape": {"type": "disk"}, "material": "m"}])",
     "/objects/0/material", "glass on a disk", "\"thin\""},
    {"CameraOnItsTarget", R"("camera": {"position": [1, 2, 3], "target": [1, 2, 3]})",
     "/camera/target", "target is its position", "move"},
    {"UpAlongTheView", R"("camera": {"position": [0, 5, 0], "target": [0, 0, 0]})", "/camera/up",
     "along the view", "[0, 0, -1]"},
    {"UpWithoutLength", R"("camera": {"up": [0, 0, 0]})", "/camera/up", "no direction", ""},
    {"AngleOfViewOf180", R"("camera": {"vertical_fov_degrees": 180})",
     "/camera/vertical_fov_degrees", "not below 180", ""},
    {"NamedCameraOnItsTarget",
     R"("cameras": [{"name": "c", "position": [0, 0, 0], "target": [0, 0, 0]}])",
     "/cameras/0/target", "target is its position", ""},
    {"TenViews", R"("views": [{}, {}, {}, {}, {}, {}, {}, {}, {}, {}])", "/views/9",
     "more than nine", "remove"},
    {"ImageAndSky", R"("environment": {"image": "a.exr", "sky": {}})", "/environment/sky",
     "both an image and a sky", "remove one"},
    {"SkyWithoutSun", R"("environment": {"sky": {"sun_direction": [0, 0, 0]}})",
     "/environment/sky/sun_direction", "no direction", ""},
    {"SunWithoutDirection", R"("lights": [{"name": "a", "type": "sun", "direction": [0, 0, 0]}])",
     "/lights/0/direction", "no direction", ""},
    {"SpotOnItsTarget",
     R"("lights": [{"name": "a", "type": "spot", "target": [1, 1, 1], "position": [1, 1, 1]}])",
     "/lights/0/target", "target is its position", ""},
    {"NotANumber", R"("film": {"filter_radius": NaN})", "", "invalid literal", "finite numbers"},
    {"Infinity", R"("film": {"filter_radius": Infinity})", "", "invalid literal", "finite numbers"},
    {"NumberBeyondDoubles", R"("film": {"filter_radius": 1e999})", "", "number overflow",
     "finite numbers"},
    {"Comment", R"("film": {} // wide)", "", "syntax error", "no comments"},
    {"MissingComma", R"("film": {} "render": {})", "", "syntax error", "correct the JSON"},
    {"BadUtf8", "\"film\": {\"\xFF\": 1}", "", "ill-formed UTF-8", ""},
    {"TextAfterTheEnd", R"("film": {}} {)", "", "expected end of input", ""},
};

INSTANTIATE_TEST_SUITE_P(Each, SceneError, testing::ValuesIn(kCases),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(SceneErrors, VersionIsRequiredAndKnown) {
    EXPECT_EQ(parseScene("{}", "a").error().text(),
              "a:1:1: is not a scene: it has no \"glint\" (begin it with {\"glint\": 1)");
    EXPECT_EQ(parseScene("[1]", "a").error().message, "is not a scene: it has no \"glint\"");
    EXPECT_EQ(parseScene("{\"glint\": 2}", "a").error().text(),
              "a:1:11: /glint: the file has version 2 of the format, this program knows 1 (open it "
              "with a newer Glint)");
    EXPECT_EQ(parseScene("{\"glint\": 0}", "a").error().pointer, "/glint");
    EXPECT_EQ(parseScene("{\"glint\": \"1\"}", "a").error().pointer, "/glint");
}

TEST(SceneErrors, LineAndColumnAreThoseOfTheValue) {
    const auto scene = parseScene(
        "{\n  \"glint\": 1,\n  \"film\": {\n    \"hei\\u0067ht\":   -2\n  }\n}", "a.json");
    ASSERT_FALSE(scene);
    EXPECT_EQ(
        scene.error().text(),
        "a.json:4:22: /film/height: -2 is too small (use a number at least 1 and at most 65536)");
}

TEST(SceneErrors, ColumnsCountCharactersNotBytes) {
    const auto scene = parseScene(
        "{\"glint\": 1, \"environment\": {\"image\": \"\xC3\xA4\xE7\x90\x83\", \"intensity\": -1}}",
        "a");
    ASSERT_FALSE(scene);
    EXPECT_EQ(scene.error().column, 58);
}

TEST(SceneErrors, StayOneShortLineWithHostileNames) {
    const std::string longName(100000, 'x');
    const auto scene = parseScene("{\"glint\": 1, \"fi\\nlm" + longName + "\": 1}", "a");
    ASSERT_FALSE(scene);
    const std::string text = scene.error().text();
    EXPECT_LT(text.size(), 500u);
    EXPECT_EQ(text.find('\n'), std::string::npos);
}

TEST(SceneErrors, ADuplicateOfAHostileNameStaysOneShortLine) {
    const std::string key = "\"a\\nb" + std::string(100000, 'x') + "\": 1";
    const std::string text = parseScene("{" + key + ", " + key + "}", "a").error().text();
    EXPECT_LT(text.size(), 500u);
    EXPECT_EQ(text.find('\n'), std::string::npos);
}

TEST(SceneErrors, NamesCannotTurnTheTextAroundThem) {
    const auto scene = parseScene(
        R"({"glint": 1, "objects": [{"name": "A", "shape": {"type": "plane"}, "material": "B\u202eé\u2066"}]})",
        "a");
    ASSERT_FALSE(scene);
    EXPECT_NE(scene.error().text().find("\"B?é?\""), std::string::npos) << scene.error().text();
}

TEST(SceneErrors, DecimalSharesThatSumToOneAreFine) {
    const auto scene = parseScene(
        R"({"glint": 1, "materials": [{"name": "a", "type": "translucent", "reflectance": [0.7, 0.9, 0.1], "transmittance": [0.3, 0.1, 0.9]}]})",
        "a");
    EXPECT_TRUE(scene) << scene.error().text();
}

TEST(SceneErrors, MixesMayNotGrowWithoutBound) {
    // Each mix doubles the one before: 2^40 leaves.
    std::string materials = R"({"name": "m0", "type": "mirror"})";
    for (int i = 1; i <= 40; ++i) {
        const std::string part = "\"m" + std::to_string(i - 1) + "\"";
        materials += ",{\"name\": \"m" + std::to_string(i) +
                     "\", \"type\": \"mix\", \"a\": " + part + ", \"b\": " + part + "}";
    }
    const auto scene = parseScene("{\"glint\": 1, \"materials\": [" + materials + "]}", "a");
    ASSERT_FALSE(scene);
    EXPECT_EQ(scene.error().message, "the mix blends more than 256 materials");
    EXPECT_EQ(scene.error().pointer, "/materials/9");
}

}  // namespace
}  // namespace glint
