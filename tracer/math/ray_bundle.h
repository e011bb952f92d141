// RayBundle: what is known of rays that lie close together, such as those of a tile of the film: the
// half-spaces that hold them all.
#pragma once

#include <array>

#include "tracer/math/types.h"

namespace glint {

/// Four half-spaces, normal . x <= offset, whose common part holds every ray of the bundle.
struct RayBundle {
    struct Side {
        DVec3 normal;     ///< unit length, pointing out
        double offset;    ///< [m]
        double error;     ///< of normal . x - offset, over the coordinates of x and of the rays' origins
    };
    std::array<Side, 4> sides;
    double place = 0;  ///< sum of the absolute coordinates of a ray's origin, at most [m]

    /// Whether everything within `extent(normal)` [m] of `center`, measured along a side's normal,
    /// surely lies outside.
    template <class Extent>
    [[nodiscard]] bool misses(const DVec3& center, const Extent& extent) const {
        const double far = place + coordinateSum(center);
        for (const Side& side : sides)
            if (glm::dot(side.normal, center) - side.offset > extent(side.normal) + side.error * far)
                return true;
        return false;
    }
};

}  // namespace glint
