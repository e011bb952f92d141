// RayBundle: what is known of rays that lie close together, such as those of a tile of the film:
// the half-spaces that hold them all.
#pragma once

#include <algorithm>
#include <array>

#include "tracer/math/ray.h"

namespace glint {

/// Four half-spaces, normal . x <= offset, whose common part holds every ray of the bundle.
struct RayBundle {
    struct Side {
        DVec3 normal;   ///< unit length, pointing out
        double offset;  ///< [m]
        double
            error;  ///< of normal . x - offset, over the coordinates of x and of the rays' origins
    };
    std::array<Side, 4> sides;
    double place = 0;  ///< sum of the absolute coordinates of a ray's origin, at most [m]

    /// All rays between four neighbours, given in turn, which start at one point or are parallel;
    /// `middle` is one of those within. `spread` [m]: how far beside these a ray may be.
    RayBundle(const std::array<Ray, 4>& corners, const Ray& middle, double spread = 0) {
        for (std::size_t i = 0; i < 4; ++i) {
            const Ray &a = corners[i], &b = corners[(i + 1) % 4];
            const bool parallel = a.direction == b.direction;
            const DVec3 along = glm::normalize(a.direction),
                        across = parallel ? b.origin - a.origin : b.direction;
            const double length = glm::length(across);
            DVec3 normal = glm::cross(along, across);
            const double sine = glm::length(normal) / length;
            normal /= glm::length(normal);
            if (glm::dot(normal, middle.origin + middle.direction - a.origin) > 0) normal = -normal;
            // The nearer two rays are to each other, the less their rounding leaves of the normal.
            const double rounding = 0x1p-46 * (parallel ? 1 + coordinateSum(a.origin) / length : 1);
            sides[i] = {normal, glm::dot(normal, a.origin) + spread, rounding / sine};
            place = std::max(place, coordinateSum(a.origin));
        }
    }

    /// Whether everything within `extent(normal)` [m] of `center`, measured along a side's normal,
    /// surely lies outside.
    template <class Extent>
    [[nodiscard]] bool misses(const DVec3& center, const Extent& extent) const {
        const double far = place + coordinateSum(center);
        for (const Side& side : sides)
            if (glm::dot(side.normal, center) - side.offset >
                extent(side.normal) + side.error * far)
                return true;
        return false;
    }
};

}  // namespace glint
