// Capped cone about y, apex up. Canonical form: apex (0,1,0), base y = -1 with radius 1. Faces: 0
// side, 1 base.
#pragma once

#include "tracer/base/reflect.h"
#include "tracer/shapes/crossing.h"
#include "tracer/shapes/round_view.h"

namespace glint {

struct CanonicalCone {
    static constexpr bool closed = true, convex = true;
    bool operator==(const CanonicalCone&) const = default;

    [[nodiscard]] Span span(const DVec3& o, const DVec3& d) const {
        Span out = nappe(o, d);
        if (out.empty()) return {};
        if (d.y != 0) {
            const bool up = d.y > 0;
            const double base = (-1.0 - o.y) / d.y;
            if (up && base > out.t0) out.t0 = base, out.face0 = 1;
            if (!up && base < out.t1) out.t1 = base, out.face1 = 1;
        } else if (o.y < -1) {
            return {};
        }
        return out;
    }
    [[nodiscard]] Crossing first(const DVec3& o, const DVec3& d, Start start) const {
        return firstCrossing(*this, o, d, start);
    }
    [[nodiscard]] bool inside(const DVec3& p) const {
        const double r = (1 - p.y) / 2;
        return p.y > -1 && p.y < 1 && p.x * p.x + p.z * p.z < r * r;
    }
    [[nodiscard]] int nearestFace(const DVec3& p) const {
        const double toSide = std::abs(axisDistance(p) - (1 - p.y) / 2) * kMantleCosine;
        return std::abs(p.y + 1) < toSide ? 1 : 0;
    }
    [[nodiscard]] DVec3 project(const DVec3& p, int face) const {
        const double r = axisDistance(p);
        if (face == 1) return r > 1 ? DVec3(p.x / r, -1, p.z / r) : DVec3(p.x, -1, p.z);
        const double y = std::clamp(p.y, -1.0, 1.0), s = r > 0 ? (1 - y) / 2 / r : 0;
        return {p.x * s, y, p.z * s};
    }
    [[nodiscard]] DVec3 normal(const DVec3& p, int face) const {
        if (face == 1) return {0, -1, 0};
        const double r = axisDistance(p);
        return r > 0 ? DVec3(p.x / r, 0.5, p.z / r) : DVec3(0, 1, 0);
    }
    /// Derivative of normal() by p, along the surface.
    [[nodiscard]] DMat3 normalSlope(const DVec3& p, int face) const {
        return face == 0 ? radialSlope(p) : DMat3(0.0);
    }
    /// Side: u once round the y axis with 1/2 at +z, v from the apex down. Base: of the square
    /// around it.
    [[nodiscard]] DVec2 uv(const DVec3& p, int face) const {
        if (face == 0) return {std::atan2(p.x, p.z) / (2 * kPi) + 0.5, (1 - p.y) / 2};
        return {(p.x + 1) / 2, (1 - p.z) / 2};
    }

    /// From outside: the mantle, even in the angle about the line to the apex and in the cosine of
    /// the angle off it, and the base where it is in view. From inside: all directions.
    [[nodiscard]] DirectionSample sampleDirection(const Viewpoint& view, const DVec2& u) const {
        return look(view).sample(u);
    }
    [[nodiscard]] double pdfDirection(const Viewpoint& view, const DVec3& d) const {
        return look(view).pdf(*this, span(view.origin, d), d);
    }

  private:
    /// Of the angle between the mantle's normal and the horizontal: 2 / sqrt(5).
    static constexpr double kMantleCosine = 2 * 0.44721359549995793928;

    /// The straight lines of the mantle, from the apex to the base.
    struct Side {
        const Viewpoint& view;
        DVec3 toApex;  ///< unit, in the world
        double apexDistance;

        /// A line's components off the line to the apex and along it, and sin^2 of half the angle
        /// between apex and base.
        struct Wedge {
            double across, along, sine2;
        };
        [[nodiscard]] Wedge wedge(const MantleView::Generator& line) const {
            const DVec3 down = view.worldFromLocal * DVec3(line.sine, -2, line.cosine);
            const double across = glm::length(line.point), along = glm::dot(down, toApex);
            const double sine = std::sin(std::atan2(across, apexDistance + along) / 2);
            return {across, along, sine * sine};
        }
        [[nodiscard]] double width(const MantleView::Generator& line) const {
            return 2 * wedge(line).sine2;
        }
        [[nodiscard]] DVec3 place(const MantleView::Generator& line, double u) const {
            const Wedge w = wedge(line);
            const double sine2 = u * w.sine2, cosine = 1 - 2 * sine2,
                         sine = 2 * std::sqrt(sine2 * (1 - sine2));
            const double s = apexDistance * sine / (w.across * cosine - w.along * sine);
            const double down = s >= 0 && s <= 1 ? s : 1;
            return {down * line.sine, 1 - 2 * down, down * line.cosine};
        }
    };
    static RoundView<Side> look(const Viewpoint& view) {
        const DVec3 toApex = view.toWorld({0, 1, 0});
        const double distance = glm::length(toApex);
        const double r = axisDistance(view.origin), aboveApex = view.origin.y - 1;
        // A line of the mantle at the angle phi from the point's own is in view if r cos(phi) +
        // aboveApex / 2 > 0.
        std::optional<MantleView> mantle;
        if (r > kSkin - aboveApex / 2 && distance > 0)
            mantle.emplace(toApex / distance, -2.0 * view.worldFromLocal[1], view,
                           r > aboveApex / 2 ? std::acos(-aboveApex / (2 * r)) : kPi);
        std::optional<DiskView> base;
        if (view.origin.y < -1 - kSkin) base.emplace(view, -1.0);
        return {view, Side{view, toApex / distance, distance}, mantle, base};
    }

    /// The span inside the lower nappe x^2 + z^2 <= ((1-y)/2)^2, y <= 1, solved about the point of
    /// the line closest to the apex, where the coefficients are small.
    static Span nappe(const DVec3& o, const DVec3& d) {
        const DVec3 fromApex = o - DVec3(0, 1, 0);
        const double shift = -glm::dot(fromApex, d) / glm::dot(d, d);
        const DVec3 p = fromApex + shift * d;
        const double a = d.x * d.x + d.z * d.z - 0.25 * d.y * d.y;
        const double b = p.x * d.x + p.z * d.z - 0.25 * p.y * d.y;
        const double c = p.x * p.x + p.z * p.z - 0.25 * p.y * p.y;
        if (a == 0) {  // Parallel to a line of the mantle: one crossing.
            if (b == 0) return {};
            const double t = -c / (2 * b);
            const Span half = b > 0 ? Span{-kInfinity, t} : Span{t, kInfinity};
            return p.y + t * d.y <= 0 ? Span{half.t0 + shift, half.t1 + shift} : Span{};
        }
        const double ac = a * c,
                     discriminant = std::fma(b, b, -ac) + std::fma(-a, c, ac);  // Kahan: b*b - a*c
        if (discriminant < 0 && a > 0) return {};
        const double root = std::sqrt(std::max(0.0, discriminant));
        const double q = -(b + std::copysign(root, b));
        double t0 = q / a, t1 = q == 0 ? t0 : c / q;
        if (t0 > t1) std::swap(t0, t1);
        if (a > 0) return p.y + 0.5 * (t0 + t1) * d.y <= 0 ? Span{t0 + shift, t1 + shift} : Span{};
        return d.y < 0 ? Span{t1 + shift, kInfinity} : Span{-kInfinity, t0 + shift};
    }
};

struct Cone {
    double radius = 1;
    double height = 2;

    bool operator==(const Cone&) const = default;
    static constexpr std::string_view kind = "cone";
    static constexpr auto fields() {
        return std::tuple{
            Field{"radius",
                  &Cone::radius,
                  {.min = 0, .exclusiveMin = true, .unit = "m", .doc = "Radius of the base"}},
            Field{"height",
                  &Cone::height,
                  {.min = 0, .exclusiveMin = true, .unit = "m", .doc = "Length along y"}}};
    }
    [[nodiscard]] DVec3 halfExtents() const { return {radius, height / 2, radius}; }
    [[nodiscard]] CanonicalCone canonical() const { return {}; }
};

}  // namespace glint
