// Backdrop: the picture of before a resize, shown where the film has no samples yet, or fewer.
// Never part of the film or its error.
#pragma once

#include "tracer/render/film.h"

namespace glint {

struct Backdrop {
    Film film;
    double scale = 1;  ///< a step of one pixel in the picture is a step of so many in the backdrop,
                       ///< about the centre

    /// The backdrop's pixel for one of a picture of width x height; no samples where it does not
    /// reach.
    [[nodiscard]] FilmPixel at(int x, int y, int width, int height) const;
};

/// What is shown at a pixel of `film`, which has samples at all pixels whose x and y are multiples
/// of a power of two, of which `mask` is the mask, and maybe others; pixels that the film has
/// forgotten are shown as they were, or as the grid's pixel if that has been traced anew.
/// `backdrop` may be null: its samples count with those of the film until these are more.
[[nodiscard]] Rgb shownAt(const Film& film, const Backdrop* backdrop, int mask, int x, int y);

}  // namespace glint
