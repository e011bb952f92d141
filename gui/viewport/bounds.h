// Bounds: an axis-aligned box in world space, and those of what a scene holds. Infinite planes have
// none.
#pragma once

#include <vector>

#include "gui/app/item.h"

namespace glint {

struct Bounds {
    DVec3 min{kInfinity}, max{-kInfinity};

    [[nodiscard]] bool isEmpty() const { return !(min.x <= max.x); }
    [[nodiscard]] DVec3 center() const { return (min + max) / 2.0; }
    /// Of the sphere around the box.
    [[nodiscard]] double radius() const { return glm::length(max - min) / 2; }
    void add(const DVec3& point) {
        min = glm::min(min, point);
        max = glm::max(max, point);
    }
};

/// Points on the surface whose convex hull covers the shape to about 1 %, in object space. Empty
/// for an infinite plane.
[[nodiscard]] std::vector<DVec3> hullPoints(const Shape& shape);
[[nodiscard]] Bounds boundsOf(const Scene& scene, const std::vector<Item>& items);
/// Of all visible objects and lights.
[[nodiscard]] Bounds boundsOf(const Scene& scene);

}  // namespace glint
