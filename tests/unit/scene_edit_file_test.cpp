// Opening in part, saving whole or not at all, single settings, and the clipboard.
#include <gtest/gtest.h>

#include <sys/resource.h>

#include <algorithm>
#include <csignal>

#include "tests/support/random_scene.h"
#include "tests/support/temp_folder.h"
#include "tracer/io/scene_check.h"
#include "tracer/io/scene_json.h"
#include "tracer/scene/edit.h"

namespace glint {
namespace {

namespace fs = std::filesystem;
using test::TempFolder;

/// One fault of each kind among good entries.
constexpr const char* kFaulty = R"({"glint": 1,
"film": {"width": -3}, "render": {"spp": 5},
"textures": [{"name": "t", "type": "wood"}],
"materials": [
  {"name": "good", "type": "mirror"},
  {"name": "bad", "type": "miror"},
  {"name": "textured", "type": "diffuse", "color": {"texture": "t"}},
  {"name": "mixed", "type": "mix", "a": "bad", "b": "good"}],
"groups": [{"name": "flat", "transform": {"scale": [0, 1, 1]}}],
"objects": [
  {"name": "a", "shape": {"type": "sphere"}, "material": "bad"},
  {"name": "b", "shape": {"type": "sphere", "radius": -1}, "material": "good"},
  {"name": "c", "shape": {"type": "sphere"}, "material": "good", "parent": "flat"}],
"views": [{"up": [0, 0, 0]}, {"ortho_height": 3}],
"extra": 1})";

TEST(SceneInPart, KeepsTheGoodAndListsTheRest) {
    const TempFolder folder;
    const auto partial = loadSceneInPart(folder.write("a.json", kFaulty));
    ASSERT_TRUE(partial) << partial.error().text();
    const Scene& scene = partial.value().scene;
    EXPECT_EQ(scene.film, FilmSettings{});
    EXPECT_EQ(scene.render.spp, 5);
    EXPECT_EQ(scene.textures.size(), 0u);
    EXPECT_EQ(scene.materials.size(), 3u);
    EXPECT_EQ(scene.groups.size(), 0u);
    ASSERT_EQ(scene.views.size(), 1u);
    EXPECT_EQ(scene.views[0].orthoHeight, 3);
    std::vector<std::string> names;
    scene.objects.forEach([&](ObjectId, const Object& object) { names.push_back(object.name); });
    EXPECT_EQ(names, (std::vector<std::string>{"a", "c"}));
    EXPECT_FALSE(scene.objects.at({1}).material);
    EXPECT_FALSE(scene.objects.at({3}).parent);
    EXPECT_TRUE(std::get<Mix>(scene.materials.at({4}).value).a.clear);
    EXPECT_TRUE(sceneProblems(scene).empty());
    EXPECT_TRUE(parseScene(formatScene(scene), "again"));
}

TEST(SceneInPart, SaysWhatLostSomething) {
    const TempFolder folder;
    const auto partial = loadSceneInPart(folder.write("a.json", kFaulty));
    ASSERT_TRUE(partial);
    std::string all;
    for (const Error& error : partial.value().leftOut) {
        EXPECT_GT(error.line, 0) << error.text();
        all += error.text() + "\n";
    }
    EXPECT_NE(all.find("a.json:2:19: /film/width: -3 is too small"), std::string::npos) << all;
    EXPECT_NE(
        all.find("a.json:11:58: /objects/0/material: \"a\" lost its material, which was left out"),
        std::string::npos)
        << all;
    EXPECT_NE(all.find("/objects/2/parent: \"c\" lost its group, which was left out"),
              std::string::npos)
        << all;
    EXPECT_NE(all.find("/materials/2/color: lost its texture"), std::string::npos) << all;
    EXPECT_NE(all.find("/materials/3/a: lost its material, which was left out; it is clear now"),
              std::string::npos)
        << all;
    EXPECT_NE(all.find("/extra: unknown field"), std::string::npos) << all;
}

TEST(SceneInPart, AGoodFileLosesNothing) {
    const TempFolder folder;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const Scene scene = test::randomScene(seed);
        const auto partial = loadSceneInPart(folder.write("a.json", formatScene(scene)));
        ASSERT_TRUE(partial);
        EXPECT_TRUE(partial.value().leftOut.empty());
        EXPECT_TRUE(partial.value().scene == scene);
    }
}

TEST(SceneInPart, BreaksCycles) {
    const TempFolder folder;
    const auto partial = loadSceneInPart(folder.write("a.json", R"({"glint": 1,
      "groups": [{"name": "a", "parent": "b"}, {"name": "b", "parent": "a"}],
      "materials": [{"name": "m", "type": "mix", "a": "n", "b": "clear"}, {"name": "n", "type": "mix", "a": "m", "b": "clear"}]})"));
    ASSERT_TRUE(partial);
    EXPECT_EQ(partial.value().scene.groups.size(), 1u);
    EXPECT_EQ(partial.value().scene.materials.size(), 1u);
    EXPECT_TRUE(sceneProblems(partial.value().scene).empty());
}

TEST(SaveScene, ReplacesTheFileAndLeavesNothingElse) {
    const TempFolder folder;
    const Scene scene = test::randomScene(3);
    ASSERT_TRUE(saveScene(Scene{}, folder / "a.json"));
    ASSERT_TRUE(saveScene(scene, folder / "a.json"));
    EXPECT_EQ(test::fileContent(folder / "a.json"), formatScene(scene));
    EXPECT_EQ(folder.count(), 1u);
}

TEST(SaveScene, KeepsTheOldFileWhenTheDiskIsFull) {
    const TempFolder folder;
    const fs::path path = folder.write("a.json", "old");
    Scene scene;
    for (int i = 0; i < 1000; ++i) scene.objects.add({.name = "Ball " + std::to_string(i)});
    rlimit before{};
    ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
    rlimit small = before;
    small.rlim_cur = 4096;
    const auto oldHandler = std::signal(SIGXFSZ, SIG_IGN);
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
    const Status saved = saveScene(scene, path);
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, oldHandler);
    ASSERT_FALSE(saved);
    EXPECT_EQ(saved.error().message, "could not be written: File too large");
    EXPECT_EQ(saved.error().file, path.string());
    EXPECT_EQ(test::fileContent(path), "old");
    EXPECT_EQ(folder.count(), 1u);
}

TEST(SaveScene, RefusesFoldersDevicesAndMissingPlaces) {
    const TempFolder folder;
    EXPECT_EQ(saveScene({}, folder.path()).error().message, "is a folder");
    EXPECT_EQ(saveScene({}, "/dev/null").error().message, "is not a file");
    EXPECT_EQ(saveScene({}, folder / "none/a.json").error().message,
              "cannot be written: No such file or directory");
}

TEST(SaveScene, FollowsLinksAndKeepsPermissions) {
    const TempFolder folder;
    const fs::path real = folder.write("real.json", "old");
    fs::permissions(real, fs::perms::owner_read | fs::perms::owner_write);
    fs::create_symlink("real.json", folder / "link.json");
    ASSERT_TRUE(saveScene({}, folder / "link.json"));
    EXPECT_TRUE(fs::is_symlink(folder / "link.json"));
    EXPECT_EQ(test::fileContent(real), formatScene({}));
    EXPECT_EQ(fs::status(real).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

Scene ballAndMirror() {
    Scene scene;
    const MaterialId mirror = scene.materials.add({"Mirror", Mirror{}});
    scene.objects.add({.name = "Box", .shape = Box{}});
    scene.objects.add({.name = "Ball", .material = mirror});
    return scene;
}

TEST(Setting, ChangesOneValueByIndexOrName) {
    const Scene scene = ballAndMirror();
    const auto byName = withSetting(scene, "/objects/Ball/shape/radius", "2.5");
    ASSERT_TRUE(byName) << byName.error().text();
    const auto byIndex = withSetting(scene, "/objects/1/shape/radius", "2.5");
    ASSERT_TRUE(byIndex) << byIndex.error().text();
    EXPECT_TRUE(byName.value() == byIndex.value());
    Scene expected = scene;
    Object ball = scene.objects.at({2});
    ball.shape = Sphere{2.5};
    expected.objects.set({2}, ball);
    EXPECT_TRUE(byName.value() == expected);
}

TEST(Setting, TakesJsonOrElseText) {
    const Scene scene = ballAndMirror();
    EXPECT_EQ(withSetting(scene, "/render/integrator", "classic").value().render.integrator,
              Integrator::Classic);
    EXPECT_EQ(withSetting(scene, "/render/integrator", "\"classic\"").value().render.integrator,
              Integrator::Classic);
    EXPECT_EQ(withSetting(scene, "/environment/color", "[1, 2, 3]").value().environment.color,
              (Color{1, 2, 3}));
    EXPECT_EQ(withSetting(scene, "/objects/Ball/emission/1", "7").value().objects.at({2}).emission,
              (Color{0, 7, 0}));
    EXPECT_EQ(
        withSetting(scene, "/environment/sky/turbidity", "5").value().environment.sky->turbidity,
        5);
}

TEST(Setting, ErrorsNameThePointerAndSuggest) {
    const Scene scene = ballAndMirror();
    EXPECT_EQ(withSetting(scene, "/render/sp", "4").error().text(),
              "/render/sp: unknown field \"sp\" (did you mean \"spp\"?)");
    EXPECT_EQ(withSetting(scene, "/objects/Bal/visible", "true").error().text(),
              "/objects/Bal/visible: there is no \"Bal\" (did you mean \"Ball\"?)");
    EXPECT_EQ(withSetting(scene, "/objects/7/visible", "true").error().message,
              "there is no \"7\"");
    EXPECT_EQ(withSetting(scene, "/render/spp", "many").error().message,
              "expected a number, found a string");
    EXPECT_EQ(withSetting(scene, "/render/spp", "0").error().pointer, "/render/spp");
    EXPECT_EQ(withSetting(scene, "render/spp", "4").error().message, "is not a pointer to a value");
    EXPECT_EQ(withSetting(scene, "", "4").error().message, "is not a pointer to a value");
    EXPECT_EQ(withSetting(scene, "/render/spp/x", "4").error().message,
              "the value before \"x\" has no fields");
    EXPECT_EQ(withSetting(scene, "/objects/Ball/material", "Miror").error().remedy,
              "did you mean \"Mirror\"?");
}

TEST(Setting, EveryScalarOfARandomSceneCanBeSetToItsOwnValue) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const Scene scene = test::randomScene(seed);
        const auto same = withSetting(scene, "/render/spp", std::to_string(scene.render.spp));
        ASSERT_TRUE(same) << same.error().text();
        EXPECT_TRUE(same.value() == scene);
    }
}

/// A group in a group, a mix of two materials, one with a texture, and a ball that uses all of it.
Scene withDependencies() {
    Scene scene;
    scene.materials.add({"Unused", Mirror{}});
    const TextureId texture = scene.textures.add({.name = "Checker", .type = TextureType::Checker});
    Diffuse textured;
    textured.color.texture = texture;
    const MaterialId a = scene.materials.add({"A", textured}),
                     b = scene.materials.add({"B", Glass{}});
    const MaterialId mix = scene.materials.add({"Mix", Mix{{a, false}, {b, false}, {0.25}}});
    const GroupId outer =
        scene.groups.add({.name = "Outer", .transform = {.translate = {1, 2, 3}}});
    const GroupId inner = scene.groups.add({.name = "Inner", .parent = outer});
    scene.objects.add({.name = "Ball", .material = mix, .parent = inner});
    return scene;
}

TEST(Clipboard, TextHoldsWhatTheObjectsReferTo) {
    const Scene scene = withDependencies();
    const auto alone = parseScene(formatObjects(scene, {{1}}), "x");
    ASSERT_TRUE(alone) << alone.error().text();
    EXPECT_EQ(alone.value().objects.size(), 1u);
    EXPECT_EQ(alone.value().materials.size(), 3u);
    EXPECT_EQ(alone.value().textures.size(), 1u);
    EXPECT_EQ(alone.value().groups.size(), 2u);
}

TEST(Clipboard, PastingIntoAnotherSceneBringsEverything) {
    const Scene scene = withDependencies();
    const auto pasted = pasteObjects({}, formatObjects(scene, {{1}}));
    ASSERT_TRUE(pasted) << pasted.error().text();
    ASSERT_EQ(pasted.value().added.size(), 1u);
    const Scene& other = pasted.value().scene;
    const Object& ball = other.objects.at(pasted.value().added[0]);
    EXPECT_EQ(ball.name, "Ball");
    EXPECT_EQ(other.materials.at(ball.material).name, "Mix");
    EXPECT_EQ(worldFromObject(other, ball), worldFromObject(scene, scene.objects.at({1})));
}

TEST(Clipboard, PastingIntoTheSameSceneSharesMaterialsAndGroups) {
    const Scene scene = withDependencies();
    const auto pasted = pasteObjects(scene, formatObjects(scene, {{1}}));
    ASSERT_TRUE(pasted) << pasted.error().text();
    const Scene& both = pasted.value().scene;
    EXPECT_TRUE(both.materials == scene.materials);
    EXPECT_TRUE(both.groups == scene.groups);
    EXPECT_TRUE(both.textures == scene.textures);
    Object expected = scene.objects.at({1});
    expected.name = "Ball 2";
    EXPECT_EQ(both.objects.at(pasted.value().added[0]), expected);
}

TEST(Clipboard, SameNameWithOtherContentIsCopied) {
    const Scene scene = withDependencies();
    Scene other;
    other.materials.add({"B", Mirror{}});
    const auto pasted = pasteObjects(other, formatObjects(scene, {{1}}));
    ASSERT_TRUE(pasted);
    EXPECT_EQ(pasted.value().scene.materials.size(), 4u);
    const Object& ball = pasted.value().scene.objects.at(pasted.value().added[0]);
    const auto& mix = std::get<Mix>(pasted.value().scene.materials.at(ball.material).value);
    EXPECT_EQ(pasted.value().scene.materials.at(mix.b.material).name, "B 2");
}

TEST(Clipboard, OtherTextIsAnError) {
    EXPECT_FALSE(pasteObjects({}, "hello"));
    EXPECT_FALSE(pasteObjects({}, R"({"objects": []})"));
}

TEST(Clipboard, RandomObjectsSurvive) {
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        const Scene scene = test::randomScene(seed);
        const auto pasted = pasteObjects(scene, formatObjects(scene, scene.objects.ids()));
        ASSERT_TRUE(pasted) << "seed " << seed << ": " << pasted.error().text();
        EXPECT_EQ(pasted.value().scene.objects.size(), 2 * scene.objects.size());
        EXPECT_TRUE(pasted.value().scene.materials == scene.materials) << seed;
    }
}

}  // namespace
}  // namespace glint
