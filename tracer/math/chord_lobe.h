// A lobe of directions about an axis with the tails of a GGX lobe's reflection.
#pragma once

#include "tracer/math/warp.h"

namespace glint {

/// Density per solid angle in proportion to 1 / (width^2 + q)^2, q the square of the distance on
/// the unit sphere to the axis. What GGX of alpha reflects of a narrow beam that comes down the
/// normal has this form with width 2 alpha.
class ChordLobe {
  public:
    /// `axis` has unit length; width2 > 0 is the square of the width.
    ChordLobe(const DVec3& axis, double width2) : axis_(axis), width2_(width2) {}

    /// u in [0, 1)^2.
    [[nodiscard]] DirectionSample sample(const DVec2& u) const {
        const double a = 4 * u.x / (width2_ + 4), q = std::min(4.0, width2_ * a / (1 - a));
        const double across = std::sqrt(std::max(0.0, q * (1 - q / 4)));
        return {Frame(axis_).toWorld(DVec3(across * cosSinTurn(u.y), 1 - q / 2)), density(q)};
    }
    [[nodiscard]] double pdf(const DVec3& direction) const {
        const DVec3 apart = direction - axis_;
        return density(glm::dot(apart, apart));
    }

  private:
    [[nodiscard]] double density(double q) const {
        return width2_ * (width2_ + 4) / (4 * kPi * (width2_ + q) * (width2_ + q));
    }

    DVec3 axis_;
    double width2_;
};

}  // namespace glint
