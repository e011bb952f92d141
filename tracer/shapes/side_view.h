// A shape with straight sides as seen from a point, in the space in which its sides have the
// lengths that they have in the world. Without shear that is the world, turned.
#pragma once

#include "tracer/math/warp.h"
#include "tracer/shapes/viewpoint.h"

namespace glint {

struct SideView {
    DVec3 half;    ///< lengths of the shape's unit vectors in the world
    DVec3 origin;  ///< the point

    explicit SideView(const Viewpoint& view)
        : half(glm::length(view.worldFromLocal[0]), glm::length(view.worldFromLocal[1]),
               glm::length(view.worldFromLocal[2])),
          origin(view.origin * half) {}

    /// From the shape's space; of unit length.
    [[nodiscard]] DVec3 direction(const DVec3& d) const { return glm::normalize(d * half); }
    /// A density of this space towards `d`, a unit direction of the shape's space, as one of the
    /// world.
    [[nodiscard]] double worldDensity(const Viewpoint& view, const DVec3& d, double density) const {
        const double length = glm::length(d * half);
        return view.worldDensity(d,
                                 density * half.x * half.y * half.z / (length * length * length));
    }
    /// A sample of this space as one of the shape's space, with the world's density.
    [[nodiscard]] DirectionSample toShape(const Viewpoint& view, const DirectionSample& s) const {
        const DVec3 d = glm::normalize(s.direction / half);
        return {d, worldDensity(view, d, s.pdf)};
    }
};

}  // namespace glint
