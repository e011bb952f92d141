// Pictures survive writing and reading in every format, and broken files are errors.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <random>
#include <string>

#include "tests/support/paths.h"
#include "tests/support/temp_folder.h"
#include "tracer/color/display.h"
#include "tracer/io/film_exr.h"
#include "tracer/io/image_file.h"

namespace glint {
namespace {

namespace fs = std::filesystem;
using test::TempFolder;

constexpr int kWidth = 37, kHeight = 71;

Image gradient() {
    Image out{kWidth, kHeight, {}};
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x)
            out.rgb.insert(out.rgb.end(),
                           {static_cast<float>(x) / kWidth, static_cast<float>(y) / 7.0F, 3.0F});
    return out;
}

DisplayImage bytes() {
    DisplayImage out{kWidth, kHeight, 3, 8, {}};
    for (int i = 0; i < 3 * kWidth * kHeight; ++i)
        out.codes.push_back(static_cast<std::uint16_t>(i % 3 == 0 ? 40 : (i / 12) % 256));
    return out;
}

const ImageMetadata kMetadata{{"glint:sceneHash", "0123456789abcdef"},
                              {"glint:seed", "7"},
                              {"glint:spp", "64"},
                              {"glint:version", "0.1.0"}};

/// Found by fuzzing: the library would make and clear two gigabytes for each.
TEST(ImageFile, AnExrHeaderThatClaimsMoreThanTheFileHoldsIsRefused) {
    const std::map<std::string, std::string> cases{
        {"attribute_longer_than_file", ""},  // This one the library's core refuses.
        {"unknown_attribute_longer_than_file", "longer than the file"},
        {"string_longer_than_file", "longer than the file"},
        {"channels_longer_than_stated", "longer than the file"},
        {"tile_larger_than_file", "larger than the file can hold"},
        {"attribute_twice", "comes twice"},
        {"compression_missing", "larger than the file can hold"},
        {"attribute_without_size", "as long as its type"},
        {"attribute_of_wrong_size", "as long as its type"}};
    for (const auto& [name, why] : cases) {
        const auto loaded = loadExr(test::inSource("tests/fuzz/corpus/exr/" + name + ".exr"));
        ASSERT_FALSE(loaded) << name;
        const std::string text = loaded.error().text();
        EXPECT_NE(text.find("is not a readable EXR picture"), std::string::npos) << text;
        EXPECT_NE(text.find(why), std::string::npos) << text;
    }
}

TEST(ImageFile, ExrKeepsEveryFloatAndTheMetadata) {
    const TempFolder folder;
    Image image = gradient();
    image.rgb[5] = 1e30F, image.rgb[6] = 1e-40F, image.rgb[7] = -2.5F;
    ASSERT_TRUE(saveLinear(folder / "a.exr", image, kMetadata));
    const auto again = loadImage(folder / "a.exr");
    ASSERT_TRUE(again) << again.error().text();
    EXPECT_EQ(again.value()->width, kWidth);
    EXPECT_EQ(again.value()->height, kHeight);
    EXPECT_EQ(
        std::memcmp(again.value()->rgb.data(), image.rgb.data(), image.rgb.size() * sizeof(float)),
        0);
    const auto file = loadExr(folder / "a.exr");
    ASSERT_TRUE(file);
    for (const auto& [key, value] : kMetadata)
        EXPECT_EQ(file.value().metadata.at(key), value) << key;
    EXPECT_EQ(folder.count(), 1u);
}

TEST(ImageFile, ExrKeepsAnyChannels) {
    const TempFolder folder;
    ExrFile file{2,
                 2,
                 {{"albedo.G", {1, 2, 3, 4}},
                  {"depth.Z", {5, 6, 7, std::numeric_limits<float>::infinity()}}},
                 {}};
    ASSERT_TRUE(saveExr(folder / "a.exr", file));
    const auto again = loadExr(folder / "a.exr");
    ASSERT_TRUE(again) << again.error().text();
    ASSERT_EQ(again.value().channels.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(again.value().channels[i].name, file.channels[i].name);
        EXPECT_EQ(again.value().channels[i].values, file.channels[i].values);
    }
    EXPECT_EQ(loadImage(folder / "a.exr").error().message, "has no channels R, G and B, nor Y");
}

TEST(ImageFile, ExrOfOneLayerOrGreyGivesColours) {
    const TempFolder folder;
    ASSERT_TRUE(saveExr(folder / "layer.exr",
                        {1, 1, {{"beauty.R", {1}}, {"beauty.G", {2}}, {"beauty.B", {3}}}, {}}));
    EXPECT_EQ(loadImage(folder / "layer.exr").value()->rgb, (std::vector<float>{1, 2, 3}));
    ASSERT_TRUE(saveExr(folder / "grey.exr", {1, 1, {{"Y", {4}}}, {}}));
    EXPECT_EQ(loadImage(folder / "grey.exr").value()->rgb, (std::vector<float>{4, 4, 4}));
}

TEST(ImageFile, HdrKeepsLightToItsPrecision) {
    const TempFolder folder;
    const Image image = gradient();
    ASSERT_TRUE(saveLinear(folder / "a.hdr", image, kMetadata));
    const auto again = loadImage(folder / "a.hdr");
    ASSERT_TRUE(again) << again.error().text();
    ASSERT_EQ(again.value()->rgb.size(), image.rgb.size());
    // RGBE has 8 bits for the largest channel of a pixel, 10 in the last row: an error of 1/128 of
    // it.
    for (std::size_t i = 0; i < image.rgb.size(); ++i) {
        const std::size_t pixel = i / 3 * 3;
        const float largest =
            std::max({image.rgb[pixel], image.rgb[pixel + 1], image.rgb[pixel + 2]});
        ASSERT_NEAR(again.value()->rgb[i], image.rgb[i], largest / 128);
    }
}

class LosslessBytes : public testing::TestWithParam<const char*> {};

TEST_P(LosslessBytes, ComeBackAsLinearLight) {
    const TempFolder folder;
    const fs::path path = folder / (std::string("a") + GetParam());
    const auto display = bytes();
    ASSERT_TRUE(saveDisplay(path, display, kMetadata));
    const auto srgb = loadImage(path);
    ASSERT_TRUE(srgb) << srgb.error().text();
    const auto linear = loadImage(path, ColorSpace::Linear);
    ASSERT_TRUE(linear) << linear.error().text();
    ASSERT_EQ(srgb.value()->rgb.size(), display.codes.size());
    for (std::size_t i = 0; i < display.codes.size(); ++i) {
        const float coded = static_cast<float>(display.codes[i]) / 255;
        ASSERT_NEAR(linear.value()->rgb[i], coded, 1e-6F) << i;
        ASSERT_NEAR(srgb.value()->rgb[i], linearFromSrgb(coded), 2e-5F) << i;
    }
    EXPECT_NE(test::fileContent(path).find("glint:sceneHash=0123456789abcdef"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(ImageFile, LosslessBytes, testing::Values(".png", ".tif", ".tiff", ".PNG"),
                         [](const auto& test) {
                             return std::string(test.param + 1) + std::to_string(test.index);
                         });

TEST(ImageFile, JpegIsNearAndKeepsTheMetadata) {
    const TempFolder folder;
    DisplayImage display{64, 64, 3, 8, std::vector<std::uint16_t>(3 * 64 * 64)};
    for (std::size_t i = 0; i < display.codes.size(); ++i)
        display.codes[i] = static_cast<std::uint16_t>(60 + 30 * (i % 3) + i / 3 % 64);
    for (const char* name : {"a.jpg", "b.JPEG"}) {
        ASSERT_TRUE(saveDisplay(folder / name, display, kMetadata));
        const auto again = loadImage(folder / name, ColorSpace::Linear);
        ASSERT_TRUE(again) << again.error().text();
        for (std::size_t i = 0; i < display.codes.size(); ++i)
            ASSERT_NEAR(again.value()->rgb[i] * 255, static_cast<float>(display.codes[i]), 6.0F);
        EXPECT_NE(test::fileContent(folder / name).find("glint:seed=7"), std::string::npos);
    }
}

/// A 2 x 1 grey PNG of 16 bits a channel, with alpha: (0x8000, half transparent), (0xFFFF, opaque).
constexpr unsigned char kGreyAlpha16[] = {
    0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48, 0x44,
    0x52, 0x00, 0x00, 0x00, 0x02, 0x00, 0x00, 0x00, 0x01, 0x10, 0x04, 0x00, 0x00, 0x00, 0x0e,
    0xbb, 0x6b, 0x42, 0x00, 0x00, 0x00, 0x0f, 0x49, 0x44, 0x41, 0x54, 0x78, 0xda, 0x63, 0x68,
    0x60, 0x68, 0x60, 0xf8, 0x0f, 0x04, 0x00, 0x10, 0xff, 0x04, 0xfd, 0xda, 0x22, 0x37, 0xce,
    0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};

TEST(ImageFile, SixteenBitsAreReadAndAlphaIsDroppedUnmultiplied) {
    const TempFolder folder;
    const auto path =
        folder.write("a.png", {reinterpret_cast<const char*>(kGreyAlpha16), sizeof(kGreyAlpha16)});
    const auto image = loadImage(path, ColorSpace::Linear);
    ASSERT_TRUE(image) << image.error().text();
    ASSERT_EQ(image.value()->rgb.size(), 6u);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(image.value()->rgb[i], 32768.0F / 65535.0F, 1e-6F);
        EXPECT_NEAR(image.value()->rgb[3 + i], 1.0F, 1e-6F);
    }
}

class DeepDisplay : public testing::TestWithParam<std::tuple<const char*, int>> {};

TEST_P(DeepDisplay, KeepsEveryCodeAlphaAndText) {
    const TempFolder folder;
    const auto [ending, bits] = GetParam();
    const fs::path path = folder / (std::string("a") + ending);
    DisplayImage display{kWidth, kHeight, 4, bits, {}};
    for (int i = 0; i < 4 * kWidth * kHeight; ++i)
        display.codes.push_back(
            static_cast<std::uint16_t>((i * 40503) % (bits == 8 ? 256 : 65536)));
    ASSERT_TRUE(saveDisplay(path, display, kMetadata));
    const auto raw = loadRaw(path);
    ASSERT_TRUE(raw) << raw.error().text();
    ASSERT_EQ(raw.value().channels.size(), 4u);
    const float most = bits == 8 ? 255 : 65535;
    for (std::size_t i = 0; i < display.codes.size(); ++i)
        ASSERT_NEAR(raw.value().channels.at(std::string(1, "RGBA"[i % 4]))[i / 4] * most,
                    display.codes[i], 0.01F)
            << i;
    for (const auto& [key, value] : kMetadata)
        EXPECT_EQ(raw.value().metadata.at(key), value) << key;
}

INSTANTIATE_TEST_SUITE_P(ImageFile, DeepDisplay,
                         testing::Combine(testing::Values(".png", ".tif"), testing::Values(8, 16)),
                         [](const auto& test) {
                             return std::string(std::get<0>(test.param) + 1) +
                                    std::to_string(std::get<1>(test.param));
                         });

TEST(ImageFile, HalfExrRoundsColoursOnlyAndNeverToInfinity) {
    const TempFolder folder;
    const ExrFile file{2, 1, {{"R", {0.1F, 1e9F}}, {"depth.Z", {0.1F, 1e9F}}}, kMetadata, true};
    ASSERT_TRUE(saveExr(folder / "a.exr", file));
    const auto raw = loadRaw(folder / "a.exr");
    ASSERT_TRUE(raw) << raw.error().text();
    EXPECT_NEAR(raw.value().channels.at("R")[0], 0.1F, 5e-5F);
    EXPECT_NE(raw.value().channels.at("R")[0], 0.1F);
    EXPECT_EQ(raw.value().channels.at("R")[1], 65504.0F);
    EXPECT_EQ(raw.value().channels.at("depth.Z"), (std::vector<float>{0.1F, 1e9F}));
    EXPECT_EQ(raw.value().metadata.at("glint:spp"), "64");
}

TEST(ImageFile, KnowsItsFormats) {
    EXPECT_EQ(bitDepths("a.exr"), (std::vector<int>{32, 16}));
    EXPECT_EQ(bitDepths("a.png"), (std::vector<int>{8, 16}));
    EXPECT_EQ(bitDepths("a.jpeg"), std::vector<int>{8});
    EXPECT_EQ(bitDepths("a.gif"), std::vector<int>{});
    EXPECT_TRUE(holdsAlpha("a.tif"));
    EXPECT_FALSE(holdsAlpha("a.jpg"));
    EXPECT_FALSE(holdsAlpha("a.hdr"));
    EXPECT_TRUE(isLinearFormat("a/b.exr"));
    EXPECT_TRUE(isLinearFormat("b.HDR"));
    EXPECT_FALSE(isLinearFormat("b.png"));
    for (const std::string& ending : writableEndings())
        EXPECT_TRUE(isWritableFormat("x" + ending)) << ending;
    EXPECT_FALSE(isWritableFormat("x"));
    EXPECT_FALSE(isWritableFormat("x.gif"));
    EXPECT_FALSE(isWritableFormat(".exr"));
}

TEST(ImageFile, WhatIsNoPictureIsAnError) {
    const TempFolder folder;
    EXPECT_EQ(loadImage(folder / "none.png").error().message, "there is no such file");
    EXPECT_EQ(loadImage(folder.path()).error().message, "is not a file");
    for (const char* name : {"a.exr", "a.png", "a.jpg", "a.hdr", "a.tif", "a.xyz"}) {
        for (const std::string& content :
             {std::string(), std::string("hello"), std::string(100000, '\x7F')}) {
            const auto image = loadImage(folder.write(name, content));
            ASSERT_FALSE(image) << name;
            EXPECT_EQ(image.error().file, (folder / name).string());
            EXPECT_EQ(image.error().text().find('\n'), std::string::npos) << image.error().text();
        }
    }
}

/// Breaks good files in many ways: an error or a picture, never a crash.
TEST(ImageFile, BrokenFilesNeverCrash) {
    const TempFolder folder;
    std::mt19937 random(5);
    ASSERT_TRUE(saveLinear(folder / "a.exr", gradient(), kMetadata));
    ASSERT_TRUE(saveDisplay(folder / "a.png", bytes(), kMetadata));
    ASSERT_TRUE(saveLinear(folder / "a.hdr", gradient(), kMetadata));
    for (const char* name : {"a.exr", "a.png", "a.hdr"}) {
        const std::string good = test::fileContent(folder / name);
        int errors = 0;
        for (int round = 0; round < 100; ++round) {
            std::string broken = good.substr(0, round % 2 ? good.size() : random() % good.size());
            for (int i = 0; i < 4 && !broken.empty(); ++i)
                broken[random() % std::min<std::size_t>(broken.size(), 600)] =
                    static_cast<char>(random());
            errors += loadImage(folder.write(std::string("broken") + name, broken)) ? 0 : 1;
        }
        EXPECT_GT(errors, 20) << name;
    }
}

TEST(ImageFile, ValuesThatAreNotFiniteAreNamed) {
    const TempFolder folder;
    Image image = gradient();
    image.rgb[3 * (2 * kWidth + 5) + 1] = std::numeric_limits<float>::quiet_NaN();
    ASSERT_TRUE(saveLinear(folder / "a.exr", image, {}));
    EXPECT_EQ(loadImage(folder / "a.exr").error().message,
              "has a value that is not finite, at pixel 5, 2");
}

TEST(ImageFile, AHeaderThatClaimsTooMuchIsRefused) {
    const TempFolder folder;
    ASSERT_TRUE(saveLinear(folder / "a.hdr", gradient(), {}));
    std::string content = test::fileContent(folder / "a.hdr");
    const std::string size = "-Y 71 +X 37";
    ASSERT_NE(content.find(size), std::string::npos);
    content.replace(content.find(size), size.size(), "-Y 60000 +X 60000");
    const auto image = loadImage(folder.write("b.hdr", content));
    ASSERT_FALSE(image);
    EXPECT_NE(image.error().message.find("more than 1 Gpixel"), std::string::npos)
        << image.error().text();
}

TEST(ImageFile, WritingNowhereIsAnErrorAndLeavesNothing) {
    const TempFolder folder;
    for (const char* name : {"none/a.exr", "none/a.hdr"})
        EXPECT_FALSE(saveLinear(folder / name, gradient(), {}));
    EXPECT_FALSE(saveDisplay(folder / "none/a.png", bytes(), {}));
    fs::create_directory(folder / "a.exr");
    EXPECT_EQ(saveLinear(folder / "a.exr", gradient(), {}).error().message, "is a folder");
    EXPECT_EQ(folder.count(), 1u);
}

}  // namespace
}  // namespace glint
