#include "tracer/render/backdrop.h"

#include <cmath>

namespace glint {

FilmPixel Backdrop::at(int x, int y, int width, int height) const {
    const double sourceX = 0.5 * film.width() + scale * (x + 0.5 - 0.5 * width), sourceY = 0.5 * film.height() + scale * (y + 0.5 - 0.5 * height);
    if (!(sourceX >= 0 && sourceX < film.width() && sourceY >= 0 && sourceY < film.height())) return {};
    return film.at(static_cast<int>(sourceX), static_cast<int>(sourceY));
}

Rgb shownAt(const Film& film, const Backdrop* backdrop, int mask, int x, int y) {
    const FilmPixel own = film.at(x, y);
    const int gridX = x & mask, gridY = y & mask;
    if (!backdrop) return own.samples ? own.mean() : film.at(gridX, gridY).mean();
    if (backdrop->retraced) {
        if (own.samples) return own.mean();
        // The grid's pixel stands for this one if it was traced anew as well.
        const bool alike = backdrop->film.materials(gridX, gridY) & backdrop->retraced;
        return alike && film.samples(gridX, gridY) ? film.at(gridX, gridY).mean() : backdrop->film.at(x, y).mean();
    }
    FilmPixel old = backdrop->at(x, y, film.width(), film.height());
    if (old.samples == 0) return own.samples ? own.mean() : film.at(gridX, gridY).mean();
    if (own.samples >= old.samples) return own.mean();
    old.sumA += own.sumA;
    old.sumB += own.sumB;
    old.samples += own.samples;
    return old.mean();
}

}  // namespace glint
