// Torus about y. Canonical form: major radius 1, minor radius `ratio`. From ratio 1 on the tube
// meets itself (a spindle torus); the solid is then the union, and its surface the outer one (the
// "apple"): what lies within has no surface.
#pragma once

#include "tracer/base/reflect.h"
#include "tracer/math/polynomial.h"
#include "tracer/math/warp.h"
#include "tracer/shapes/crossing.h"
#include "tracer/shapes/viewpoint.h"

namespace glint {

/// Solved by its quartic's critical points and the sign of the depth (r - 1)^2 + y^2 - ratio^2
/// between them. That form loses no digits in thin tubes and leaves out the inner sheet of a
/// spindle: the quartic is (r - 1)^2 + y^2 - ratio^2 times (r + 1)^2 + y^2 - ratio^2, and the
/// second factor vanishes only within.
struct CanonicalTorus {
    static constexpr bool closed = true, convex = false;
    double ratio = 0.25;

    [[nodiscard]] Crossing first(const DVec3& o, const DVec3& d, Start start) const {
        const double length = glm::length(d);
        if (start == Start::Leaving || start == Start::Entering) {
            Crossing hit = fromSurface(o, d / length, start == Start::Entering);
            hit.t /= length;
            return hit;
        }
        if (start == Start::Elsewhere) return {firstAhead(o, d / length) / length};
        return select(crossings(o, d / length), length, start);
    }
    [[nodiscard]] bool inside(const DVec3& p) const {
        const double r = std::hypot(p.x, p.z) - 1;
        return r * r + p.y * p.y < ratio * ratio;
    }
    [[nodiscard]] DVec3 project(const DVec3& p, int) const {
        const DVec3 c = ring(p), out = p - c;
        const double length = glm::length(out);
        return length > 0 ? c + out * (ratio / length) : p;
    }
    [[nodiscard]] DVec3 normal(const DVec3& p, int) const { return p - ring(p); }
    /// Derivative of normal() by p, along the surface.
    [[nodiscard]] DMat3 normalSlope(const DVec3& p, int) const {
        return DMat3(1.0) - radialSlope(p);
    }
    /// u: once round the y axis, 1/2 at +z; v: round the tube, 1/2 outermost and rising upwards.
    [[nodiscard]] DVec2 uv(const DVec3& p, int) const {
        return {std::atan2(p.x, p.z) / (2 * kPi) + 0.5,
                std::atan2(p.y, std::hypot(p.x, p.z) - 1) / (2 * kPi) + 0.5};
    }

    /// Towards a point of the surface, uniform in both angles. Every direction drawn reaches the
    /// torus, first at that point or at another; its density counts all of them.
    [[nodiscard]] DirectionSample sampleDirection(const Viewpoint& view, const DVec2& u) const {
        const double phi = 2 * kPi * u.x, theta = tubeHalfAngle() * (2 * u.y - 1),
                     r = 1 + ratio * std::cos(theta);
        const DVec3 to =
            DVec3(r * std::sin(phi), ratio * std::sin(theta), r * std::cos(phi)) - view.origin;
        const double distance = glm::length(to);
        if (!(distance > 0)) return {};
        return {to / distance, pdfDirection(view, to / distance)};
    }
    [[nodiscard]] double pdfDirection(const Viewpoint& view, const DVec3& d) const {
        const DVec3& o = view.origin;
        const Roots<4> hits = crossings(o, d);
        double sum = 0;
        for (int i = 0; i < hits.count; ++i) {
            if (!(hits[i] > 0)) continue;
            const DVec3 p = project(o + hits[i] * d, 0);
            const double cosine = std::abs(glm::dot(d, normal(p, 0))) / ratio;
            sum += hits[i] * hits[i] / (cosine * std::hypot(p.x, p.z));
        }
        return view.worldDensity(d, sum / (4 * kPi * ratio * tubeHalfAngle()));
    }

  private:
    static DVec3 ring(const DVec3& p) {
        const double r = std::hypot(p.x, p.z);
        return r > 0 ? DVec3(p.x / r, 0, p.z / r) : DVec3(1, 0, 0);
    }
    /// The surface goes round the tube from minus to plus this angle; all the way unless the tube
    /// meets itself.
    [[nodiscard]] double tubeHalfAngle() const { return ratio > 1 ? std::acos(-1 / ratio) : kPi; }

    /// Depth and its slope along a line, `s` after `p`.
    [[nodiscard]] ValueAndSlope depth(const DVec3& p, const DVec3& unit, double s) const {
        const DVec3 x = p + s * unit;
        const double r = std::sqrt(x.x * x.x + x.z * x.z), outwards = r - 1;
        return {outwards * outwards + x.y * x.y - ratio * ratio,
                2 * (outwards * (x.x * unit.x + x.z * unit.z) / r + x.y * unit.y)};
    }

    /// All crossings of the line, entries and exits in turn, as distances from `o`. The quartic is
    /// taken about the point of closest approach to the centre, where its coefficients are small:
    /// error below 1e-11 out to 1e4 major radii (tests/numeric/torus_test.cpp).
    [[nodiscard]] Roots<4> crossings(const DVec3& o, const DVec3& unit) const {
        const Chord chord(o, unit, ratio);
        if (!(chord.half > 0)) return {};
        Roots<4> roots = signChanges<4>(chord.critical, -chord.half, chord.half,
                                        [&](double s) { return depth(chord.p, unit, s); });
        for (int i = 0; i < roots.count; ++i) roots.at[static_cast<std::size_t>(i)] += chord.shift;
        return roots;
    }
    /// The first of them in front of `o`; infinite if there is none.
    [[nodiscard]] double firstAhead(const DVec3& o, const DVec3& unit) const {
        const Chord chord(o, unit, ratio);
        if (!(chord.half > 0)) return kInfinity;
        return chord.shift + firstSignChange<4>(chord.critical, -chord.half, chord.half, -chord.shift,
                                                [&](double s) { return depth(chord.p, unit, s); });
    }
    /// The piece of a line that can meet the torus, about its point of closest approach to the
    /// centre, and where the depth along it may turn.
    struct Chord {
        double shift, half = 0;
        DVec3 p;
        Roots<3> critical;

        Chord(const DVec3& o, const DVec3& unit, double ratio)
            : shift(-glm::dot(o, unit)), p(o + shift * unit) {
            const double reach = 1 + ratio, m = glm::dot(p, p), half2 = reach * reach - m;
            if (!(half2 > 0)) return;
            // The ends lie beyond the bounding sphere and so outside, whatever rounding does.
            half = std::sqrt(half2) + ratio;
            if (shift + half < 0) half = 0;  // Behind the ray's start.
            if (half == 0) return;
            const double k = m + 1 - ratio * ratio, w = unit.x * unit.x + unit.z * unit.z;
            critical = findRoots<3>(
                {-8 * (p.x * unit.x + p.z * unit.z), 4 * k - 8 * w, 0.0, 4.0}, -half, half);
        }
    };

    /// The next crossing of a ray that starts on the surface: the line's root at 0 is divided out,
    /// so it can be neither met again nor taken for another.
    [[nodiscard]] Crossing fromSurface(const DVec3& o, const DVec3& unit, bool entering) const {
        const double beta = glm::dot(o, unit), gamma = o.x * unit.x + o.z * unit.z,
                     w = unit.x * unit.x + unit.z * unit.z;
        const double m = glm::dot(o, o), k = m + 1 - ratio * ratio, r0 = std::hypot(o.x, o.z),
                     reach = 1 + ratio;
        const double end =
            std::sqrt(std::max(0.0, beta * beta - (m - reach * reach))) - beta + ratio;
        // (depth(t) - depth(0)) / t, free of cancellation. At 0 its sign is what `entering` says.
        const auto quotient = [&](double t) -> ValueAndSlope {
            if (t == 0) return {entering ? -1.0 : 1.0, 0};
            const DVec3 x = o + t * unit;
            const double r = std::sqrt(x.x * x.x + x.z * x.z), sum = r + r0;
            if (!(r > 0))
                return {2 * (o.y * unit.y + gamma) + t, 1};  // the axis, which a spindle reaches
            const double growth = 2 * gamma + w * t;         // (r^2 - r0^2) / t
            return {2 * (o.y * unit.y + gamma * ((r - 1) + (r0 - 1)) / sum) + t * (1 - 2 * w / sum),
                    1 - 2 * w / sum + 2 * growth * (gamma + w * t) / (r * sum * sum)};
        };
        const auto critical =
            findRoots<2>({4 * beta * beta + 2 * k - 4 * w, 8 * beta, 3.0}, 0.0, end);
        const Roots<3> roots = signChanges<3>(critical, 0.0, end, quotient);
        if (roots.count > 0) return {roots[0]};
        return entering ? Crossing{0.0} : Crossing{};
    }

    /// The first hit among the crossings. What is tracked decides between neighbours, as in
    /// firstCrossing().
    static Crossing select(const Roots<4>& hits, double length, Start start) {
        const auto hit = [length](double distance) {
            return Crossing{std::max(distance, 0.0) / length};
        };
        switch (start) {
            case Start::KnownInside: {
                double best = kInfinity, exit = 0;
                for (int i = 0; i + 1 < hits.count; i += 2)
                    if (const double away = std::max(hits[i], -hits[i + 1]); away < best)
                        best = away, exit = hits[i + 1];
                return hit(exit);
            }
            case Start::KnownOutside:
                for (int i = 0; i + 1 < hits.count; i += 2)
                    if (meetsFromOutside(hits[i], hits[i + 1])) return hit(hits[i]);
                return {};
            default:
                for (int i = 0; i < hits.count; ++i)
                    if (hits[i] > 0) return hit(hits[i]);
                return {};
        }
    }
};

struct Torus {
    double majorRadius = 1;
    double minorRadius = 0.25;

    bool operator==(const Torus&) const = default;
    static constexpr std::string_view kind = "torus";
    static constexpr auto fields() {
        return std::tuple{
            Field{"major_radius",
                  &Torus::majorRadius,
                  {.min = 0,
                   .exclusiveMin = true,
                   .unit = "m",
                   .doc = "From the centre to the middle of the tube"}},
            Field{
                "minor_radius",
                &Torus::minorRadius,
                {.min = 0,
                 .exclusiveMin = true,
                 .unit = "m",
                 .doc = "Radius of the tube; from the major radius on, the tube closes the hole"}}};
    }
    [[nodiscard]] DVec3 halfExtents() const { return DVec3(majorRadius); }
    [[nodiscard]] CanonicalTorus canonical() const { return {minorRadius / majorRadius}; }
};

}  // namespace glint
