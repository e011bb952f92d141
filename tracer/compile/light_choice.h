// Choosing one of many lights for a point: by what each could send there at most, from its power,
// distance, side and the directions it shines in, in two steps: a cluster of neighbours, then a
// light of it. Of n lights about 2 sqrt(n) are looked at, all where they are few and aimed. The
// idea is that of light trees (Conty Estevez and Kulla, "Importance Sampling of Many Lights with
// Adaptive Tree Splitting", HPG 2018) with two levels. By power alone the error of 64 lamps over a
// floor is 1.13 times as large at the same samples, of 1000 as in `glint-bench scale` more:
// glint-bench choices --only lights.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "tracer/math/types.h"

namespace glint {

/// The directions that a light shines in: those within `spread` of `axis` as strongly as it can,
/// weaker beyond, none from `spread` and the angle of `cosBeyond` together on (Conty Estevez and
/// Kulla 2018, sec. 4.1).
struct LightAim {
    DVec3 axis{0.0};    ///< unit; 0: all directions alike
    double spread = 0;  ///< rad
    double cosSpread = 1, sinSpread = 0;
    double cosBeyond = 0;  ///< 0: as the cosine, like a surface; above: only so far

    LightAim() = default;
    LightAim(const DVec3& towards, double spreadAngle, double beyond)
        : axis(towards),
          spread(spreadAngle),
          cosSpread(std::cos(spreadAngle)),
          sinSpread(std::sin(spreadAngle)),
          cosBeyond(beyond) {}
    [[nodiscard]] bool everywhere() const { return axis == DVec3(0.0); }
    /// At most what is sent, of 1, at the cosine of an angle to the axis, less an angle of this
    /// sine.
    [[nodiscard]] double sent(double cosine, double lessSine) const {
        if (cosine >= cosSpread) return 1;
        if (spread > 0)
            cosine = cosine * cosSpread + std::sqrt(std::max(0.0, 1 - cosine * cosine)) * sinSpread;
        const double most = cosine + lessSine;  // cos (a - b) is at most cos a + sin b.
        return most > cosBeyond ? std::min(1.0, most) : 0;
    }
};

/// A light, or some together, as a choice sees it.
struct LightBounds {
    DVec3 center{0.0};
    double radius = 0;  ///< of a ball around it; infinite: light from infinitely far
    double power =
        0;  ///< over squared distance, or by itself if infinitely far, the irradiance it could give
    LightAim aim;

    /// Bound-like guess of the irradiance at a point, on the side that `normal` points to; > 0
    /// where the power is and light of it can come.
    [[nodiscard]] double importance(const DVec3& from, const DVec3& normal) const {
        if (radius == kInfinity)
            return aim.everywhere() ? power
                                    : power * std::clamp(aim.sinSpread - glm::dot(aim.axis, normal),
                                                         kBehind, 1.0);
        const DVec3 to = center - from;
        const double d2 = glm::dot(to, to), near2 = std::max(d2, radius * radius);
        if (!(near2 > 0)) return power;
        const double nearness = 1 / std::sqrt(near2);
        const double cosine = (glm::dot(to, normal) + radius) * nearness;
        const double sent = aim.everywhere() || d2 < near2
                                ? 1.0
                                : aim.sent(-glm::dot(aim.axis, to) * nearness, radius * nearness);
        return power * sent * std::clamp(cosine, kBehind, 1.0) * (nearness * nearness);
    }

  private:
    /// Surfaces may let light through from behind, so it has its chance.
    static constexpr double kBehind = 0.05;
};

class LightChoice {
  public:
    LightChoice() = default;
    /// One bound a light; lights without power are chosen only if none has any.
    explicit LightChoice(std::vector<LightBounds> lights);

    struct Chosen {
        std::uint32_t light = 0;
        double probability = 1;  ///< 0: none, no light comes here
    };
    /// A light for u in [0, 1).
    [[nodiscard]] Chosen choose(const DVec3& from, const DVec3& normal, double u) const;
    /// The probability with which choose() takes a light.
    [[nodiscard]] double probability(const DVec3& from, const DVec3& normal,
                                     std::uint32_t light) const;

  private:
    /// Lights order_[begin, end).
    struct Cluster {
        LightBounds bounds;
        std::uint32_t begin = 0, end = 0;
    };
    template <class Weight>
    static Chosen pick(std::uint32_t begin, std::uint32_t end, double& u, const Weight& weight);

    std::vector<LightBounds> lights_;   ///< in the order of the table
    std::vector<std::uint32_t> order_;  ///< neighbours together
    std::vector<std::uint32_t> clusterOf_;
    std::vector<Cluster> clusters_;
};

}  // namespace glint
