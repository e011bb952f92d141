// Bounds: an axis-aligned box.
#pragma once

#include "tracer/math/types.h"

namespace glint {

/// Empty to begin with.
struct Bounds {
    DVec3 lower{kInfinity}, upper{-kInfinity};

    /// Ends are included.
    [[nodiscard]] static Bounds around(const DVec3& center, const DVec3& half) {
        return {center - half, center + half};
    }
    void add(const DVec3& p) { lower = glm::min(lower, p), upper = glm::max(upper, p); }
    void add(const Bounds& b) {
        lower = glm::min(lower, b.lower), upper = glm::max(upper, b.upper);
    }
    [[nodiscard]] bool isEmpty() const { return !(lower.x <= upper.x); }
    [[nodiscard]] bool touches(const Bounds& b) const {
        return glm::all(glm::lessThanEqual(lower, b.upper)) &&
               glm::all(glm::lessThanEqual(b.lower, upper));
    }
    [[nodiscard]] DVec3 center() const { return (lower + upper) / 2.0; }
    /// Of the sphere around the box.
    [[nodiscard]] double radius() const { return glm::length(upper - lower) / 2; }
    /// Of half its surface.
    [[nodiscard]] double area() const {
        const DVec3 e = upper - lower;
        return e.x * e.y + e.y * e.z + e.z * e.x;
    }
};

}  // namespace glint
