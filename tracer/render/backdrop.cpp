#include "tracer/render/backdrop.h"

#include <cmath>

namespace glint {

FilmPixel Backdrop::at(int x, int y, int width, int height) const {
    const double sourceX = 0.5 * film.width() + scale * (x + 0.5 - 0.5 * width),
                 sourceY = 0.5 * film.height() + scale * (y + 0.5 - 0.5 * height);
    if (!(sourceX >= 0 && sourceX < film.width() && sourceY >= 0 && sourceY < film.height()))
        return {};
    return film.at(static_cast<int>(sourceX), static_cast<int>(sourceY));
}

Rgb shownAt(const Film& film, const Backdrop* backdrop, int mask, int x, int y) {
    const FilmPixel own = film.at(x, y);
    const int gridX = x & mask, gridY = y & mask;
    const FilmPixel old = backdrop ? backdrop->at(x, y, film.width(), film.height()) : FilmPixel{};
    if (old.samples > own.samples)
        return FilmPixel{own.sumA + old.sumA, own.sumB + old.sumB, own.samples + old.samples}
            .mean();
    if (own.samples) return own.mean();
    if (film.remembers() && !film.isAnew(gridX, gridY))
        if (const std::optional<Rgb> before = film.remembered(x, y)) return *before;
    return film.at(gridX, gridY).mean();
}

}  // namespace glint
