// A point that looks at a shape: where it is in the shape's canonical space, and how that space
// lies in the world, so that directions can be drawn evenly in the world's angles however the shape
// is stretched.
#pragma once

#include "tracer/math/warp.h"

namespace glint {

/// Points no farther outside of a curved shape than this, over its size, look at it as from inside:
/// where rounding decides on which side a point of the surface is, the part in view cannot be told.
inline constexpr double kSkin = 1e-9;

struct Viewpoint {
    DVec3 origin;               ///< in the shape's canonical space
    DMat3 worldFromLocal{1.0};  ///< of vectors

    /// Without a transform: the shape's own space is the world.
    Viewpoint(const DVec3& point, const DMat3& transform = DMat3(1.0))
        : origin(point), worldFromLocal(transform) {}

    /// From the point to the place `p` of the shape's space, in the world.
    [[nodiscard]] DVec3 toWorld(const DVec3& p) const { return worldFromLocal * (p - origin); }
    /// A sample towards the place `p`; none where the point itself lies there.
    [[nodiscard]] DirectionSample towards(const DVec3& p, double density) const {
        const DVec3 to = p - origin;
        const double distance = glm::length(to);
        if (!(distance > 0 && density > 0)) return {};
        return {to / distance, density};
    }
    /// The density per solid angle of the world towards the unit direction `d` of the shape's
    /// space, from the one per solid angle there.
    [[nodiscard]] double worldDensity(const DVec3& d, double localDensity) const {
        const double length = glm::length(worldFromLocal * d);
        return localDensity * length * length * length / std::abs(glm::determinant(worldFromLocal));
    }
};

}  // namespace glint
