// Sampling the directions to a surface by its area: from a density per area to one per solid angle.
#pragma once

#include "tracer/math/warp.h"

namespace glint {

/// The direction from `o` to the surface point `p` with outward unit normal `n`, drawn with density
/// `pdfArea`; no sample where the surface is turned away.
[[nodiscard]] inline DirectionSample towardsArea(const DVec3& o, const DVec3& p, const DVec3& n,
                                                 double pdfArea) {
    const DVec3 to = p - o;
    const double distance = glm::length(to);
    const DVec3 direction = to / distance;
    const double cosine = -glm::dot(direction, n);
    if (!(cosine > 0)) return {};
    return {direction, pdfArea * distance * distance / cosine};
}

/// Its density for the unit direction `d`, which reaches the surface after `distance`.
[[nodiscard]] inline double areaPdfTowards(const DVec3& d, double distance, const DVec3& n,
                                           double pdfArea) {
    const double cosine = -glm::dot(d, n);
    return cosine > 0 ? pdfArea * distance * distance / cosine : 0;
}

}  // namespace glint
