// Reference answers in quad precision (113 bits): the textbook solution of every shape, on the very
// numbers that the tracer is given. It shares no formula and no code with tracer/shapes. Both
// compilers have __float128; its library is not needed.
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "tracer/compile/shape_lists.h"

namespace glint::test {

using Float128 = __float128;

/// By Newton from the double root: full precision after two steps. Negative numbers and NaN give 0.
[[nodiscard]] inline Float128 squareRoot(Float128 v) {
    const double start = std::sqrt(static_cast<double>(v));
    if (!(start > 0) || std::isinf(start)) return 0;
    Float128 root = start;
    for (int i = 0; i < 3; ++i) root = (root + v / root) / 2;
    return root;
}
[[nodiscard]] inline Float128 absolute(Float128 v) { return v < 0 ? -v : v; }

struct QuadVec {
    Float128 x = 0, y = 0, z = 0;
    QuadVec() = default;
    QuadVec(Float128 a, Float128 b, Float128 c) : x(a), y(b), z(c) {}
    explicit QuadVec(const DVec3& v) : x(v.x), y(v.y), z(v.z) {}
    friend QuadVec operator+(const QuadVec& a, const QuadVec& b) {
        return {a.x + b.x, a.y + b.y, a.z + b.z};
    }
    friend QuadVec operator-(const QuadVec& a, const QuadVec& b) {
        return {a.x - b.x, a.y - b.y, a.z - b.z};
    }
    friend QuadVec operator*(Float128 s, const QuadVec& a) { return {s * a.x, s * a.y, s * a.z}; }
    [[nodiscard]] DVec3 rounded() const {
        return {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
    }
};
[[nodiscard]] inline Float128 dot(const QuadVec& a, const QuadVec& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
[[nodiscard]] inline QuadVec cross(const QuadVec& a, const QuadVec& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// A line in a shape's canonical space; t is that of the ray in render space.
struct QuadRay {
    QuadVec o, d;
    [[nodiscard]] QuadVec at(Float128 t) const { return o + t * d; }
};

/// M^-1 v by Cramer's rule, from the double matrix that defines the instance.
[[nodiscard]] inline QuadVec solve(const DMat3& m, const QuadVec& v) {
    const QuadVec a(m[0]), b(m[1]), c(m[2]);
    const Float128 determinant = dot(a, cross(b, c));
    return {dot(v, cross(b, c)) / determinant, dot(a, cross(v, c)) / determinant,
            dot(a, cross(b, v)) / determinant};
}
[[nodiscard]] inline QuadRay localRay(const ShapeInstance& instance, const Ray& ray) {
    return {solve(instance.worldFromLocal, QuadVec(ray.origin) - QuadVec(instance.center)),
            solve(instance.worldFromLocal, QuadVec(ray.direction))};
}

/// Crossings of a line with a surface, in order. Of closed shapes entries and exits take turns.
using QuadRoots = std::vector<Float128>;

namespace reference {

inline constexpr double kFar = 1e300;

/// Where a t^2 + 2 b t + c <= 0 (a > 0), or nothing.
inline QuadRoots quadratic(Float128 a, Float128 b, Float128 c) {
    const Float128 discriminant = b * b - a * c;
    if (discriminant < 0) return {};
    const Float128 root = squareRoot(discriminant);
    return {(-b - root) / a, (-b + root) / a};
}
/// The part of [roots] where -1 <= o + t d <= 1.
inline QuadRoots clipped(QuadRoots roots, Float128 o, Float128 d, Float128 low = -1,
                         Float128 high = 1) {
    if (roots.empty()) return {};
    if (d == 0) return o >= low && o <= high ? roots : QuadRoots{};
    Float128 enter = (low - o) / d, leave = (high - o) / d;
    if (enter > leave) std::swap(enter, leave);
    roots = {enter > roots[0] ? enter : roots[0], leave < roots[1] ? leave : roots[1]};
    return roots[0] <= roots[1] ? roots : QuadRoots{};
}

inline QuadRoots crossings(const CanonicalSphere&, const QuadRay& r) {
    return quadratic(dot(r.d, r.d), dot(r.o, r.d), dot(r.o, r.o) - 1);
}
inline QuadRoots crossings(const CanonicalBox&, const QuadRay& r) {
    return clipped(clipped(clipped({-kFar, kFar}, r.o.x, r.d.x), r.o.y, r.d.y), r.o.z, r.d.z);
}
inline QuadRoots crossings(const CanonicalPlane&, const QuadRay& r) {
    return r.d.y == 0 ? QuadRoots{} : QuadRoots{-r.o.y / r.d.y};
}
inline QuadRoots crossings(const CanonicalQuad&, const QuadRay& r) {
    if (r.d.y == 0) return {};
    const QuadVec p = r.at(-r.o.y / r.d.y);
    return absolute(p.x) <= 1 && absolute(p.z) <= 1 ? QuadRoots{-r.o.y / r.d.y} : QuadRoots{};
}
inline QuadRoots crossings(const CanonicalDisk&, const QuadRay& r) {
    if (r.d.y == 0) return {};
    const QuadVec p = r.at(-r.o.y / r.d.y);
    return p.x * p.x + p.z * p.z <= 1 ? QuadRoots{-r.o.y / r.d.y} : QuadRoots{};
}
inline QuadRoots crossings(const CanonicalCylinder&, const QuadRay& r) {
    const Float128 a = r.d.x * r.d.x + r.d.z * r.d.z, c = r.o.x * r.o.x + r.o.z * r.o.z - 1;
    const QuadRoots tube = a > 0    ? quadratic(a, r.o.x * r.d.x + r.o.z * r.d.z, c)
                           : c <= 0 ? QuadRoots{-kFar, kFar}
                                    : QuadRoots{};
    return clipped(tube, r.o.y, r.d.y);
}
inline QuadRoots crossings(const CanonicalCone&, const QuadRay& r) {
    // Within -1 <= y <= 1 there is one nappe only, so clip first and intersect the two intervals of
    // the double cone.
    const QuadRoots slab = clipped({-kFar, kFar}, r.o.y, r.d.y);
    if (slab.empty()) return {};
    const Float128 h = r.o.y - 1;
    const Float128 a = r.d.x * r.d.x + r.d.z * r.d.z - r.d.y * r.d.y / 4,
                   b = r.o.x * r.d.x + r.o.z * r.d.z - h * r.d.y / 4,
                   c = r.o.x * r.o.x + r.o.z * r.o.z - h * h / 4;
    const auto within = [&](Float128 lo, Float128 hi) {
        const QuadRoots out{lo > slab[0] ? lo : slab[0], hi < slab[1] ? hi : slab[1]};
        return out[0] <= out[1] ? out : QuadRoots{};
    };
    if (a > 0) {
        const QuadRoots roots = quadratic(a, b, c);
        return roots.empty() ? QuadRoots{} : within(roots[0], roots[1]);
    }
    if (a == 0) {
        if (b == 0) return c <= 0 ? slab : QuadRoots{};
        return b > 0 ? within(-kFar, -c / (2 * b)) : within(-c / (2 * b), kFar);
    }
    const QuadRoots roots = quadratic(-a, -b, -c);  // outside of the cone between these
    if (roots.empty()) return slab;
    const QuadRoots before = within(-kFar, roots[0]), after = within(roots[1], kFar);
    // The upper nappe's part is cut off by the slab, down to the apex itself.
    return before.empty() || (!after.empty() && after[1] - after[0] > before[1] - before[0])
               ? after
               : before;
}

/// Distance outside of the torus's surface; negative inside.
inline Float128 torusDistance(const CanonicalTorus& torus, const QuadVec& p) {
    const Float128 outwards = squareRoot(p.x * p.x + p.z * p.z) - 1;
    return squareRoot(outwards * outwards + p.y * p.y) - torus.ratio;
}
/// Walks along the line by the distance to the surface, which it cannot overstep; between crossings
/// nearer than that (1e-7 of the tube, and above the noise of double) it may see none. Each
/// crossing is then bisected in quad precision.
inline QuadRoots crossings(const CanonicalTorus& torus, const QuadRay& r) {
    const Float128 length = squareRoot(dot(r.d, r.d)), shift = -dot(r.o, r.d) / (length * length);
    const QuadVec p = r.at(shift), u = (1 / length) * r.d;
    const Float128 half2 = (1 + Float128(torus.ratio)) * (1 + Float128(torus.ratio)) - dot(p, p);
    if (half2 < 0) return {};
    const DVec3 pd = p.rounded(), ud = u.rounded();
    const auto distance = [&](double s) {
        const DVec3 x = pd + s * ud;
        return std::hypot(std::hypot(x.x, x.z) - 1, x.y) - torus.ratio;
    };
    const double end = std::sqrt(static_cast<double>(half2)) + torus.ratio,
                 least = std::max(1e-7 * torus.ratio, 1e-11);
    QuadRoots roots;
    double at = -end, value = distance(at);
    while (at < end) {
        const double next = at + std::max(std::abs(value), least), there = distance(next);
        if ((there < 0) != (value < 0)) {
            Float128 lo = at, hi = next;
            for (int i = 0; i < 90; ++i) {
                const Float128 middle = (lo + hi) / 2;
                ((torusDistance(torus, p + middle * u) < 0) == (value < 0) ? lo : hi) = middle;
            }
            roots.push_back(lo / length + shift);
        }
        at = next, value = there;
    }
    return roots;
}

/// The shape grown by `e` of its own size in every direction from its middle (a torus: of its tube;
/// a plane: upwards).
template <class Canonical>
QuadRoots grownCrossings(const Canonical& shape, const QuadRay& ray, double e) {
    if constexpr (std::is_same_v<Canonical, CanonicalTorus>)
        return crossings(CanonicalTorus{shape.ratio + e}, ray);
    if constexpr (std::is_same_v<Canonical, CanonicalPlane>)
        return crossings(shape, {ray.o - QuadVec(0, e, 0), ray.d});
    const Float128 s = 1 / (1 + Float128(e));
    return crossings(shape, {s * ray.o, s * ray.d});
}

}  // namespace reference

/// The first crossing in front of a ray that starts elsewhere; `grow` as in grownCrossings().
[[nodiscard]] inline std::optional<Float128> firstReference(const CanonicalShape& shape,
                                                            const QuadRay& ray, double grow = 0) {
    const QuadRoots roots =
        std::visit([&](const auto& s) { return reference::grownCrossings(s, ray, grow); }, shape);
    for (const Float128& t : roots)
        if (t > 0) return t;
    return std::nullopt;
}

/// How far a point is off the surface, over the shape's canonical size; from the field of the face
/// that it was put on.
[[nodiscard]] inline double residual(const CanonicalShape& shape, const QuadVec& p, int face) {
    const Float128 r = squareRoot(p.x * p.x + p.z * p.z);
    const auto off = [&]<class S>(const S& s) -> Float128 {
        if constexpr (std::is_same_v<S, CanonicalSphere>) return squareRoot(dot(p, p)) - 1;
        if constexpr (std::is_same_v<S, CanonicalTorus>) return reference::torusDistance(s, p);
        if constexpr (std::is_same_v<S, CanonicalBox>)
            return absolute(face / 2 == 0 ? p.x : face / 2 == 1 ? p.y : p.z) - 1;
        if constexpr (std::is_same_v<S, CanonicalCylinder>)
            return face == 0 ? r - 1 : absolute(p.y) - 1;
        if constexpr (std::is_same_v<S, CanonicalCone>)
            return face == 0 ? r - (1 - p.y) / 2 : p.y + 1;
        return p.y;
    };
    return static_cast<double>(absolute(std::visit(off, shape)));
}

}  // namespace glint::test
