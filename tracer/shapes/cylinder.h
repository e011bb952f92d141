// Capped cylinder about y. Canonical form: radius 1, y in [-1,1]. Faces: 0 side, 1 top, 2 bottom.
#pragma once

#include "tracer/base/reflect.h"
#include "tracer/shapes/crossing.h"
#include "tracer/shapes/round_view.h"

namespace glint {

struct CanonicalCylinder {
    static constexpr bool closed = true, convex = true;
    bool operator==(const CanonicalCylinder&) const = default;

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
        if (axisDistance(p) >= std::abs(p.y)) return 0;
        return p.y > 0 ? 1 : 2;
    }
    [[nodiscard]] DVec3 project(const DVec3& p, int face) const {
        const double r = axisDistance(p);
        if (face == 0)
            return r > 0 ? DVec3(p.x / r, std::clamp(p.y, -1.0, 1.0), p.z / r) : DVec3(1, p.y, 0);
        const double s = r > 1 ? 1 / r : 1;
        return {p.x * s, face == 1 ? 1.0 : -1.0, p.z * s};
    }
    [[nodiscard]] DVec3 normal(const DVec3& p, int face) const {
        return face == 0 ? DVec3(p.x, 0, p.z) : DVec3(0, face == 1 ? 1 : -1, 0);
    }
    /// Derivative of normal() by p, along the surface.
    [[nodiscard]] DMat3 normalSlope(const DVec3&, int face) const {
        DMat3 out(0.0);
        if (face == 0) out[0][0] = out[2][2] = 1;
        return out;
    }
    /// Side: u once round the y axis with 1/2 at +z, v from the top down. Caps: of the square
    /// around them.
    [[nodiscard]] DVec2 uv(const DVec3& p, int face) const {
        if (face == 0) return {std::atan2(p.x, p.z) / (2 * kPi) + 0.5, (1 - p.y) / 2};
        return {(p.x + 1) / 2, (1 - p.z) / 2};
    }

    /// From outside: the side, even in the angle about the axis and in the sine of the elevation
    /// over it, and the cap in view. From inside: all directions.
    [[nodiscard]] DirectionSample sampleDirection(const Viewpoint& view, const DVec2& u) const {
        return look(view).sample(u);
    }
    [[nodiscard]] double pdfDirection(const Viewpoint& view, const DVec3& d) const {
        return look(view).pdf(*this, span(view.origin, d), d);
    }

  private:
    /// The straight lines of the side, along the axis.
    struct Side {
        const Viewpoint& view;
        double axisLength;  ///< of half the cylinder, in the world

        [[nodiscard]] SolidStrip strip(const MantleView::Generator& line) const {
            const DVec3 middle = view.toWorld({line.sine, 0, line.cosine});
            const double z = glm::dot(middle, view.worldFromLocal[1]) / axisLength;
            return {glm::dot(line.point, line.point), z - axisLength, z + axisLength};
        }
        [[nodiscard]] double width(const MantleView::Generator& line) const {
            return strip(line).sines();
        }
        [[nodiscard]] DVec3 place(const MantleView::Generator& line, double u) const {
            const SolidStrip s = strip(line);
            const double y = 2 * (s.sample(u) - s.z0) / (s.z1 - s.z0) - 1;
            return {line.sine, std::clamp(y, -1.0, 1.0), line.cosine};
        }
    };
    static RoundView<Side> look(const Viewpoint& view) {
        const Side side{view, glm::length(view.worldFromLocal[1])};
        const double r = axisDistance(view.origin);
        std::optional<MantleView> mantle;
        if (r > 1 + kSkin)
            mantle.emplace(view.worldFromLocal[1] / side.axisLength, view.toWorld(DVec3(0.0)), view,
                           std::atan(std::sqrt((r - 1) * (r + 1))));
        std::optional<DiskView> cap;
        if (std::abs(view.origin.y) > 1 + kSkin)
            cap.emplace(view, std::copysign(1.0, view.origin.y));
        return {view, side, mantle, cap};
    }

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
