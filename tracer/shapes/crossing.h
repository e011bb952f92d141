// What a ray meets on a shape: spans between crossings, and the one rule by which every shape's
// first hit is chosen.
//
// Every shape is intersected in its canonical space (unit sphere, cube [-1,1]^3, square [-1,1]^2
// ...), in double. A closed shape answers with the span of t inside it. Which end is the hit
// follows from where the ray starts, never from an epsilon: a ray that leaves a convex shape cannot
// meet it again; one that starts inwards can only meet the far end.
#pragma once

#include <algorithm>

#include "tracer/math/types.h"

namespace glint {

/// The part of a line inside a closed convex shape, with the face met at each end. Empty when t0 >
/// t1.
struct Span {
    double t0 = kInfinity, t1 = -kInfinity;
    int face0 = 0, face1 = 0;
    [[nodiscard]] bool empty() const { return !(t0 <= t1); }
};

/// One crossing of a surface at ray parameter t; `t` is infinite when there is none.
struct Crossing {
    double t = kInfinity;
    int face = 0;
    [[nodiscard]] bool found() const { return t < kInfinity; }
};

/// Where a ray starts, as seen from one shape.
enum class Start {
    Elsewhere,    ///< not on this shape, and nothing is known
    Leaving,      ///< on it, going outwards
    Entering,     ///< on it, going inwards
    KnownInside,  ///< the path is tracked to be inside this dielectric
    KnownOutside  ///< the path is tracked to be outside this dielectric
};

/// For a path tracked to be outside the span: it meets the span's beginning, also where rounding
/// has put the origin just past that. Just before the end it has come out of the shape a moment
/// ago: the nearer end is the one that it is at.
[[nodiscard]] inline bool meetsFromOutside(double t0, double t1) { return t1 > 0 && -t0 < t1; }

/// The first hit on a convex closed shape, from shape.span() and shape.nearestFace(). With a
/// tracked start the answer cannot disagree with the tracking: a boundary that rounding has put a
/// hair behind the origin is met at t = 0 instead of being lost, and one that the path has just
/// crossed is not met again, which keeps touching, coincident and nested media right.
template <class Shape>
[[nodiscard]] Crossing firstCrossing(const Shape& shape, const DVec3& o, const DVec3& d,
                                     Start start) {
    if (start == Start::Leaving) return {};
    const Span span = shape.span(o, d);
    switch (start) {
        case Start::Leaving:
            break;
        case Start::Entering:
        case Start::KnownInside:
            return span.empty() ? Crossing{0.0, shape.nearestFace(o)}
                                : Crossing{std::max(span.t1, 0.0), span.face1};
        case Start::KnownOutside:
            if (span.empty() || !meetsFromOutside(span.t0, span.t1)) return {};
            return {std::max(span.t0, 0.0), span.face0};
        case Start::Elsewhere:
            break;
    }
    if (span.empty()) return {};
    if (span.t0 > 0) return {span.t0, span.face0};
    if (span.t1 > 0) return {span.t1, span.face1};
    return {};
}

/// Derivative by p of the unit vector away from the y axis.
[[nodiscard]] inline DMat3 radialSlope(const DVec3& p) {
    DMat3 out(0.0);
    const double r = axisDistance(p);
    if (!(r > 0)) return out;
    const double x = p.x / r, z = p.z / r;
    out[0] = {z * z / r, 0, -x * z / r};
    out[2] = {-x * z / r, 0, x * x / r};
    return out;
}

}  // namespace glint
