// Colours: linear Rec.709. `Color` is the document's (doubles), `Rgb` the kernel's (floats).
// Neither is clamped.
#pragma once

#include "tracer/math/types.h"

namespace glint {

using Rgb = Vec3;

/// A colour in the document.
struct Color {
    double r = 0, g = 0, b = 0;
    bool operator==(const Color&) const = default;
};

[[nodiscard]] inline Rgb toRgb(const Color& c) {
    return {static_cast<float>(c.r), static_cast<float>(c.g), static_cast<float>(c.b)};
}

[[nodiscard]] inline DVec3 toVector(const Color& c) { return {c.r, c.g, c.b}; }

/// Relative luminance (Rec.709 weights).
[[nodiscard]] inline float luminance(const Rgb& c) {
    return 0.2126f * c.x + 0.7152f * c.y + 0.0722f * c.z;
}
[[nodiscard]] inline double luminance(const Color& c) {
    return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b;
}
[[nodiscard]] inline bool isBlack(const Rgb& c) { return c.x == 0 && c.y == 0 && c.z == 0; }
[[nodiscard]] inline bool isBlack(const Color& c) { return c.r == 0 && c.g == 0 && c.b == 0; }

}  // namespace glint
