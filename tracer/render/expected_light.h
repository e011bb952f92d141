// What to expect of a branch that goes on only by chance. Taken for its light where it does not go
// on, so that one that does tells the difference alone: a control variate for the roulette, free of
// bias whatever is expected, as long as the branch's own light has no part in it.
#pragma once

#include <array>
#include <cmath>

#include "tracer/color/rgb.h"
#include "tracer/math/types.h"

namespace glint {

/// Learns from the branches that have gone on: by the octant that they went into, a mean over the
/// last ones. Takes more than half of the variance of roulette away (expected_light_test.cpp).
class ExpectedLight {
  public:
    [[nodiscard]] const Rgb& towards(const DVec3& direction) const {
        return radiance_[octant(direction)];
    }
    /// A branch of this weight brought so much more than weight times what was expected. Channels
    /// without weight tell nothing, nor do those that overflow.
    void learn(const DVec3& direction, const Rgb& weight, const Rgb& more) {
        Rgb& radiance = radiance_[octant(direction)];
        for (int c = 0; c < 3; ++c)
            if (const float news = kNews * more[c] / weight[c]; std::isfinite(news))
                radiance[c] += news;
    }

  private:
    static constexpr float kNews = 1.0f / 16;  ///< share of a branch in what is expected after it
    static std::size_t octant(const DVec3& d) {
        return (d.x > 0 ? 1u : 0u) + (d.y > 0 ? 2u : 0u) + (d.z > 0 ? 4u : 0u);
    }
    std::array<Rgb, 8> radiance_{};
};

}  // namespace glint
