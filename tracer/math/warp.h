// Maps from uniform numbers to shapes' and lobes' directions, each with its density. u lies in [0, 1)^2.
#pragma once

#include <algorithm>

#include "tracer/math/frame.h"
#include "tracer/math/types.h"

namespace glint {

/// A direction (unit) and its density per solid angle; density 0 means "no sample".
struct DirectionSample {
    DVec3 direction{0.0};
    double pdf = 0;
};

/// Uniform over the sphere of directions.
[[nodiscard]] inline DVec3 uniformSphere(const DVec2& u) {
    const double z = 1 - 2 * u.x, r = std::sqrt(std::max(0.0, 1 - z * z)), phi = 2 * kPi * u.y;
    return {r * std::cos(phi), r * std::sin(phi), z};
}
inline constexpr double kUniformSpherePdf = 1 / (4 * kPi);

/// Concentric map of the square to the unit disk (Shirley and Chiu, JGT 2(3), 1997).
[[nodiscard]] inline DVec2 concentricDisk(const DVec2& u) {
    const double a = 2 * u.x - 1, b = 2 * u.y - 1;
    if (a == 0 && b == 0) return DVec2(0.0);
    const bool wide = std::abs(a) > std::abs(b);
    const double r = wide ? a : b;
    const double phi = wide ? kPi / 4 * (b / a) : kPi / 2 - kPi / 4 * (a / b);
    return {r * std::cos(phi), r * std::sin(phi)};
}

/// Cosine-weighted over the upper hemisphere; density cos(theta) / pi.
[[nodiscard]] inline Vec3 cosineHemisphere(const Vec2& u) {
    const DVec2 d = concentricDisk(u);
    const double z = std::sqrt(std::max(0.0, 1 - glm::dot(d, d)));
    return {static_cast<float>(d.x), static_cast<float>(d.y), static_cast<float>(z)};
}

/// Solid angle of a cone of half angle theta: 2 pi (1 - cos theta), free of cancellation.
[[nodiscard]] inline double coneSolidAngle(double sin2Theta) {
    return 2 * kPi * sin2Theta / (1 + std::sqrt(std::max(0.0, 1 - sin2Theta)));
}

/// Uniform in the cone of half angle theta (sin2Theta <= 1, theta <= 90 degrees) about the unit vector `axis`.
[[nodiscard]] inline DirectionSample uniformCone(const DVec3& axis, double sin2Theta, const DVec2& u) {
    const double oneMinusCosMax = sin2Theta / (1 + std::sqrt(std::max(0.0, 1 - sin2Theta)));
    const double oneMinusCos = u.x * oneMinusCosMax;
    const double r = std::sqrt(std::max(0.0, oneMinusCos * (2 - oneMinusCos))), phi = 2 * kPi * u.y;
    return {Frame(axis).toWorld(DVec3(r * std::cos(phi), r * std::sin(phi), 1 - oneMinusCos)),
            1 / (2 * kPi * oneMinusCosMax)};
}

/// Uniform in the solid angle of a sphere at `center` with `radius`, seen from the origin; the whole sphere of directions
/// from inside. The density depends only on the place, so sample and pdf cannot disagree.
[[nodiscard]] inline double sphereDirectionPdf(const DVec3& center, double radius) {
    const double d2 = glm::dot(center, center), r2 = radius * radius;
    return d2 <= r2 ? kUniformSpherePdf : 1 / coneSolidAngle(r2 / d2);
}
[[nodiscard]] inline DirectionSample sampleSphereDirection(const DVec3& center, double radius, const DVec2& u) {
    const double d2 = glm::dot(center, center), r2 = radius * radius;
    if (d2 <= r2) return {uniformSphere(u), kUniformSpherePdf};
    return uniformCone(center / std::sqrt(d2), r2 / d2, u);
}

}  // namespace glint
