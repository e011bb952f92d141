// Files that are no scenes, or large, or meant to harm: one error, soon, and no crash.
#include <gtest/gtest.h>

#include <random>

#include "tests/support/temp_folder.h"
#include "tracer/io/scene_json.h"

namespace glint {
namespace {

using test::TempFolder;

std::string errorOf(const std::string& content) {
    const TempFolder folder;
    const auto path = folder.write("a.json", content);
    const auto scene = loadScene(path);
    EXPECT_FALSE(scene);
    EXPECT_FALSE(loadSceneInPart(path));
    const std::string text = scene.error().text();
    EXPECT_EQ(text.find('\n'), std::string::npos);
    EXPECT_LT(text.size(), 600u);
    return text.substr(folder.path().string().size() + 1);
}

std::string validFile() {
    Scene scene;
    for (int i = 0; i < 20; ++i)
        scene.objects.add({.name = "Ball " + std::to_string(i), .emission = {0.1, 0.2, 0.3}});
    return formatScene(scene);
}

std::string repeated(std::string_view text, int count) {
    std::string out;
    for (int i = 0; i < count; ++i) out += text;
    return out;
}

TEST(HostileScene, EmptyFile) {
    EXPECT_EQ(errorOf(""), "a.json: the file is empty (a scene begins with {\"glint\": 1)");
    EXPECT_EQ(errorOf(" \n\t "), "a.json: the file is empty (a scene begins with {\"glint\": 1)");
}

TEST(HostileScene, EveryTruncationIsAnError) {
    const std::string text = validFile();
    for (std::size_t length = 1; length + 3 < text.size(); length += 7)
        ASSERT_FALSE(parseScene(std::string_view(text).substr(0, length), "a")) << length;
}

TEST(HostileScene, TruncationNamesTheEnd) {
    EXPECT_EQ(errorOf("{\"glint\": 1,\n \"film\": {\"width\""),
              "a.json:2:18: syntax error while parsing object separator - unexpected end of input; "
              "expected ':' "
              "(correct the JSON here: text in double quotes, finite numbers, no comments)");
}

TEST(HostileScene, RandomBytes) {
    std::mt19937 random(7);
    for (int round = 0; round < 5; ++round) {
        std::string bytes(1 << 20, '\0');
        for (char& c : bytes) c = static_cast<char>(random());
        EXPECT_NE(errorOf(bytes).find("a.json:"), std::string::npos);
    }
}

TEST(HostileScene, ChangedBytesNeverCrash) {
    std::mt19937 random(11);
    const std::string good = validFile();
    for (int round = 0; round < 3000; ++round) {
        std::string text = good;
        for (int i = 0; i < 3; ++i) text[random() % text.size()] = static_cast<char>(random());
        const auto scene = parseScene(text, "a");
        ASSERT_TRUE(scene || !scene.error().text().empty());
    }
}

TEST(HostileScene, DeepNesting) {
    const std::string reason = "nested deeper than 128 levels (a scene needs fewer than ten)";
    EXPECT_EQ(errorOf(repeated("[", 200000)), "a.json:1:129: " + reason);
    EXPECT_EQ(errorOf("{\"glint\": 1,\n\"editor\": " + repeated("{\"a\":", 200000)),
              "a.json:2:646: " + reason);
    EXPECT_EQ(errorOf(repeated("[", 200000) + repeated("]", 200000)), "a.json:1:129: " + reason);
}

TEST(HostileScene, OtherEncodings) {
    const std::string utf16 = std::string("\xFF\xFE{\0\"\0g\0", 8);
    EXPECT_NE(errorOf(utf16).find("a.json:1:"), std::string::npos);
    EXPECT_NE(errorOf(std::string("{\"glint\": 1\0}", 13)).find("a.json:1:"), std::string::npos);
}

TEST(HostileScene, MissingFileAndFolder) {
    const TempFolder folder;
    EXPECT_EQ(loadScene(folder / "none.json").error().message,
              "cannot be read: No such file or directory");
    EXPECT_EQ(loadScene(folder.path()).error().message, "is a folder");
    EXPECT_EQ(loadScene("/dev/zero").error().message, "is a device");
    EXPECT_EQ(loadScene(folder.path()).error().file, folder.path().string());
}

TEST(HostileScene, LongChainsDoNotOverflowTheStack) {
    std::string groups, materials;
    constexpr int kLength = 20000;
    for (int i = 0; i < kLength; ++i) {
        const std::string name = std::to_string(i), next = std::to_string(i + 1);
        groups += (i ? "," : "") + ("{\"name\": \"" + name + "\"") +
                  (i + 1 < kLength ? ", \"parent\": \"" + next + "\"}" : "}");
        materials +=
            (i ? "," : "") +
            ("{\"name\": \"" + name + "\", \"type\": \"mix\", \"a\": \"clear\", \"b\": \"") +
            (i + 1 < kLength ? next : "clear") + "\"}";
    }
    EXPECT_TRUE(parseScene("{\"glint\": 1, \"groups\": [" + groups + "]}", "a"));
    EXPECT_EQ(parseScene("{\"glint\": 1, \"materials\": [" + materials + "]}", "a").error().message,
              "the mix blends more than 256 materials");
}

// The costs of names, keys, references and errors grow with the file, not with its square: the
// quadratic forms of these would take minutes.
TEST(HostileScene, LargeFilesAreReadInTimeProportionalToTheirSize) {
    constexpr int kCount = 100000;
    std::string text = "{\"glint\": 1, \"materials\": [";
    for (int i = 0; i < kCount; ++i)
        text +=
            (i ? "," : "") + ("{\"name\": \"m" + std::to_string(i) + "\", \"type\": \"mirror\"}");
    text += "], \"objects\": [";
    for (int i = 0; i < kCount; ++i)
        text += (i ? "," : "") + ("{\"name\": \"o" + std::to_string(i) +
                                  "\", \"shape\": {\"type\": \"sphere\"}, \"material\": \"m" +
                                  std::to_string(kCount - 1 - i) + "\"}");
    const std::string good = text + "], \"editor\": {";
    std::string keys;
    for (int i = 0; i < kCount; ++i) keys += (i ? "," : "") + ("\"" + std::to_string(i) + "\": 0");
    const auto scene = parseScene(good + keys + "}}", "a");
    ASSERT_TRUE(scene) << scene.error().text();
    EXPECT_EQ(scene.value().objects.size(), static_cast<std::size_t>(kCount));

    std::string bad = good + "}}";
    for (std::size_t at = bad.find("\"material\": \"m"); at != std::string::npos;
         at = bad.find("\"material\": \"m", at + 1))
        bad[at + 13] = 'x';
    const TempFolder folder;
    const auto partial = loadSceneInPart(folder.write("bad.json", bad));
    ASSERT_TRUE(partial);
    EXPECT_EQ(partial.value().leftOut.size(), static_cast<std::size_t>(kCount));
    EXPECT_EQ(partial.value().scene.objects.size(), 0u);
    EXPECT_EQ(partial.value().scene.materials.size(), static_cast<std::size_t>(kCount));
}

}  // namespace
}  // namespace glint
