// glint-render as a person or a script meets it: exit codes, messages, and the files that it
// leaves. Runs the built program.
#include <gtest/gtest.h>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/support/paths.h"
#include "tests/support/temp_folder.h"
#include "tracer/io/film_exr.h"
#include "tracer/io/image_file.h"
#include "tracer/io/rendering_file.h"
#include "tracer/io/scene_json.h"

extern char** environ;

namespace glint {
namespace {

namespace fs = std::filesystem;
using test::TempFolder;

constexpr const char* kScene =
    R"({"glint": 1, "film": {"width": 24, "height": 16}, "render": {"spp": 4, "seed": 3},
"environment": {"color": [0.5, 0.6, 0.7]},
"materials": [{"name": "Red", "type": "diffuse", "color": [0.7, 0.1, 0.1]}],
"objects": [{"name": "Ball", "shape": {"type": "sphere"}, "material": "Red"}],
"lights": [{"name": "Key", "type": "point", "position": [2, 4, 3], "intensity": [20, 20, 20]}]})";

struct Outcome {
    int code = -1;
    std::string out, err;
};

/// The program while it runs in a folder of its own with kScene as scene.json.
class Cli : public testing::Test {
  protected:
    void SetUp() override { folder_.write("scene.json", kScene); }

    pid_t start(const std::vector<std::string>& arguments) const {
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_addchdir_np(&actions, folder_.path().c_str());
        posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "stdout",
                                         O_WRONLY | O_CREAT | O_TRUNC, 0600);
        posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "stderr",
                                         O_WRONLY | O_CREAT | O_TRUNC, 0600);
        std::vector<std::string> words{test::renderProgram()};
        words.insert(words.end(), arguments.begin(), arguments.end());
        std::vector<char*> argv;
        for (std::string& word : words) argv.push_back(word.data());
        argv.push_back(nullptr);
        pid_t pid = -1;
        EXPECT_EQ(posix_spawn(&pid, words.front().c_str(), &actions, nullptr, argv.data(), environ),
                  0);
        posix_spawn_file_actions_destroy(&actions);
        return pid;
    }

    Outcome finish(pid_t pid) const {
        int status = 0;
        waitpid(pid, &status, 0);
        return {WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status),
                test::fileContent(folder_ / "stdout"), test::fileContent(folder_ / "stderr")};
    }

    Outcome run(const std::vector<std::string>& arguments) const {
        return finish(start(arguments));
    }

    /// Fails unless the program ends with `code` and says `words`.
    void expect(int code, const std::string& words,
                const std::vector<std::string>& arguments) const {
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.code, code) << outcome.err;
        EXPECT_NE((outcome.out + outcome.err).find(words), std::string::npos)
            << "wanted: " << words << "\ngot: " << outcome.err << outcome.out;
    }

    TempFolder folder_;
};

TEST_F(Cli, WritesEveryFormatAndEndsWith0) {
    for (const std::string& ending : writableEndings()) {
        const std::string name = "out" + ending;
        expect(0, "wrote " + name, {"scene.json", "-o", name});
        const auto image = loadImage(folder_ / name);
        ASSERT_TRUE(image) << image.error().text();
        EXPECT_EQ(image.value()->width, 24);
        EXPECT_EQ(image.value()->height, 16);
    }
}

TEST_F(Cli, QuietSaysNothing) {
    const Outcome outcome = run({"scene.json", "-o", "a.exr", "--quiet"});
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.out + outcome.err, "");
}

TEST_F(Cli, NoProgressBarWithoutATerminal) {
    EXPECT_EQ(run({"scene.json", "-o", "a.exr"}).err.find('\r'), std::string::npos);
}

TEST_F(Cli, HelpVersionAndSchemaEndWith0) {
    expect(0, "--crop", {"--help"});
    expect(0, "Exit codes: 0 done", {"--help"});
    expect(0, "glint-render ", {"--version"});
    EXPECT_EQ(run({"--schema"}).out, sceneSchema());
}

TEST_F(Cli, WrongUsageEndsWith1) {
    expect(1, "SCENE is required", {});
    expect(1, "-o FILE", {"scene.json"});
    expect(1, "ending is none of .exr", {"scene.json", "-o", "a.gif"});
    expect(1, "--colour", {"scene.json", "-o", "a.exr", "--colour"});
    expect(1, "WIDTHxHEIGHT", {"scene.json", "-o", "a.exr", "--size", "12"});
    expect(1, "WIDTHxHEIGHT", {"scene.json", "-o", "a.exr", "--size", "12x12x3"});
    expect(1, "--size: is out of range (use a number from 1 to 65536)",
           {"scene.json", "-o", "a.exr", "--size", "0x5"});
    expect(1, "--spp: is out of range (use a number from 1 to 16777216)",
           {"scene.json", "-o", "a.exr", "--spp", "0"});
    expect(1, "--spp", {"scene.json", "-o", "a.exr", "--spp", "many"});
    expect(1, "--time: is out of range (use a number of at least 0)",
           {"scene.json", "-o", "a.exr", "--time", "-1"});
    expect(1, "--integrator", {"scene.json", "-o", "a.exr", "--integrator", "whitted"});
    expect(1, "X,Y,WIDTH,HEIGHT", {"scene.json", "-o", "a.exr", "--crop", "1,2,3"});
    expect(1, "--crop: reaches out of the picture (the film is 24 x 16)",
           {"scene.json", "-o", "a.exr", "--crop", "20,0,5,5"});
    expect(1, "--pixel: there is no such sample", {"scene.json", "--pixel", "24,0,0"});
    expect(1, "/POINTER=VALUE", {"scene.json", "-o", "a.exr", "--set", "render"});
    expect(1, "did you mean \"spp\"?", {"scene.json", "-o", "a.exr", "--set", "/render/sp=3"});
    EXPECT_FALSE(fs::exists(folder_ / "a.exr"));
}

TEST_F(Cli, AWrongSceneEndsWith2AndOneLine) {
    folder_.write("empty.json", "");
    folder_.write("cut.json", std::string(kScene).substr(0, 100));
    folder_.write("deep.json", std::string(200000, '['));
    folder_.write("misspelt.json", R"({"glint": 1, "objcts": []})");
    folder_.write("twice.json", R"({"glint": 1, "film": {}, "film": {}})");
    const std::vector<std::pair<std::string, std::string>> cases{
        {"none.json", "No such file"},
        {"empty.json", "the file is empty"},
        {"cut.json", "cut.json:2:"},
        {"deep.json", "nested deeper"},
        {"misspelt.json", "did you mean \"objects\"?"},
        {"twice.json", "stands twice"}};
    for (const auto& [name, words] : cases) {
        const Outcome outcome = run({name, "-o", "a.exr"});
        EXPECT_EQ(outcome.code, 2) << name;
        EXPECT_EQ(outcome.err.find("glint-render: " + name), 0u) << outcome.err;
        EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
        EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    }
    EXPECT_FALSE(fs::exists(folder_ / "a.exr"));
}

TEST_F(Cli, AFilmLargerThanTheMemoryEndsWith2BeforeRendering) {
    expect(2, "GB of memory", {"scene.json", "-o", "a.exr", "--size", "65536x65536"});
}

TEST_F(Cli, AMissingAssetEndsWith2) {
    expect(2, "none.exr", {"scene.json", "-o", "a.exr", "--set", "/environment/image=none.exr"});
    EXPECT_FALSE(fs::exists(folder_ / "a.exr"));
}

TEST_F(Cli, AnOutputThatCannotBeWrittenEndsWith3BeforeRendering) {
    const auto before = std::chrono::steady_clock::now();
    expect(3, "none/a.exr: cannot be written",
           {"scene.json", "-o", "none/a.exr", "--spp", "1000000"});
    expect(3, "none/s.json: cannot be written",
           {"scene.json", "-o", "a.exr", "--stats", "none/s.json", "--spp", "1000000"});
    fs::create_directory(folder_ / "d.png");
    expect(3, "d.png: is a folder", {"scene.json", "-o", "d.png", "--spp", "1000000"});
    EXPECT_LT(std::chrono::steady_clock::now() - before, std::chrono::seconds(20));
    EXPECT_FALSE(fs::exists(folder_ / "a.exr"));
}

TEST_F(Cli, InterruptedWritesWhatThereIsAndEndsWith130) {
    const pid_t pid =
        start({"scene.json", "-o", "a.exr", "--spp", "16000000", "--stats", "s.json"});
    std::this_thread::sleep_for(std::chrono::milliseconds(700));
    kill(pid, SIGINT);
    const Outcome outcome = finish(pid);
    EXPECT_EQ(outcome.code, 130);
    EXPECT_NE(outcome.err.find("interrupted; wrote a.exr with "), std::string::npos) << outcome.err;
    const auto image = loadImage(folder_ / "a.exr");
    ASSERT_TRUE(image) << image.error().text();
    EXPECT_GT(image.value()->rgb[2], 0.0F);
    EXPECT_EQ(nlohmann::json::parse(test::fileContent(folder_ / "s.json"))["interrupted"], true);
}

TEST_F(Cli, StatsHoldTheirKeys) {
    expect(0, "",
           {"scene.json", "-o", "a.exr", "--stats", "s.json", "--threads", "2", "--integrator",
            "classic", "--seed", "9"});
    const auto stats = nlohmann::json::parse(test::fileContent(folder_ / "s.json"));
    EXPECT_EQ(stats["scene"], "scene.json");
    EXPECT_EQ(stats["integrator"], "classic");
    EXPECT_EQ(stats["width"], 24);
    EXPECT_EQ(stats["height"], 16);
    EXPECT_EQ(stats["spp"], 4);
    EXPECT_EQ(stats["threads"], 2);
    EXPECT_EQ(stats["seed"], 9);
    EXPECT_GE(stats["setup_seconds"].get<double>(), 0);
    EXPECT_GT(stats["render_seconds"].get<double>(), 0);
    EXPECT_GE(stats["rays"]["primary"].get<int>(), 24 * 16 * 4);
    EXPECT_GT(stats["rays"]["shadow"].get<int>(), 0);
    EXPECT_TRUE(stats["rays"].contains("scatter"));
    EXPECT_EQ(stats["nonfinite_samples"], 0);
    EXPECT_TRUE(stats["features"].is_array());
    EXPECT_TRUE(stats["kernel"].is_string());
    EXPECT_GT(stats["peak_memory_bytes"].get<double>(), 1e6);
    EXPECT_TRUE(stats["warnings"].is_array());
}

TEST_F(Cli, ExrTellsWhatItShows) {
    expect(0, "", {"scene.json", "-o", "a.exr"});
    const auto file = loadExr(folder_ / "a.exr");
    ASSERT_TRUE(file);
    const ImageMetadata& metadata = file.value().metadata;
    EXPECT_EQ(metadata.at("glint:seed"), "3");
    EXPECT_EQ(metadata.at("glint:spp"), "4");
    EXPECT_EQ(metadata.at("glint:sceneHash"),
              sceneHash(worldOf(loadScene(folder_ / "scene.json").value())));
    EXPECT_FALSE(metadata.at("glint:version").empty());
}

TEST_F(Cli, ClampedPicturesSayThatTheyAreBiased) {
    const Outcome clamped = run({"scene.json", "-o", "clamped.exr", "--set", "/render/clamp=2"}),
                  whole = run({"scene.json", "-o", "whole.exr"});
    ASSERT_EQ(clamped.code, 0) << clamped.err;
    ASSERT_EQ(whole.code, 0) << whole.err;
    EXPECT_NE(clamped.err.find("biased"), std::string::npos) << clamped.err;
    EXPECT_EQ(whole.err.find("biased"), std::string::npos) << whole.err;
    const auto a = loadRaw(folder_ / "clamped.exr"), b = loadRaw(folder_ / "whole.exr");
    ASSERT_TRUE(a && b);
    EXPECT_TRUE(a.value().metadata.contains("glint:biased"));
    EXPECT_FALSE(b.value().metadata.contains("glint:biased"));
}

TEST_F(Cli, SettingsAndOptionsChangeTheScene) {
    expect(0, "",
           {"scene.json", "-o", "a.exr", "--size", "10x8", "--spp", "2", "--set",
            "/environment/color=[4,4,4]", "--set", "/objects/Ball/visible=false", "--set",
            "/lights/Key/visible=false"});
    const auto image = loadImage(folder_ / "a.exr");
    ASSERT_TRUE(image);
    EXPECT_EQ(image.value()->width, 10);
    for (const float value : image.value()->rgb) EXPECT_FLOAT_EQ(value, 4);
}

TEST_F(Cli, CropIsThatPartOfTheWholePicture) {
    expect(0, "", {"scene.json", "-o", "whole.exr"});
    expect(0, "", {"scene.json", "-o", "part.exr", "--crop", "5,3,10,8"});
    const auto whole = loadImage(folder_ / "whole.exr"), part = loadImage(folder_ / "part.exr");
    ASSERT_TRUE(whole && part);
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 24; ++x) {
            const bool inside = x >= 5 && x < 15 && y >= 3 && y < 11;
            const auto i = static_cast<std::size_t>(3 * (y * 24 + x));
            ASSERT_EQ(part.value()->rgb[i], inside ? whole.value()->rgb[i] : 0.0F) << x << " " << y;
        }
}

TEST_F(Cli, PixelPrintsTheSamplesOfThePicture) {
    expect(0, "", {"scene.json", "-o", "a.exr", "--spp", "1"});
    const auto image = loadImage(folder_ / "a.exr");
    ASSERT_TRUE(image);
    const Outcome outcome = run({"scene.json", "--pixel", "12,8,0", "--spp", "1"});
    EXPECT_EQ(outcome.code, 0);
    std::array<float, 3> value{};
    ASSERT_EQ(std::sscanf(outcome.out.c_str(), "%f %f %f", &value[0], &value[1], &value[2]), 3)
        << outcome.out;
    for (std::size_t c = 0; c < 3; ++c)
        EXPECT_FLOAT_EQ(value[c], image.value()->rgb[3 * (8 * 24 + 12) + c]);
}

TEST_F(Cli, ExposureDoublesWithEachStepInDisplayFormatsOnly) {
    const std::vector<std::string> flat{"--set", "/environment/color=[0.1,0.1,0.1]",
                                        "--set", "/objects/Ball/visible=false",
                                        "--set", "/lights/Key/visible=false"};
    const auto value = [&](const std::string& name, const std::string& ev) {
        std::vector<std::string> arguments{"scene.json", "-o", name, "--exposure", ev};
        arguments.insert(arguments.end(), flat.begin(), flat.end());
        EXPECT_EQ(run(arguments).code, 0);
        return loadImage(folder_ / name).value()->rgb[0];
    };
    EXPECT_NEAR(value("a.png", "0"), 0.1F, 0.003F);
    EXPECT_NEAR(value("a.png", "2"), 0.4F, 0.006F);
    EXPECT_NEAR(value("a.png", "-1"), 0.05F, 0.002F);
    EXPECT_FLOAT_EQ(value("a.exr", "2"), 0.1F);
}

TEST_F(Cli, VerifyFindsTheSameBitsAgain) {
    const std::vector<std::vector<std::string>> ways{
        {"a.exr"},
        {"b.png", "--bits", "16"},
        {"c.jpg", "--spp", "6", "--seed", "9"},
        {"d.tif", "--transparent"},
        {"e.exr", "--transparent", "--layers", "--bits", "16"},
        {"f.exr", "--crop", "5,3,10,8", "--size", "40x20", "--integrator", "classic"},
        {"g.png", "--exposure", "2", "--transparent"},
        {"h.exr", "--time", "0.2", "--spp", "1000000"}};
    for (const auto& way : ways) {
        std::vector<std::string> arguments{"scene.json", "-o"};
        arguments.insert(arguments.end(), way.begin(), way.end());
        expect(0, "", arguments);
        expect(0, "bit for bit", {"--verify", way.front(), "scene.json", "--threads", "3"});
    }
}

TEST_F(Cli, VerifyNamesAChangedPixelOrScene) {
    expect(0, "", {"scene.json", "-o", "a.exr"});
    ExrFile file = loadExr(folder_ / "a.exr").value();
    for (ExrChannel& channel : file.channels)
        if (channel.name == "G")
            channel.values[3 * 24 + 7] = std::nextafter(channel.values[3 * 24 + 7], 10.0F);
    ASSERT_TRUE(saveExr(folder_ / "touched.exr", file));
    expect(4, "in 1 of 24 x 16 pixels", {"--verify", "touched.exr", "scene.json"});
    expect(4, "7,3", {"--verify", "touched.exr", "scene.json"});
    std::string other = kScene;
    other.replace(other.find("0.7, 0.1, 0.1"), 13, "0.7, 0.1, 0.2");
    folder_.write("other.json", other);
    expect(4, "another scene", {"--verify", "a.exr", "other.json"});
    folder_.write("view.json",
                  std::string(kScene).replace(12, 0, R"( "views": [{"position": [1, 2, 3]}],)"));
    expect(0, "bit for bit", {"--verify", "a.exr", "view.json"});
}

TEST_F(Cli, VerifySaysWhatItCannotCompare) {
    expect(0, "", {"scene.json", "-o", "a.hdr"});
    expect(2, "does not say how it was made", {"--verify", "a.hdr", "scene.json"});
    expect(2, "no such file", {"--verify", "none.exr", "scene.json"});
    folder_.write("text.png", "no picture");
    expect(2, "not a readable picture", {"--verify", "text.png", "scene.json"});
}

TEST_F(Cli, TransparentPicturesHaveTheObjectsAsAlpha) {
    expect(0, "", {"scene.json", "-o", "a.exr", "--transparent"});
    expect(0, "", {"scene.json", "-o", "a.png", "--transparent"});
    const auto exr = loadRaw(folder_ / "a.exr"), png = loadRaw(folder_ / "a.png");
    ASSERT_TRUE(exr && png);
    const auto& alpha = exr.value().channels.at("A");
    const std::size_t corner = 0, middle = 8 * 24 + 12;
    EXPECT_EQ(alpha[corner], 0);
    EXPECT_EQ(alpha[middle], 1);
    EXPECT_EQ(exr.value().channels.at("R")[corner], 0);
    EXPECT_GT(exr.value().channels.at("R")[middle], 0);
    EXPECT_TRUE(std::any_of(alpha.begin(), alpha.end(), [](float a) { return a > 0 && a < 1; }));
    for (std::size_t i = 0; i < alpha.size(); ++i)
        EXPECT_NEAR(png.value().channels.at("A")[i], alpha[i], 0.5F / 255 + 1e-6F);
}

TEST_F(Cli, FormatsRefuseWhatTheyCannotHold) {
    expect(1, "cannot be transparent", {"scene.json", "-o", "a.jpg", "--transparent"});
    expect(1, "use 8 or 16", {"scene.json", "-o", "a.png", "--bits", "32"});
    expect(1, "cannot hold layers", {"scene.json", "-o", "a.png", "--layers"});
    expect(1, "use 32 or 16", {"scene.json", "-o", "a.exr", "--bits", "8"});
}

TEST_F(Cli, WhatIsNotBuiltYetIsNamedAndDoesNotStop) {
    expect(0, "warning: ",
           {"scene.json", "-o", "a.exr", "--set",
            R"(/objects/Ball/shape={"type": "mesh", "file": "a.obj"})"});
}

}  // namespace
}  // namespace glint
