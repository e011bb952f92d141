// Names for GLM's types. Geometry is double (DVec3), radiometry and sampling are float (Vec2,
// Vec3).
#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <limits>
#include <numbers>

namespace glint {

using Vec2 = glm::vec2;
using Vec3 = glm::vec3;
using DVec2 = glm::dvec2;
using DVec3 = glm::dvec3;
using DMat3 = glm::dmat3;  ///< column-major: m[column][row]

inline constexpr double kPi = std::numbers::pi;
inline constexpr float kPiF = std::numbers::pi_v<float>;
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

[[nodiscard]] inline double degreesToRadians(double degrees) { return degrees * (kPi / 180.0); }
[[nodiscard]] inline double radiansToDegrees(double radians) { return radians * (180.0 / kPi); }
[[nodiscard]] inline Vec3 toFloat(const DVec3& v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}
[[nodiscard]] inline DVec3 toDouble(const Vec3& v) { return {v.x, v.y, v.z}; }
[[nodiscard]] inline bool isFinite(const DVec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}
[[nodiscard]] inline bool isFinite(const Vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}
/// Of unit length, from a vector that is so up to errors of floats: mostly without a root or a
/// division.
[[nodiscard]] inline DVec3 renormalize(const DVec3& v) {
    const double off = glm::dot(v, v) - 1;
    if (!(std::abs(off) < 0x1p-17)) return glm::normalize(v);
    return v * (1 + off * (0.375 * off -
                           0.5));  // (1 + off)^(-1/2) but for 5/16 off^3: less than a rounding.
}
/// The size of each coordinate. Not by glm::abs(), whose branches guess signs wrong.
[[nodiscard]] inline DVec3 absolute(const DVec3& v) {
    return {std::abs(v.x), std::abs(v.y), std::abs(v.z)};
}
[[nodiscard]] inline Vec3 absolute(const Vec3& v) {
    return {std::abs(v.x), std::abs(v.y), std::abs(v.z)};
}
/// Of a point from the y axis. 0 below 1e-154: a place of no area on anything of size 1.
[[nodiscard]] inline double axisDistance(const DVec3& p) {
    return std::sqrt(p.x * p.x + p.z * p.z);
}
/// At least the largest absolute coordinate.
[[nodiscard]] inline double coordinateSum(const DVec3& v) {
    return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}
[[nodiscard]] inline double maxComponent(const DVec3& v) {
    return std::max(v.x, std::max(v.y, v.z));
}
[[nodiscard]] inline float maxComponent(const Vec3& v) { return std::max(v.x, std::max(v.y, v.z)); }

}  // namespace glint
