#include "tracer/render/film.h"

#include <algorithm>

namespace glint {

void Film::clear(const PixelRect& rect) {
    for (int y = rect.y; y < rect.y + rect.height; ++y)
        std::fill_n(pixels_.begin() + static_cast<std::ptrdiff_t>(index(rect.x, y)), rect.width, FilmPixel{});
}

Image Film::image() const {
    Image out{width_, height_, {}};
    out.rgb.reserve(pixels_.size() * 3);
    for (const FilmPixel& pixel : pixels_) {
        const Rgb mean = pixel.mean();
        out.rgb.insert(out.rgb.end(), {mean.x, mean.y, mean.z});
    }
    return out;
}

namespace {

/// Of one pixel's luminance, from its halves: their difference has twice the spread of their mean.
double standardError(const FilmPixel& pixel) {
    const double countB = pixel.samples / 2, countA = pixel.samples - countB;
    const DVec3 difference = pixel.sumA / countA - pixel.sumB / countB;
    return 0.5 * std::abs(luminance(Color{difference.x, difference.y, difference.z}));
}

/// Calls visit(pixel) for each pixel of `rect` with two samples or more.
template <class Visit>
void forEachJudged(const Film& film, const PixelRect& rect, Visit&& visit) {
    for (int y = rect.y; y < rect.y + rect.height; ++y)
        for (int x = rect.x; x < rect.x + rect.width; ++x)
            if (film.at(x, y).samples >= 2) visit(film.at(x, y));
}

}  // namespace

double tileError(const Film& film, const PixelRect& tile) {
    double squares = 0;
    int pixels = 0;
    forEachJudged(film, tile, [&](const FilmPixel& pixel) {
        const double error = standardError(pixel);
        squares += error * error;
        ++pixels;
    });
    return pixels ? std::sqrt(squares / pixels) : 0;
}

double pictureError(const Film& film, const PixelRect& rect) {
    double squares = 0, light = 0;
    std::int64_t pixels = 0;
    forEachJudged(film, rect, [&](const FilmPixel& pixel) {
        const double error = standardError(pixel);
        squares += error * error;
        light += luminance(pixel.mean());
        ++pixels;
    });
    if (pixels == 0) return kInfinity;
    const auto n = static_cast<double>(pixels);
    return squares == 0 ? 0 : std::sqrt(squares / n) / (light / n);
}

}  // namespace glint
