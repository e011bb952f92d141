// Capped cylinder about y. Canonical form: radius 1, y in [-1,1]. Faces: 0 side, 1 top, 2 bottom.
#pragma once

#include "tracer/base/reflect.h"
#include "tracer/shapes/crossing.h"
#include "tracer/shapes/visible_area.h"

namespace glint {

struct CanonicalCylinder {
    static constexpr bool closed = true, convex = true;

    /// Tube and slab give one span, so side and cap share the value at the rim and no gap can open.
    [[nodiscard]] Span span(const DVec3& o, const DVec3& d) const {
        Span out = tube(o, d);
        if (out.empty()) return {};
        if (d.y != 0) {
            const bool up = d.y > 0;
            const double enter = ((up ? -1.0 : 1.0) - o.y) / d.y,
                         leave = ((up ? 1.0 : -1.0) - o.y) / d.y;
            if (enter > out.t0) out.t0 = enter, out.face0 = up ? 2 : 1;
            if (leave < out.t1) out.t1 = leave, out.face1 = up ? 1 : 2;
        } else if (std::abs(o.y) > 1) {
            return {};
        }
        return out;
    }
    [[nodiscard]] Crossing first(const DVec3& o, const DVec3& d, Start start) const {
        return firstCrossing(*this, o, d, start);
    }
    [[nodiscard]] bool inside(const DVec3& p) const {
        return p.x * p.x + p.z * p.z < 1 && std::abs(p.y) < 1;
    }
    [[nodiscard]] int nearestFace(const DVec3& p) const {
        if (std::hypot(p.x, p.z) >= std::abs(p.y)) return 0;
        return p.y > 0 ? 1 : 2;
    }
    [[nodiscard]] DVec3 project(const DVec3& p, int face) const {
        const double r = std::hypot(p.x, p.z);
        if (face == 0)
            return r > 0 ? DVec3(p.x / r, std::clamp(p.y, -1.0, 1.0), p.z / r) : DVec3(1, p.y, 0);
        const double s = r > 1 ? 1 / r : 1;
        return {p.x * s, face == 1 ? 1.0 : -1.0, p.z * s};
    }
    [[nodiscard]] DVec3 normal(const DVec3& p, int face) const {
        return face == 0 ? DVec3(p.x, 0, p.z) : DVec3(0, face == 1 ? 1 : -1, 0);
    }
    /// Side: u once round the y axis with 1/2 at +z, v from the top down. Caps: of the square
    /// around them.
    [[nodiscard]] DVec2 uv(const DVec3& p, int face) const {
        if (face == 0) return {std::atan2(p.x, p.z) / (2 * kPi) + 0.5, (1 - p.y) / 2};
        return {(p.x + 1) / 2, (1 - p.z) / 2};
    }

    /// From outside: uniform over the area in view, of which every point is reached. From inside:
    /// all directions.
    [[nodiscard]] DirectionSample sampleDirection(const DVec3& o, const DVec2& u) const {
        const Visible visible(o);
        const double total = visible.sideArea + visible.capArea;
        if (!(total > 0)) return {uniformSphere(u), kUniformSpherePdf};
        const double pick = u.x * total;
        if (pick < visible.sideArea) {
            const double phi =
                std::atan2(o.x, o.z) + visible.halfAngle * (2 * pick / visible.sideArea - 1);
            const DVec3 n(std::sin(phi), 0, std::cos(phi));
            return towardsArea(o, {n.x, 2 * u.y - 1, n.z}, n, 1 / total);
        }
        const double up = std::copysign(1.0, o.y);
        const DVec2 q =
            concentricDisk({std::min((pick - visible.sideArea) / visible.capArea, 1.0), u.y});
        return towardsArea(o, {q.x, up, q.y}, {0, up, 0}, 1 / total);
    }
    [[nodiscard]] double pdfDirection(const DVec3& o, const DVec3& d) const {
        const Visible visible(o);
        const double total = visible.sideArea + visible.capArea;
        if (!(total > 0)) return kUniformSpherePdf;
        const Span s = span(o, d);
        if (s.empty()) return 0;
        return areaPdfTowards(d, s.t0, normal(project(o + s.t0 * d, s.face0), s.face0), 1 / total);
    }

  private:
    /// The areas that a point outside can see; both 0 from inside.
    struct Visible {
        explicit Visible(const DVec3& o) {
            const double r = std::hypot(o.x, o.z);
            if (r > 1) halfAngle = std::acos(1 / r), sideArea = 4 * halfAngle;
            if (std::abs(o.y) > 1) capArea = kPi;
        }
        double halfAngle = 0;  ///< of the arc of the side in view
        double sideArea = 0, capArea = 0;
    };

    /// The span inside the endless tube, by the perpendicular discriminant in its cross-section.
    static Span tube(const DVec3& o, const DVec3& d) {
        const double a = d.x * d.x + d.z * d.z, c = o.x * o.x + o.z * o.z - 1;
        // So near to the axis that no distance a double can hold leads across: also keeps a from
        // being denormal.
        constexpr double kParallel = 1e-200;
        if (!(a > kParallel * d.y * d.y)) return c > 0 ? Span{} : Span{-kInfinity, kInfinity};
        const double b = -(o.x * d.x + o.z * d.z), tc = b / a;
        const double fx = o.x + tc * d.x, fz = o.z + tc * d.z;
        const double discriminant = 1 - (fx * fx + fz * fz);
        if (!(discriminant >= 0)) return {};
        const double root = std::copysign(std::sqrt(a * discriminant), b), q = b + root,
                     far = q / a;
        const double near = b * b > a ? c / q : (b - root) / a;  // As in CanonicalSphere.
        return {std::min(near, far), std::max(near, far)};
    }
};

struct Cylinder {
    double radius = 1;
    double height = 2;

    bool operator==(const Cylinder&) const = default;
    static constexpr std::string_view kind = "cylinder";
    static constexpr auto fields() {
        return std::tuple{
            Field{"radius",
                  &Cylinder::radius,
                  {.min = 0, .exclusiveMin = true, .unit = "m", .doc = "Radius"}},
            Field{"height",
                  &Cylinder::height,
                  {.min = 0, .exclusiveMin = true, .unit = "m", .doc = "Length along y"}}};
    }
    [[nodiscard]] DVec3 halfExtents() const { return {radius, height / 2, radius}; }
    [[nodiscard]] CanonicalCylinder canonical() const { return {}; }
};

}  // namespace glint
