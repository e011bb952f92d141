// An orthonormal frame about a normal.
#pragma once

#include "tracer/math/types.h"

namespace glint {

/// Right-handed orthonormal basis with local z along `n`. Source: Duff et al., "Building an
/// Orthonormal Basis, Revisited", JCGT 6(1), 2017.
struct Frame {
    DVec3 s{1, 0, 0}, t{0, 1, 0}, n{0, 0, 1};

    Frame() = default;
    /// `normal` has unit length.
    explicit Frame(const DVec3& normal) : n(normal) {
        const double sign = std::copysign(1.0, n.z);
        const double a = -1.0 / (sign + n.z), b = n.x * n.y * a;
        s = {1.0 + sign * n.x * n.x * a, sign * b, -sign * n.x};
        t = {b, sign + n.y * n.y * a, -n.y};
    }

    [[nodiscard]] DVec3 toWorld(const DVec3& v) const { return v.x * s + v.y * t + v.z * n; }
    [[nodiscard]] DVec3 toWorld(const Vec3& v) const { return toWorld(toDouble(v)); }
    [[nodiscard]] DVec3 toLocal(const DVec3& v) const {
        return {glm::dot(v, s), glm::dot(v, t), glm::dot(v, n)};
    }
};

}  // namespace glint
