// Sphere. Canonical form: unit sphere at the origin.
#pragma once

#include "tracer/base/reflect.h"
#include "tracer/math/warp.h"
#include "tracer/shapes/crossing.h"
#include "tracer/shapes/disk_view.h"

namespace glint {

/// The unit sphere.
struct CanonicalSphere {
    static constexpr bool closed = true, convex = true;
    bool operator==(const CanonicalSphere&) const = default;

    /// Perpendicular discriminant (Haines et al., Ray Tracing Gems, ch. 7). `d` need not have unit
    /// length.
    [[nodiscard]] Span span(const DVec3& o, const DVec3& d) const {
        const double a = glm::dot(d, d), b = -glm::dot(o, d), c = glm::dot(o, o) - 1;
        const DVec3 f = o + (b / a) * d;
        const double discriminant = 1 - glm::dot(f, f);
        if (!(discriminant >= 0)) return {};
        const double root = std::copysign(std::sqrt(a * discriminant), b), q = b + root,
                     far = q / a;
        // c / q keeps the digits of distant balls; within a radius of the line's middle it has none
        // where c and q are both near 0, on the surface along a tangent, and the difference has
        // them all.
        const double near = b * b > a ? c / q : (b - root) / a;
        return near < far ? Span{near, far} : Span{far, near};
    }
    [[nodiscard]] Crossing first(const DVec3& o, const DVec3& d, Start start) const {
        return firstCrossing(*this, o, d, start);
    }
    [[nodiscard]] bool inside(const DVec3& p) const { return glm::dot(p, p) < 1; }
    [[nodiscard]] int nearestFace(const DVec3&) const { return 0; }
    [[nodiscard]] DVec3 project(const DVec3& p, int) const { return p * (1 / glm::length(p)); }
    [[nodiscard]] DVec3 normal(const DVec3& p, int) const { return p; }
    /// Derivative of normal() by p, along the surface.
    [[nodiscard]] DMat3 normalSlope(const DVec3&, int) const { return DMat3(1.0); }
    /// u: once round the y axis, 1/2 at +z and the seam at -z; v: angle from +y over pi.
    [[nodiscard]] DVec2 uv(const DVec3& p, int) const {
        return {std::atan2(p.x, p.z) / (2 * kPi) + 0.5,
                std::acos(std::clamp(p.y, -1.0, 1.0)) / kPi};
    }
    /// From outside: towards the disk that the ball's outline spans, which fills the same
    /// directions, also of an ellipsoid. From inside: all directions.
    [[nodiscard]] DirectionSample sampleDirection(const Viewpoint& view, const DVec2& u) const {
        if (!(glm::dot(view.origin, view.origin) > 1 + kSkin)) {
            const DVec3 d = uniformSphere(u);
            return {d, view.worldDensity(d, kUniformSpherePdf)};
        }
        const Outline outline(view);
        const DiskView::Sample s = outline.disk.sample(u);
        if (!(s.pdf > 0)) return {};
        return {glm::normalize(outline.shapeFromDisk * (s.point - outline.place.origin)), s.pdf};
    }
    [[nodiscard]] double pdfDirection(const Viewpoint& view, const DVec3& d) const {
        if (!(glm::dot(view.origin, view.origin) > 1 + kSkin))
            return view.worldDensity(d, kUniformSpherePdf);
        const Outline outline(view);
        const double cosine = -glm::dot(d, outline.shapeFromDisk[1]);
        if (!(cosine > 0)) return 0;
        const double t = (outline.place.origin.y - outline.height) / cosine;
        const auto across = [&](int axis) {
            return t * glm::dot(d, outline.shapeFromDisk[axis]) / outline.radius2;
        };
        return outline.disk.pdf({across(0), outline.height, across(2)});
    }

  private:
    /// The circle where lines of sight touch the ball, in a space of its own: the unit disk about
    /// the y axis, on which the point lies.
    struct Outline {
        explicit Outline(const Viewpoint& view)
            : distance(glm::length(view.origin)),
              height(1 / distance),
              radius2((distance - 1) * (distance + 1) * height * height),
              shapeFromDisk(axes(view.origin / distance, std::sqrt(radius2))),
              place({0, distance, 0}, view.worldFromLocal * shapeFromDisk),
              disk(place, height) {}
        static DMat3 axes(const DVec3& toPoint, double radius) {
            const Frame frame(toPoint);
            return {radius * frame.s, toPoint, radius * frame.t};
        }
        double distance, height, radius2;
        DMat3 shapeFromDisk;
        Viewpoint place;  ///< the point, as the disk sees it
        DiskView disk;
    };
};

struct Sphere {
    double radius = 1;

    bool operator==(const Sphere&) const = default;
    static constexpr std::string_view kind = "sphere";
    static constexpr auto fields() {
        return std::tuple{Field{"radius",
                                &Sphere::radius,
                                {.min = 0, .exclusiveMin = true, .unit = "m", .doc = "Radius"}}};
    }
    [[nodiscard]] DVec3 halfExtents() const { return DVec3(radius); }
    [[nodiscard]] CanonicalSphere canonical() const { return {}; }
};

}  // namespace glint
