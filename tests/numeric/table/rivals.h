// How others intersect a ball, small enough to stand here: comparison models for the table in
// tests/numeric/README.md. They see the same ray, rounded to float where the original works in
// float. Each returns the nearer root, or infinity.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "tracer/math/types.h"

namespace glint::rivals {

/// b^2 - 4 a c, as in every first ray tracer.
template <class Real>
[[nodiscard]] double naive(const DVec3& origin, const DVec3& direction, const DVec3& center,
                           double radius) {
    using V = glm::vec<3, Real>;
    const V o = V(origin) - V(center), d(direction);
    const Real r = static_cast<Real>(radius);
    const Real a = glm::dot(d, d), b = 2 * glm::dot(o, d), c = glm::dot(o, o) - r * r,
               discriminant = b * b - 4 * a * c;
    if (discriminant < 0) return kInfinity;
    return static_cast<double>((-b - std::sqrt(discriminant)) / (2 * a));
}

/// Perpendicular discriminant in float, as in Embree 3's sphere points and in Cycles.
[[nodiscard]] inline double perpendicular(const DVec3& origin, const DVec3& direction,
                                          const DVec3& center, double radius) {
    const Vec3 toCenter = Vec3(center) - Vec3(origin), d(direction);
    const float r = static_cast<float>(radius), inverse = 1 / glm::dot(d, d),
                along = glm::dot(toCenter, d) * inverse;
    const Vec3 perpendicular = toCenter - along * d;
    const float left = r * r - glm::dot(perpendicular, perpendicular);
    if (left < 0) return kInfinity;
    return static_cast<double>(along - std::sqrt(left * inverse));
}

/// The same with the smaller root by division (Haines et al., Ray Tracing Gems, ch. 7), in float.
[[nodiscard]] inline double gems7(const DVec3& origin, const DVec3& direction, const DVec3& center,
                                  double radius) {
    const Vec3 f = Vec3(origin) - Vec3(center), d(direction);
    const float r = static_cast<float>(radius), a = glm::dot(d, d), b = -glm::dot(f, d),
                c = glm::dot(f, f) - r * r;
    const Vec3 nearest = f + (b / a) * d;
    const float discriminant = r * r - glm::dot(nearest, nearest);
    if (discriminant < 0) return kInfinity;
    const float q = b + std::copysign(std::sqrt(a * discriminant), b);
    return static_cast<double>(std::min(c / q, q / a));
}

/// Whether a float ray meets the ball at any t above 0, by gems7()'s two roots.
[[nodiscard]] inline bool anyHit(const Vec3& origin, const Vec3& direction, const DVec3& center,
                                 double radius) {
    const Vec3 f = origin - Vec3(center);
    const float r = static_cast<float>(radius), a = glm::dot(direction, direction),
                b = -glm::dot(f, direction), c = glm::dot(f, f) - r * r;
    const Vec3 nearest = f + (b / a) * direction;
    const float discriminant = r * r - glm::dot(nearest, nearest);
    if (discriminant < 0) return false;
    const float q = b + std::copysign(std::sqrt(a * discriminant), b);
    return std::max(c / q, q / a) > 0;
}

/// Where a ray starts that leaves the float point `p` along the side of `n`: Wächter and Binder,
/// Ray Tracing Gems, ch. 6; as in Cycles.
[[nodiscard]] inline Vec3 gems6(const Vec3& p, const Vec3& n) {
    constexpr float kOrigin = 1.0f / 32, kFloatScale = 1.0f / 65536, kIntScale = 256;
    Vec3 out;
    for (int i = 0; i < 3; ++i) {
        const auto steps = static_cast<std::int32_t>(kIntScale * n[i]);
        const auto bits = std::bit_cast<std::int32_t>(p[i]);
        const float moved = std::bit_cast<float>(bits + (p[i] < 0 ? -steps : steps));
        out[i] = std::abs(p[i]) < kOrigin ? p[i] + kFloatScale * n[i] : moved;
    }
    return out;
}

}  // namespace glint::rivals
