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

/// Solved by the depth (r - 1)^2 + y^2 - ratio^2 along the ray, whose two bends are known: on
/// every side of them Newton's method surely finds its zeros (Fourier's conditions). That form
/// loses no digits in thin tubes and leaves out the inner sheet of a spindle: the torus's quartic
/// is it times (r + 1)^2 + y^2 - ratio^2, which vanishes only within.
struct CanonicalTorus {
    static constexpr bool closed = true, convex = false;
    bool operator==(const CanonicalTorus&) const = default;
    double ratio = 0.25;

    [[nodiscard]] Crossing first(const DVec3& o, const DVec3& d, Start start) const {
        if ((start == Start::Elsewhere || start == Start::KnownOutside) && passes(o, d)) return {};
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
        const double r = axisDistance(p) - 1;
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
                std::atan2(p.y, axisDistance(p) - 1) / (2 * kPi) + 0.5};
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
            sum += hits[i] * hits[i] / (cosine * axisDistance(p));
        }
        return view.worldDensity(d, sum / (4 * kPi * ratio * tubeHalfAngle()));
    }

  private:
    static DVec3 ring(const DVec3& p) {
        const double r = axisDistance(p);
        return r > 0 ? DVec3(p.x / r, 0, p.z / r) : DVec3(1, 0, 0);
    }
    /// The surface goes round the tube from minus to plus this angle; all the way unless the tube
    /// meets itself.
    [[nodiscard]] double tubeHalfAngle() const { return ratio > 1 ? std::acos(-1 / ratio) : kPi; }

    /// The piece of a line within the ball and the slab about the torus, as places `s` from its
    /// point of closest approach to the centre; none where hi <= lo. Both ends are outside,
    /// whatever rounding makes of the depth there.
    struct Chord {
        DVec3 p, unit;
        double ratio, shift, lo = 0, hi = 0;
        double resolution = 0;  ///< finer steps drown in the rounding of places

        Chord(const DVec3& o, const DVec3& direction, double tube)
            : unit(direction), ratio(tube), shift(-glm::dot(o, unit)) {
            p = o + shift * unit;
            const double reach = 1 + ratio, hole = std::max(0.0, 1 - ratio),
                         half2 = reach * reach - glm::dot(p, p);
            if (!(half2 > 0)) return;
            const double half = std::sqrt(half2), rising = std::copysign(ratio, unit.y);
            // A level line divides by 0: infinite bounds hold, and NaN is passed over.
            lo = std::max(-half, (-rising - p.y) / unit.y);
            hi = std::min(half, (rising - p.y) / unit.y);
            resolution = 0x1p-52 * reach;
            // Through the hole, as the distance from the axis is greatest at an end.
            if (lo < hi && std::max(radius2(lo), radius2(hi)) < hole * hole) hi = lo;
        }
        /// Squared distance from the axis.
        [[nodiscard]] double radius2(double s) const {
            const double x = p.x + s * unit.x, z = p.z + s * unit.z;
            return x * x + z * z;
        }
        /// The ends of the pieces on which the depth curves upwards, downwards, and upwards again.
        /// Its second derivative is 2 - 2 c^2 / r^3, where c is the line's moment about the axis.
        [[nodiscard]] std::array<double, 3> pieces() const {
            const double c = p.x * unit.z - p.z * unit.x, c2 = c * c,
                         w = unit.x * unit.x + unit.z * unit.z;
            if (!(c2 < w * w * w)) return {hi, hi, hi};
            // Within kBlur roundings of the axis the direction from it is noise, and so the slope;
            // the ridge of the depth there is taken to be as wide.
            constexpr double kBlur = 1024;
            const double axis = -(p.x * unit.x + p.z * unit.z) / w, r = std::cbrt(c2),
                         away = std::max(kBlur * resolution, std::sqrt((r * r - c2 / w) / w));
            return {std::min(axis - away, hi), std::min(axis + away, hi), hi};
        }
        [[nodiscard]] ValueAndSlope depth(double s) const {
            const DVec3 x = p + s * unit;
            const double r = std::sqrt(x.x * x.x + x.z * x.z), outwards = r - 1,
                         turn = r > 0 ? (x.x * unit.x + x.z * unit.z) / r : 0;
            return {outwards * outwards + x.y * x.y - ratio * ratio,
                    2 * (outwards * turn + x.y * unit.y)};
        }
        /// The crossing at or after `s` on a piece that ends at `end` and curves away from 0;
        /// infinite if there is none. Newton's steps cannot pass it: the tangent meets 0 before the
        /// depth does.
        [[nodiscard]] double approach(double s, double end, bool upwards) const {
            while (s <= end) {
                const ValueAndSlope at = depth(s);
                if (!(upwards ? at.slope < 0 : at.slope > 0)) break;
                if (!(upwards ? at.value > 0 : at.value < 0)) return s;
                const double step = -at.value / at.slope;
                s += step;
                // The second derivative is 2 at most, and the error left step^2 / |slope|.
                if (step <= resolution || (upwards && step * step <= resolution * -at.slope))
                    return s;
            }
            return kInfinity;
        }
        /// found(crossing) for each from `s` on in turn, until that answers true; `inside`: at s.
        template <class Found>
        void walk(double s, bool inside, const Found& found) const {
            if (!(s < hi)) return;
            const std::array<double, 3> ends = pieces();
            for (std::size_t piece = 0; piece < 3; ++piece) {
                const double end = ends[piece];
                if (!(s < end)) continue;
                const bool upwards = piece != 1;
                if (inside != upwards)
                    if (const double x = approach(s, end, upwards); x <= end) {
                        if (found(x)) return;
                        s = x, inside = !inside;
                    }
                // Where it curves towards 0 there is one crossing at most, and the end tells.
                if (inside == upwards && (end < hi && depth(end).value < 0) != inside) {
                    const auto f = [this](double x) { return depth(x); };
                    if (found(refineRoot(f, s, end, inside, end, resolution))) return;
                    inside = !inside;
                }
                s = end;
            }
        }
    };
    /// All crossings of the line, entries and exits in turn, as distances from `o`: error below
    /// 1e-11 out to 1e4 major radii (tests/numeric/torus_test.cpp).
    [[nodiscard]] Roots<4> crossings(const DVec3& o, const DVec3& unit) const {
        const Chord chord(o, unit, ratio);
        Roots<4> roots;
        chord.walk(chord.lo, false, [&](double s) { return roots.add(s + chord.shift), false; });
        return roots;
    }
    /// The first of them in front of `o`; infinite if there is none.
    [[nodiscard]] double firstAhead(const DVec3& o, const DVec3& unit) const {
        const Chord chord(o, unit, ratio);
        const double start = -chord.shift;
        bool inside = false;
        if (start > chord.lo) {
            const ValueAndSlope at = chord.depth(start);
            inside = at.value < 0 || (at.value == 0 && at.slope < 0);
        }
        double first = kInfinity;
        chord.walk(std::max(chord.lo, start), inside, [&](double s) {
            if (s > start) first = s;
            return s > start;
        });
        return first + chord.shift;
    }
    /// Whether the ray misses the ball about the torus. Without roots or divisions.
    [[nodiscard]] bool passes(const DVec3& o, const DVec3& d) const {
        const DVec3 moment = glm::cross(o, d);
        const double reach2 = (1 + ratio) * (1 + ratio);
        return glm::dot(moment, moment) > reach2 * glm::dot(d, d) ||
               (glm::dot(o, d) > 0 && glm::dot(o, o) > reach2);
    }

    /// The next crossing of a ray that starts on the surface: the line's root at 0 is divided out,
    /// so it can be neither met again nor taken for another.
    [[nodiscard]] Crossing fromSurface(const DVec3& o, const DVec3& unit, bool entering) const {
        const double beta = glm::dot(o, unit), gamma = o.x * unit.x + o.z * unit.z,
                     w = unit.x * unit.x + unit.z * unit.z;
        const double m = glm::dot(o, o), k = m + 1 - ratio * ratio, r0 = axisDistance(o),
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
            quadraticRoots({4 * beta * beta + 2 * k - 4 * w, 8 * beta, 3.0}, 0.0, end);
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
