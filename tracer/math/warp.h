// Maps from uniform numbers to shapes' and lobes' directions, each with its density. u lies in [0,
// 1)^2.
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

/// c0 + c1 x + c2 x^2 + ...
template <class T>
[[nodiscard]] constexpr T powerSeries(T, double c0) {
    return static_cast<T>(c0);
}
template <class T, class... More>
[[nodiscard]] constexpr T powerSeries(T x, double c0, More... more) {
    return static_cast<T>(c0) + x * powerSeries(x, more...);
}

/// (cos, sin) of an angle of at most an eighth of a turn to either side: within 1e-13 in double,
/// 2e-7 in float. Three times as fast as the library's, which spend their time on the last bits and
/// on huge arguments.
[[nodiscard]] inline DVec2 cosSinEighth(double x) {
    const double x2 = x * x;
    return {powerSeries(x2, 1, -0.5, 1.0 / 24, -1.0 / 720, 1.0 / 40320, -1.0 / 3628800,
                        1.0 / 479001600, -1.0 / 87178291200),
            x * powerSeries(x2, 1, -1.0 / 6, 1.0 / 120, -1.0 / 5040, 1.0 / 362880, -1.0 / 39916800,
                            1.0 / 6227020800)};
}
[[nodiscard]] inline Vec2 cosSinEighth(float x) {
    const float x2 = x * x;
    return {powerSeries(x2, 1, -0.5, 1.0 / 24, -1.0 / 720, 1.0 / 40320),
            x * powerSeries(x2, 1, -1.0 / 6, 1.0 / 120, -1.0 / 5040, 1.0 / 362880)};
}

/// (cos, sin) of 2 pi u for |u| <= 2^20, within 1e-13.
[[nodiscard]] inline DVec2 cosSinTurn(double u) {
    const double quarter = std::floor(4 * u + 0.5);
    const DVec2 within = cosSinEighth((kPi / 2) * (4 * u - quarter));
    const int q = static_cast<int>(quarter) & 3;
    const double a = q & 1 ? -within.y : within.x, b = q & 1 ? within.x : within.y;
    return q & 2 ? DVec2(-a, -b) : DVec2(a, b);
}

/// The place in [0, 1] at which a density that goes linearly from a to b has the share `u` of its
/// integral before it; a + b > 0.
template <class T>
[[nodiscard]] inline T invertLinearDensity(T u, T a, T b) {
    const T denominator = a + std::sqrt(std::max(T(0), (1 - u) * a * a + u * b * b));
    return denominator > 0 ? std::min(T(1), u * (a + b) / denominator) : T(0);
}

/// Uniform over the sphere of directions.
[[nodiscard]] inline DVec3 uniformSphere(const DVec2& u) {
    const double z = 1 - 2 * u.x, r = std::sqrt(std::max(0.0, 1 - z * z));
    return {r * cosSinTurn(u.y), z};
}
inline constexpr double kUniformSpherePdf = 1 / (4 * kPi);

/// Concentric map of the square to the unit disk (Shirley and Chiu, JGT 2(3), 1997), and the
/// radius.
template <class T>
struct DiskPoint {
    glm::vec<2, T> at;
    T radius;
};
template <class T>
[[nodiscard]] inline DiskPoint<T> concentricPoint(const glm::vec<2, T>& u) {
    const T a = 2 * u.x - 1, b = 2 * u.y - 1;
    const bool wide = std::abs(a) > std::abs(b);
    const T radius = wide ? a : b, other = wide ? b : a;
    if (radius == 0) return {glm::vec<2, T>(0), 0};
    const glm::vec<2, T> to = radius * cosSinEighth(static_cast<T>(kPi / 4) * (other / radius));
    return {wide ? to : glm::vec<2, T>(to.y, to.x), std::abs(radius)};
}
[[nodiscard]] inline DVec2 concentricDisk(const DVec2& u) { return concentricPoint(u).at; }

/// Cosine-weighted over the upper hemisphere; density cos(theta) / pi.
[[nodiscard]] inline Vec3 cosineHemisphere(const Vec2& u) {
    const DiskPoint<float> d = concentricPoint(u);
    return {d.at, std::sqrt((1 - d.radius) * (1 + d.radius))};
}

/// Solid angle of a cone of half angle theta: 2 pi (1 - cos theta), free of cancellation.
[[nodiscard]] inline double coneSolidAngle(double sin2Theta) {
    return 2 * kPi * sin2Theta / (1 + std::sqrt(std::max(0.0, 1 - sin2Theta)));
}

/// Uniform in the cone of half angle theta (sin2Theta <= 1, theta <= 90 degrees) about the unit
/// vector `axis`.
[[nodiscard]] inline DirectionSample uniformCone(const DVec3& axis, double sin2Theta,
                                                 const DVec2& u) {
    const double oneMinusCosMax = sin2Theta / (1 + std::sqrt(std::max(0.0, 1 - sin2Theta)));
    const double oneMinusCos = u.x * oneMinusCosMax;
    const double r = std::sqrt(std::max(0.0, oneMinusCos * (2 - oneMinusCos)));
    return {Frame(axis).toWorld(DVec3(r * cosSinTurn(u.y), 1 - oneMinusCos)),
            1 / (2 * kPi * oneMinusCosMax)};
}

/// Uniform in the solid angle of a sphere at `center` with `radius`, seen from the origin; the
/// whole sphere of directions from inside. The density depends only on the place, so sample and pdf
/// cannot disagree.
[[nodiscard]] inline double sphereDirectionPdf(const DVec3& center, double radius) {
    const double d2 = glm::dot(center, center), r2 = radius * radius;
    return d2 <= r2 ? kUniformSpherePdf : 1 / coneSolidAngle(r2 / d2);
}
[[nodiscard]] inline DirectionSample sampleSphereDirection(const DVec3& center, double radius,
                                                           const DVec2& u) {
    const double d2 = glm::dot(center, center), r2 = radius * radius;
    if (d2 <= r2) return {uniformSphere(u), kUniformSpherePdf};
    return uniformCone(center / std::sqrt(d2), r2 / d2, u);
}

}  // namespace glint
