// A straight strip as seen from a point: the building block of directions that are even in solid
// angle.
#pragma once

#include <algorithm>

#include "tracer/math/types.h"

namespace glint {

/// The segment from z0 to z1 of a line whose nearest point, at z = 0, is the root of `h2` away.
/// Seen under a narrow angle across, a strip along it holds solid angle in proportion to the sine
/// of the elevation z / sqrt(h2 + z^2) (Archimedes).
struct SolidStrip {
    double h2, z0, z1;

    /// Difference of the sines at both ends, at most 2; without cancellation for strips far off
    /// along the line.
    [[nodiscard]] double sines() const {
        const double d0 = distance(z0), d1 = distance(z1);
        if (!(z0 * z1 > 0)) return z1 / d1 - z0 / d0;
        return h2 * (z1 - z0) * (z1 + z0) / (d0 * d1 * (z1 * d0 + z0 * d1));
    }
    /// The place before which the share `u` of the sines lies.
    [[nodiscard]] double sample(double u) const {
        const double sine = glm::mix(z0 / distance(z0), z1 / distance(z1), u);
        const double cosine2 = (1 - sine) * (1 + sine);
        return cosine2 > 0 ? std::clamp(sine * std::sqrt(h2 / cosine2), z0, z1)
                           : glm::mix(z0, z1, u);
    }

  private:
    [[nodiscard]] double distance(double z) const { return std::sqrt(h2 + z * z); }
};

}  // namespace glint
