// Affine transforms in double precision. Composition chains right to left: worldFromGroup *
// groupFromObject.
#pragma once

#include <optional>

#include "tracer/math/types.h"

namespace glint {

/// x -> linear * x + translation.
struct Affine {
    DMat3 linear{1.0};
    DVec3 translation{0.0};

    bool operator==(const Affine&) const = default;
    [[nodiscard]] DVec3 point(const DVec3& p) const { return linear * p + translation; }
    [[nodiscard]] DVec3 vector(const DVec3& v) const { return linear * v; }
};

[[nodiscard]] inline Affine operator*(const Affine& a, const Affine& b) {
    return {a.linear * b.linear, a.linear * b.translation + a.translation};
}

/// The inverse, or nothing where the linear part is singular or not finite. The test is free of
/// scale: the determinant against the product of the column lengths.
[[nodiscard]] inline std::optional<Affine> inverse(const Affine& a) {
    const double det = glm::determinant(a.linear);
    const double lengths =
        glm::length(a.linear[0]) * glm::length(a.linear[1]) * glm::length(a.linear[2]);
    if (!std::isfinite(det) || !isFinite(a.translation) || !(std::abs(det) > 1e-13 * lengths))
        return std::nullopt;
    // By cofactors, which lose the digits that the determinant does; those of long double are
    // spare.
    const DMat3 inv(glm::inverse(glm::mat<3, 3, long double>(a.linear)));
    if (!isFinite(inv[0]) || !isFinite(inv[1]) || !isFinite(inv[2])) return std::nullopt;
    return Affine{inv, -(inv * a.translation)};
}

/// R = Rz * Ry * Rx for angles in degrees (x applied first). Multiples of 90 degrees give exact
/// entries.
[[nodiscard]] inline DMat3 rotationFromDegrees(const DVec3& degrees) {
    const auto sinCos = [](double angle) -> DVec2 {
        const double turn = std::remainder(angle, 360.0);
        if (turn == 0) return {0, 1};
        if (turn == 90) return {1, 0};
        if (turn == -90) return {-1, 0};
        if (std::abs(turn) == 180) return {0, -1};
        return {std::sin(degreesToRadians(turn)), std::cos(degreesToRadians(turn))};
    };
    const DVec2 x = sinCos(degrees.x), y = sinCos(degrees.y), z = sinCos(degrees.z);
    const DMat3 rx(DVec3(1, 0, 0), DVec3(0, x.y, x.x), DVec3(0, -x.x, x.y));
    const DMat3 ry(DVec3(y.y, 0, -y.x), DVec3(0, 1, 0), DVec3(y.x, 0, y.y));
    const DMat3 rz(DVec3(z.y, z.x, 0), DVec3(-z.x, z.y, 0), DVec3(0, 0, 1));
    return rz * ry * rx;
}

}  // namespace glint
