// The picture for the screen: what a coarse pass has not reached yet is filled from its grid, in every channel.
#include <gtest/gtest.h>

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
        ASSERT_TRUE(painter.paint(nullptr, film, nullptr, kStride, {}, {.channel = channel}, {}, out));
        for (const std::uint32_t pixel : out.pixels) ASSERT_EQ(pixel, out.pixels.front()) << "channel " << static_cast<int>(channel);
    }
}

TEST(FramePainter, CountsSamplesWhereTheyAre) {
    WorkerPool pool(1);
    FramePainter painter(pool);
    Film film = coarseFilm();
    film.add(1, 1, Rgb(0.5f), {}, 0);
    film.add(1, 1, Rgb(0.5f), {}, 0);
    Painting out;
    ASSERT_TRUE(painter.paint(nullptr, film, nullptr, kStride, {}, {.channel = Channel::Samples}, {}, out));
    EXPECT_EQ(out.legend->high, 2);
    EXPECT_NE(out.pixels[kSide + 1], out.pixels[0]);
    EXPECT_EQ(out.pixels[1], out.pixels[0]);
}

}  // namespace
}  // namespace glint
