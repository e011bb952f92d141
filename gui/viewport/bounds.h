// Boxes in world space around what a scene holds. Infinite planes have none.
#pragma once

#include <vector>

#include "gui/app/item.h"
#include "tracer/math/bounds.h"

namespace glint {

/// Points on the surface whose convex hull covers the shape to about 1 %, in object space. Empty
/// for an infinite plane.
[[nodiscard]] std::vector<DVec3> hullPoints(const Shape& shape);
[[nodiscard]] Bounds boundsOf(const Scene& scene, const std::vector<Item>& items);
/// Of all visible objects and lights.
[[nodiscard]] Bounds boundsOf(const Scene& scene);

}  // namespace glint
