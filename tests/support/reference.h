// Reference answers: the textbook solution of every shape, on the very numbers that the tracer is
// given, in quad precision (Float128, 113 bits) or in long double (64 bits), which is some thirty
// times as fast and enough wherever its own rounding decides nothing; hit_check.h tells where that
// is. It shares no formula and no code with tracer/shapes.
#pragma once

#include <array>
#include <cmath>
#include <optional>

#include "tracer/compile/shape_lists.h"

namespace glint::test {

using Float128 = __float128;  // Both compilers have it; its library is not needed.

[[nodiscard]] inline long double squareRoot(long double v) { return v > 0 ? std::sqrt(v) : 0; }
/// By Newton from the double root: full precision after two steps. Negative numbers and NaN give 0.
[[nodiscard]] inline Float128 squareRoot(Float128 v) {
    const double start = std::sqrt(static_cast<double>(v));
    if (!(start > 0) || std::isinf(start)) return 0;
    Float128 root = start;
    for (int i = 0; i < 2; ++i) root = (root + v / root) / 2;
    return root;
}
template <class Real>
[[nodiscard]] Real absolute(Real v) {
    return v < 0 ? -v : v;
}

template <class Real>
struct VecOf {
    Real x = 0, y = 0, z = 0;
    VecOf() = default;
    VecOf(Real a, Real b, Real c) : x(a), y(b), z(c) {}
    explicit VecOf(const DVec3& v) : x(v.x), y(v.y), z(v.z) {}
    friend VecOf operator+(const VecOf& a, const VecOf& b) {
        return {a.x + b.x, a.y + b.y, a.z + b.z};
    }
    friend VecOf operator-(const VecOf& a, const VecOf& b) {
        return {a.x - b.x, a.y - b.y, a.z - b.z};
    }
    friend VecOf operator*(Real s, const VecOf& a) { return {s * a.x, s * a.y, s * a.z}; }
    [[nodiscard]] DVec3 rounded() const {
        return {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
    }
};
template <class Real>
[[nodiscard]] Real dot(const VecOf<Real>& a, const VecOf<Real>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class Real>
[[nodiscard]] VecOf<Real> cross(const VecOf<Real>& a, const VecOf<Real>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// A line in a shape's canonical space; t is that of the ray in render space.
template <class Real>
struct Line {
    VecOf<Real> o, d;
    [[nodiscard]] VecOf<Real> at(Real t) const { return o + t * d; }
};

/// M^-1 v by Cramer's rule, from the double matrix that defines the instance.
template <class Real>
[[nodiscard]] VecOf<Real> solve(const DMat3& m, const VecOf<Real>& v) {
    const VecOf<Real> a(m[0]), b(m[1]), c(m[2]), bc = cross(b, c);
    const Real inverse = 1 / dot(a, bc);
    return {inverse * dot(v, bc), inverse * dot(a, cross(v, c)), inverse * dot(a, cross(b, v))};
}
template <class Real>
[[nodiscard]] VecOf<Real> localPoint(const ShapeInstance& instance, const DVec3& p) {
    return solve(instance.worldFromLocal, VecOf<Real>(p) - VecOf<Real>(instance.center));
}
template <class Real>
[[nodiscard]] Line<Real> localLine(const ShapeInstance& instance, const Ray& ray) {
    return {localPoint<Real>(instance, ray.origin),
            solve(instance.worldFromLocal, VecOf<Real>(ray.direction))};
}

/// Crossings of a line with a surface, in order. Of closed shapes entries and exits take turns.
template <class Real>
struct Crossings {
    std::array<Real, 4> at{};
    std::size_t count = 0;

    Crossings() = default;
    explicit Crossings(Real t) : at{t}, count(1) {}
    Crossings(Real t0, Real t1) : at{t0, t1}, count(2) {}
    void add(Real t) {
        if (count < at.size()) at[count++] = t;
    }
    [[nodiscard]] bool empty() const { return count == 0; }
    [[nodiscard]] std::size_t size() const { return count; }
    [[nodiscard]] Real operator[](std::size_t i) const { return at[i]; }
};

namespace reference {

inline constexpr double kFar = 1e300;

/// Where a t^2 + 2 b t + c <= 0 (a > 0), or nothing.
template <class Real>
Crossings<Real> quadratic(Real a, Real b, Real c) {
    const Real discriminant = b * b - a * c;
    if (discriminant < 0) return {};
    const Real root = squareRoot(discriminant);
    return {(-b - root) / a, (-b + root) / a};
}
/// The part of [roots] where -1 <= o + t d <= 1.
template <class Real>
Crossings<Real> clipped(const Crossings<Real>& roots, Real o, Real d) {
    if (roots.empty()) return {};
    if (d == 0) return absolute(o) <= 1 ? roots : Crossings<Real>{};
    const Real one = (-1 - o) / d, other = (1 - o) / d;
    const Real enter = one < other ? one : other, leave = one < other ? other : one;
    const Crossings<Real> out{enter > roots[0] ? enter : roots[0],
                              leave < roots[1] ? leave : roots[1]};
    return out[0] <= out[1] ? out : Crossings<Real>{};
}

template <class Real>
Crossings<Real> crossings(const CanonicalSphere&, const Line<Real>& r) {
    return quadratic<Real>(dot(r.d, r.d), dot(r.o, r.d), dot(r.o, r.o) - 1);
}
template <class Real>
Crossings<Real> crossings(const CanonicalBox&, const Line<Real>& r) {
    const Crossings<Real> all{-Real(kFar), Real(kFar)};
    return clipped(clipped(clipped(all, r.o.x, r.d.x), r.o.y, r.d.y), r.o.z, r.d.z);
}
template <class Real>
Crossings<Real> crossings(const CanonicalPlane&, const Line<Real>& r) {
    return r.d.y == 0 ? Crossings<Real>{} : Crossings<Real>(-r.o.y / r.d.y);
}
template <class Real>
Crossings<Real> crossings(const CanonicalQuad&, const Line<Real>& r) {
    if (r.d.y == 0) return {};
    const Real t = -r.o.y / r.d.y;
    const VecOf<Real> p = r.at(t);
    return absolute(p.x) <= 1 && absolute(p.z) <= 1 ? Crossings<Real>(t) : Crossings<Real>{};
}
template <class Real>
Crossings<Real> crossings(const CanonicalDisk&, const Line<Real>& r) {
    if (r.d.y == 0) return {};
    const Real t = -r.o.y / r.d.y;
    const VecOf<Real> p = r.at(t);
    return p.x * p.x + p.z * p.z <= 1 ? Crossings<Real>(t) : Crossings<Real>{};
}
template <class Real>
Crossings<Real> crossings(const CanonicalCylinder&, const Line<Real>& r) {
    const Real a = r.d.x * r.d.x + r.d.z * r.d.z, c = r.o.x * r.o.x + r.o.z * r.o.z - 1;
    Crossings<Real> tube;
    if (a > 0)
        tube = quadratic<Real>(a, r.o.x * r.d.x + r.o.z * r.d.z, c);
    else if (c <= 0)
        tube = {-Real(kFar), Real(kFar)};
    return clipped(tube, r.o.y, r.d.y);
}
template <class Real>
Crossings<Real> crossings(const CanonicalCone&, const Line<Real>& r) {
    // Within -1 <= y <= 1 there is one nappe only, so clip first and intersect the two intervals of
    // the double cone.
    const Real far = kFar;
    const Crossings<Real> slab = clipped({-far, far}, r.o.y, r.d.y);
    if (slab.empty()) return {};
    const Real h = r.o.y - 1;
    const Real a = r.d.x * r.d.x + r.d.z * r.d.z - r.d.y * r.d.y / 4,
               b = r.o.x * r.d.x + r.o.z * r.d.z - h * r.d.y / 4,
               c = r.o.x * r.o.x + r.o.z * r.o.z - h * h / 4;
    const auto within = [&](Real lo, Real hi) {
        const Crossings<Real> out{lo > slab[0] ? lo : slab[0], hi < slab[1] ? hi : slab[1]};
        return out[0] <= out[1] ? out : Crossings<Real>{};
    };
    if (a > 0) {
        const Crossings<Real> roots = quadratic<Real>(a, b, c);
        return roots.empty() ? roots : within(roots[0], roots[1]);
    }
    if (a == 0) {
        if (b == 0) return c <= 0 ? slab : Crossings<Real>{};
        return b > 0 ? within(-far, -c / (2 * b)) : within(-c / (2 * b), far);
    }
    const Crossings<Real> roots = quadratic<Real>(-a, -b, -c);  // outside of the cone between these
    if (roots.empty()) return slab;
    const Crossings<Real> before = within(-far, roots[0]), after = within(roots[1], far);
    // The upper nappe's part is cut off by the slab, down to the apex itself.
    return before.empty() || (!after.empty() && after[1] - after[0] > before[1] - before[0])
               ? after
               : before;
}

/// Distance outside of the surface of a torus with that ratio; negative inside.
template <class Real>
Real torusDistance(Real ratio, const VecOf<Real>& p) {
    const Real outwards = squareRoot(p.x * p.x + p.z * p.z) - 1;
    return squareRoot(outwards * outwards + p.y * p.y) - ratio;
}
/// The sign change of f in [lo, hi] by the Illinois method, to the last bits: `atLo`, `atHi` are f
/// there.
template <class Real, class Function>
Real signChange(const Function& f, Real lo, Real hi, Real atLo, Real atHi) {
    Real last = hi;
    for (int i = 0; i < 200; ++i) {
        Real x = hi - atHi * (hi - lo) / (atHi - atLo);
        if (!(x > lo && x < hi)) x = (lo + hi) / 2;
        if (!(x > lo && x < hi) || x == last) break;
        last = x;
        const Real value = f(x);
        if ((value < 0) == (atLo < 0)) {
            lo = x, atLo = value, atHi = atHi / 2;
        } else {
            hi = x, atHi = value, atLo = atLo / 2;
        }
    }
    return last;
}
/// Walks along the line by the distance to the surface, which it cannot overstep; between crossings
/// nearer than that (1e-7 of the tube, and above the noise of double) it may see none.
template <class Real>
Crossings<Real> torusCrossings(Real ratio, const Line<Real>& r) {
    const Real length = squareRoot(dot(r.d, r.d)), shift = -dot(r.o, r.d) / (length * length);
    const VecOf<Real> p = r.at(shift), u = (1 / length) * r.d;
    const Real reach = 1 + ratio, half2 = reach * reach - dot(p, p);
    if (half2 < 0) return {};
    const DVec3 pd = p.rounded(), ud = u.rounded();
    const auto tube = static_cast<double>(ratio);
    const auto roughly = [&](double s) {
        const DVec3 x = pd + s * ud;
        const double outwards = std::sqrt(x.x * x.x + x.z * x.z) - 1;
        return std::sqrt(outwards * outwards + x.y * x.y) - tube;
    };
    const auto exactly = [&](Real s) { return torusDistance(ratio, p + s * u); };
    const double end = std::sqrt(static_cast<double>(half2)) + tube,
                 least = std::max(1e-7 * tube, 1e-11);
    Crossings<Real> roots;
    double at = -end, value = roughly(at);
    while (at < end) {
        const double next = at + std::max(std::abs(value), least), there = roughly(next);
        if ((there < 0) != (value < 0)) {
            const Real lo = exactly(at), hi = exactly(next);
            // Where double and Real disagree on the sign, the crossing is at that end up to the
            // noise of double.
            const bool noisy = (lo < 0) == (hi < 0);
            const Real s = noisy ? Real(absolute(lo) < absolute(hi) ? at : next)
                                 : signChange<Real>(exactly, at, next, lo, hi);
            roots.add(s / length + shift);
        }
        at = next, value = there;
    }
    return roots;
}

template <class Real>
Crossings<Real> crossings(const CanonicalTorus& torus, const Line<Real>& line) {
    return torusCrossings(Real(torus.ratio), line);
}

/// The shape grown by `e` of its own size in every direction from its middle (a torus: of its tube;
/// a plane: upwards).
template <class Canonical, class Real>
Crossings<Real> grownCrossings(const Canonical& shape, const Line<Real>& line, double e) {
    if constexpr (std::is_same_v<Canonical, CanonicalTorus>) {
        return torusCrossings(Real(shape.ratio) + Real(e), line);
    } else if constexpr (std::is_same_v<Canonical, CanonicalPlane>) {
        return crossings(shape, Line<Real>{line.o - VecOf<Real>(0, e, 0), line.d});
    } else {
        const Real s = 1 / (1 + Real(e));
        return crossings(shape, Line<Real>{s * line.o, s * line.d});
    }
}

}  // namespace reference

/// The first crossing in front of a ray that starts elsewhere; `grow` as in grownCrossings(). The
/// line is taken about its point nearest to the shape's middle, where its coefficients are small.
template <class Real>
[[nodiscard]] std::optional<Real> firstReference(const CanonicalShape& shape,
                                                 const Line<Real>& line, double grow = 0) {
    const Real shift = -dot(line.o, line.d) / dot(line.d, line.d);
    const Line<Real> near{line.at(shift), line.d};
    const Crossings<Real> found =
        std::visit([&](const auto& s) { return reference::grownCrossings(s, near, grow); }, shape);
    for (std::size_t i = 0; i < found.size(); ++i)
        if (const Real t = found[i] + shift; t > 0) return t;
    return std::nullopt;
}

/// How far a point is off the surface, over the shape's canonical size; from the field of the face
/// that it was put on.
template <class Real>
[[nodiscard]] double residual(const CanonicalShape& shape, const VecOf<Real>& p, int face) {
    const Real r = squareRoot(p.x * p.x + p.z * p.z);
    const auto off = [&]<class S>(const S& s) -> Real {
        if constexpr (std::is_same_v<S, CanonicalSphere>) return squareRoot(dot(p, p)) - 1;
        if constexpr (std::is_same_v<S, CanonicalTorus>)
            return reference::torusDistance(Real(s.ratio), p);
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
