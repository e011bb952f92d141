// Film: the sums of samples of every pixel. Each pixel is written by one worker at a time and its samples are added in the
// order of their numbers, so the sums do not depend on threads, tiles or interruptions.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "tracer/color/rgb.h"
#include "tracer/io/image_file.h"
#include "tracer/render/render.h"

namespace glint {

/// Sums in double of one pixel: half A holds the even samples, half B the odd ones. They are scrambled independently.
struct FilmPixel {
    DVec3 sumA{0.0}, sumB{0.0};
    std::uint32_t samples = 0;

    void add(const Rgb& value) {
        (samples % 2 ? sumB : sumA) += toDouble(value);
        ++samples;
    }
    /// Mean of all samples; black without any.
    [[nodiscard]] Rgb mean() const { return samples ? toFloat((sumA + sumB) / static_cast<double>(samples)) : Rgb(0.0f); }
};

class Film {
  public:
    Film() = default;
    Film(int width, int height)
        : width_(width), height_(height), pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }
    [[nodiscard]] FilmPixel& at(int x, int y) { return pixels_[index(x, y)]; }
    [[nodiscard]] const FilmPixel& at(int x, int y) const { return pixels_[index(x, y)]; }
    /// Takes the samples of a rectangle away.
    void clear(const PixelRect& rect);

    /// Means of all pixels.
    [[nodiscard]] Image image() const;

  private:
    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    }
    int width_ = 0, height_ = 0;
    std::vector<FilmPixel> pixels_;
};

/// Root mean square over a tile's pixels of the standard error of their luminance, from the two halves: (A - B) / 2. 0 where no
/// pixel has two samples.
[[nodiscard]] double tileError(const Film& film, const PixelRect& tile);

/// The picture's error: root mean square over its pixels of the standard error of their luminance, over the mean luminance of
/// the picture. Infinite where no pixel has two samples; 0 for a black picture. With thousands of pixels its own error is
/// small, so it needs no bound.
[[nodiscard]] double pictureError(const Film& film, const PixelRect& rect);

/// Whether a picture with that error and so many samples a pixel meets the stop rule `percent` (0: none). A few samples alone
/// may by chance agree, and miss what is rare: fewer than 16 never do.
[[nodiscard]] inline bool meetsErrorRule(double error, int samples, double percent) {
    return percent > 0 && samples >= 16 && 100 * error <= percent;
}

}  // namespace glint
