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
    void clear() { pixels_.assign(pixels_.size(), {}); }

    /// Means of all pixels.
    [[nodiscard]] Image image() const {
        Image out{width_, height_, {}};
        out.rgb.reserve(pixels_.size() * 3);
        for (const FilmPixel& pixel : pixels_) {
            const Rgb mean = pixel.mean();
            out.rgb.insert(out.rgb.end(), {mean.x, mean.y, mean.z});
        }
        return out;
    }

  private:
    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    }
    int width_ = 0, height_ = 0;
    std::vector<FilmPixel> pixels_;
};

}  // namespace glint
