// Backdrop: the picture of before, shown where the film has no samples yet, or fewer. Never part of the film or its error.
#pragma once

#include "tracer/render/film.h"

namespace glint {

struct Backdrop {
    Film film;
    /// Not 0: pixels that rest on these materials are traced anew; all others of the film are right.
    std::uint64_t retraced = 0;
    /// Otherwise the picture has been resized: a step of one pixel in it is a step of so many in the backdrop, about the centre.
    double scale = 1;

    /// The backdrop's pixel for one of a picture of width x height; no samples where it does not reach.
    [[nodiscard]] FilmPixel at(int x, int y, int width, int height) const;
};

/// What is shown at a pixel of `film`, which has samples at all pixels whose x and y are multiples of a power of two, of which
/// `mask` is the mask, and maybe others. `backdrop` may be null. Where the backdrop has been resized its samples count
/// with those of the film until these are more.
[[nodiscard]] Rgb shownAt(const Film& film, const Backdrop* backdrop, int mask, int x, int y);

}  // namespace glint
