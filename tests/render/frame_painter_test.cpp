// The picture for the screen: what a coarse pass has not reached yet is filled from its grid, in
// every channel.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <random>

#include "tracer/render/frame_painter.h"

namespace glint {
namespace {

constexpr int kSide = 32, kStride = 4;

/// Samples at the pixels of a grid only.
Film coarseFilm() {
    Film film(kSide, kSide, 1);
    for (int y = 0; y < kSide; y += kStride)
        for (int x = 0; x < kSide; x += kStride) film.add(x, y, Rgb(0.5f), {}, 0);
    return film;
}

TEST(FramePainter, FillsACoarsePictureInEveryChannelOfTheFilm) {
    WorkerPool pool(2);
    FramePainter painter(pool);
    const Film film = coarseFilm();
    for (const Channel channel : {Channel::Beauty, Channel::Samples, Channel::Luminance}) {
        Painting out;
        ASSERT_TRUE(
            painter.paint(nullptr, film, nullptr, kStride, {}, {.channel = channel}, {}, out));
        for (const std::uint32_t pixel : out.pixels)
            ASSERT_EQ(pixel, out.pixels.front()) << "channel " << static_cast<int>(channel);
    }
}

TEST(FramePainter, CountsSamplesWhereTheyAre) {
    WorkerPool pool(1);
    FramePainter painter(pool);
    Film film = coarseFilm();
    film.add(1, 1, Rgb(0.5f), {}, 0);
    film.add(1, 1, Rgb(0.5f), {}, 0);
    Painting out;
    ASSERT_TRUE(
        painter.paint(nullptr, film, nullptr, kStride, {}, {.channel = Channel::Samples}, {}, out));
    EXPECT_EQ(out.legend->high, 2);
    EXPECT_NE(out.pixels[kSide + 1], out.pixels[0]);
    EXPECT_EQ(out.pixels[1], out.pixels[0]);
}

/// Passes of an edit that makes the pixels of some materials anew, cut short and begun again at
/// random.
TEST(FramePainter, LeavesWhatARetraceDoesNotTouchAsAWholePaintingHasIt) {
    std::mt19937 random(5);
    const auto below = [&](int end) {
        return std::uniform_int_distribution<int>(0, end - 1)(random);
    };
    WorkerPool pool(2);
    FramePainter painter(pool);
    Film film(kSide, kSide, 1);
    const auto add = [&](int x, int y) {
        film.add(x, y, Rgb(0.01f * static_cast<float>(below(100))), {}, 1u << below(3));
    };
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) add(x, y);
    const auto paint = [&](int stride, Painting& out) {
        return painter.paint(nullptr, film, nullptr, stride, {}, {}, {}, out);
    };
    std::array<Painting, 3> frames;
    Painting before;
    ASSERT_TRUE(paint(1, before));
    for (int turn = 0; turn < 400; ++turn) {
        const int stride = 1 << below(4);
        film.forget(1u << below(3), pool);
        const int cut = kSide * kSide - below(3) * 300;  // Of three passes two are cut short.
        for (int i = 0; i < cut; ++i)
            if (const int x = i % kSide, y = i / kSide;
                (x | y) % stride == 0 && film.samples(x, y) == 0)
                add(x, y);
        const int shown = cut == kSide * kSide ? stride : 1;
        Painting whole, &frame = frames[static_cast<std::size_t>(turn % 3)];
        ASSERT_TRUE(paint(shown, whole));
        ASSERT_TRUE(paint(shown, frame));
        ASSERT_EQ(frame.pixels, whole.pixels) << "turn " << turn;
        if (shown == 1 && below(4) == 0) {
            for (int y = 0; y < kSide; ++y)
                for (int x = 0; x < kSide; ++x)
                    if (film.samples(x, y) == 0 || below(2)) add(x, y);
            film.settle(below(2) == 0);
            ASSERT_TRUE(paint(1, whole));
            ASSERT_TRUE(paint(1, frame));
            ASSERT_EQ(frame.pixels, whole.pixels) << "turn " << turn << ", settled";
        }
    }
}

TEST(FramePainter, ShowsWhatIsForgottenUntilThereIsMore) {
    WorkerPool pool(1);
    FramePainter painter(pool);
    Film film(kSide, kSide, 1);
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x)
            film.add(x, y, Rgb(x < kSide / 2 ? 0.25f : 0.5f), {}, x < kSide / 2 ? 1 : 2);
    Painting before, after;
    ASSERT_TRUE(painter.paint(nullptr, film, nullptr, 1, {}, {}, {}, before));
    EXPECT_EQ(film.forget(1, pool), static_cast<std::size_t>(kSide * kSide / 2));
    EXPECT_EQ(film.samples(0, 0), 0u);
    ASSERT_TRUE(painter.paint(nullptr, film, nullptr, 1, {}, {}, {}, after));
    EXPECT_EQ(after.pixels, before.pixels);
    film.add(0, 0, Rgb(1.0f), {}, 1);
    ASSERT_TRUE(painter.paint(nullptr, film, nullptr, kStride, {}, {}, {}, after));
    EXPECT_EQ(after.pixels[0], 0xffffffffu);
    EXPECT_EQ(after.pixels[kStride - 1], 0xffffffffu) << "the grid's pixel stands for its block";
    EXPECT_EQ(after.pixels[kStride], before.pixels[kStride]) << "no grid pixel yet: as it was";
    EXPECT_EQ(after.pixels[kSide - 1], before.pixels[kSide - 1]);
}

TEST(Film, MeansOfRowsAreThoseOfPixels) {
    constexpr int kWidth = 45, kHeight = 20;
    for (const std::size_t groups : {1, 3}) {
        Film film(kWidth, kHeight, groups);
        for (int i = 0; i < 500; ++i)
            film.add(i * 7 % kWidth, i * 3 % kHeight, Rgb(0.01f * static_cast<float>(i)),
                     GroupLight{Vec3(0.5f), Vec3(0.25f), Vec3(1.0f)}, 0);
        for (const double gain : {1.0, 0.3}) {
            LightMix mix;
            mix.gain[0] = DVec3(gain);
            film.setMix(mix);
            std::vector<Rgb> row(kWidth - 3);
            for (int y = 0; y < kHeight; ++y) {
                film.means(3, y, row);
                for (int x = 3; x < kWidth; ++x)
                    ASSERT_EQ(row[static_cast<std::size_t>(x - 3)], film.at(x, y).mean());
            }
        }
    }
}

TEST(DisplayTransform, GivesTheNearestCodeOfEveryLight) {
    const DisplayTransform transform({});
    const auto exact = [](double v) {
        return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
    };
    for (float v = 1e-9f; v < 1.1f; v *= 1.00003f) {
        const std::uint32_t code = transform.apply({v, 0.0f, 1.0f}) >> 16 & 0xff;
        ASSERT_NEAR(code, 255 * std::min(exact(static_cast<double>(v)), 1.0), 0.5001) << v;
    }
    EXPECT_EQ(transform.apply({-1.0f, kInfinity, 0.0f}), 0xff00ff00u);
    EXPECT_EQ(transform.apply({1.0f, std::nanf(""), 0.0f}), 0xffff00ffu)
        << "what is no number is magenta";
}

TEST(BlockPool, BlocksDoNotMeetAndAreUsedAgain) {
    constexpr std::size_t kBytes = 1000, kBlocks = 5000;
    BlockPool pool(kBytes, 10);
    std::vector<void*> blocks;
    for (std::size_t i = 0; i < kBlocks; ++i) {
        blocks.push_back(pool.take());
        ASSERT_EQ(reinterpret_cast<std::uintptr_t>(blocks.back()) % 64, 0u);
        std::memset(blocks.back(), static_cast<int>(i % 251), kBytes);
    }
    for (std::size_t i = 0; i < kBlocks; ++i)
        for (const std::size_t at : {std::size_t{0}, kBytes - 1})
            ASSERT_EQ(static_cast<unsigned char*>(blocks[i])[at], i % 251);
    pool.give(blocks[7]);
    EXPECT_EQ(pool.take(), blocks[7]);
    for (int i = 0; i < 20; ++i) pool.reserve(30);
    std::vector<void*> more;
    for (int i = 0; i < 30; ++i) more.push_back(pool.take());
    std::ranges::sort(more);
    EXPECT_EQ(std::ranges::adjacent_find(more), more.end());
}

}  // namespace
}  // namespace glint
