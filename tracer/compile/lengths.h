// Lengths that geometry can be computed with.
#pragma once

#include "tracer/math/types.h"

namespace glint {

/// [m]: their cubes are far from the ends of double.
inline constexpr double kLeastLength = 1e-90, kMostLength = 1e90;
inline constexpr const char* kLengthRemedy =
    "scale the scene: lengths from 1e-90 to 1e90 m can be computed with";

[[nodiscard]] inline double largest(const DVec3& v) { return maxComponent(absolute(v)); }

}  // namespace glint
