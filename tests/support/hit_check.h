// One ray on one shape: the tracer's answer held against the quad-precision reference.
#pragma once

#include "tests/support/quad_math.h"
#include "tests/support/rays.h"

namespace glint::test {

/// Length of the longest column: the shape's size in render space.
[[nodiscard]] inline double sizeOf(const ShapeInstance& s) {
    const DMat3& m = s.worldFromLocal;
    return std::sqrt(std::max({glm::dot(m[0], m[0]), glm::dot(m[1], m[1]), glm::dot(m[2], m[2])}));
}

/// What rounding may move a surface by, in canonical units: a few roundings of the numbers that
/// place the ray relative to the shape, as far as the transform stretches them. Hits and misses
/// within this band of a silhouette are both right.
[[nodiscard]] inline double roundingBand(const ShapeInstance& s, const DVec3& origin) {
    const auto norm = [](const DMat3& m) {
        return std::sqrt(glm::dot(m[0], m[0]) + glm::dot(m[1], m[1]) + glm::dot(m[2], m[2]));
    };
    const double condition = norm(s.worldFromLocal) * norm(s.localFromWorld);
    return 16 * 0x1p-53 * condition * (1 + norm(s.localFromWorld) * glm::length(origin - s.center));
}

/// Sine of the angle at which a flat shape is seen; 1 for solids.
[[nodiscard]] inline double sineOfView(const CanonicalShape& shape, const QuadRay& local) {
    const bool flat = std::holds_alternative<CanonicalPlane>(shape) ||
                      std::holds_alternative<CanonicalQuad>(shape) ||
                      std::holds_alternative<CanonicalDisk>(shape);
    return flat ? static_cast<double>(absolute(local.d.y) / squareRoot(dot(local.d, local.d))) : 1;
}

/// Counts one check. The error is |dt| in units of max(float ulp of t, 2^-24 of the size); more
/// than one unit fails, and so does a hit or miss that the reference has otherwise, unless it is
/// within the rounding band of a silhouette.
inline void checkHit(const ShapeInstance& instance, const ShapeLists& lists, const Ray& ray,
                     Tally& tally) {
    ++tally.checks;
    const ShapeHit hit = lists.closest(ray, {});
    const QuadRay local = localRay(instance, ray);
    if (std::isnan(hit.t)) return tally.fail("t is no number: " + replay(instance, ray));
    // Seen edge-on, the rounding of the direction decides where and whether a flat shape is met.
    const double sine = sineOfView(instance.shape, local);
    if (sine < 1e-6) return;
    const auto exact = firstReference(instance.shape, local);
    if (!hit.found() && !exact) return;
    if (hit.found() && exact) {
        const double t = static_cast<double>(*exact),
                     unit = std::max(floatUlp(t), 0x1p-24 * sizeOf(instance));
        const double error = static_cast<double>(absolute(Float128(hit.t) - *exact)) / unit;
        if (error <= 1) return tally.error(error);
    }
    const double band = roundingBand(instance, ray.origin) / sine;
    const auto grown = firstReference(instance.shape, local, band),
               shrunk = firstReference(instance.shape, local, -band);
    if (grown.has_value() != shrunk.has_value()) return;
    if (hit.found() && grown && std::min(*grown, *shrunk) <= Float128(hit.t) &&
        Float128(hit.t) <= std::max(*grown, *shrunk))
        return;
    tally.fail(replay(instance, ray) + " t=" + std::to_string(hit.t) +
               " exact=" + (exact ? std::to_string(static_cast<double>(*exact)) : "miss"));
}

}  // namespace glint::test
