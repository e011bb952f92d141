// Infinite plane y = 0 with normal +y. As a dielectric it fills the half-space below.
#pragma once

#include "tracer/base/reflect.h"
#include "tracer/math/warp.h"
#include "tracer/shapes/crossing.h"
#include "tracer/shapes/viewpoint.h"

namespace glint {

struct CanonicalPlane {
    static constexpr bool closed = true, convex = true;
    bool operator==(const CanonicalPlane&) const = default;

    [[nodiscard]] Span span(const DVec3& o, const DVec3& d) const {
        if (d.y == 0) return o.y < 0 ? Span{-kInfinity, kInfinity} : Span{};
        const double t = -o.y / d.y;
        return d.y < 0 ? Span{t, kInfinity} : Span{-kInfinity, t};
    }
    [[nodiscard]] Crossing first(const DVec3& o, const DVec3& d, Start start) const {
        return firstCrossing(*this, o, d, start);
    }
    [[nodiscard]] bool inside(const DVec3& p) const { return p.y < 0; }
    [[nodiscard]] int nearestFace(const DVec3&) const { return 0; }
    [[nodiscard]] DVec3 project(const DVec3& p, int) const { return {p.x, 0, p.z}; }
    [[nodiscard]] DVec3 normal(const DVec3&, int) const { return {0, 1, 0}; }
    [[nodiscard]] DMat3 normalSlope(const DVec3&, int) const { return DMat3(0.0); }
    /// Local x and -z, unbounded.
    [[nodiscard]] DVec2 uv(const DVec3& p, int) const { return {p.x, -p.z}; }
    /// A plane never emits: the file format forbids it.
    [[nodiscard]] DirectionSample sampleDirection(const Viewpoint&, const DVec2&) const {
        return {};
    }
    [[nodiscard]] double pdfDirection(const Viewpoint&, const DVec3&) const { return 0; }
};

struct Plane {
    bool operator==(const Plane&) const = default;
    static constexpr std::string_view kind = "plane";
    static constexpr auto fields() { return std::tuple{}; }
    [[nodiscard]] DVec3 halfExtents() const { return DVec3(1.0); }
    [[nodiscard]] CanonicalPlane canonical() const { return {}; }
};

}  // namespace glint
