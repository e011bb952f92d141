// Disk in y = 0 with normal +y. Canonical form: unit radius.
#pragma once

#include "tracer/base/reflect.h"
#include "tracer/shapes/crossing.h"
#include "tracer/shapes/disk_view.h"

namespace glint {

struct CanonicalDisk {
    static constexpr bool closed = false, convex = true;
    bool operator==(const CanonicalDisk&) const = default;

    [[nodiscard]] Crossing first(const DVec3& o, const DVec3& d, Start start) const {
        if (start == Start::Leaving || start == Start::Entering || d.y == 0) return {};
        const double t = -o.y / d.y;
        if (!(t > 0)) return {};
        const double x = o.x + t * d.x, z = o.z + t * d.z;
        return x * x + z * z <= 1 ? Crossing{t} : Crossing{};
    }
    [[nodiscard]] bool inside(const DVec3&) const { return false; }
    [[nodiscard]] DVec3 project(const DVec3& p, int) const {
        const double r = axisDistance(p);
        return r > 1 ? DVec3(p.x / r, 0, p.z / r) : DVec3(p.x, 0, p.z);
    }
    [[nodiscard]] DVec3 normal(const DVec3&, int) const { return {0, 1, 0}; }
    [[nodiscard]] DMat3 normalSlope(const DVec3&, int) const { return DMat3(0.0); }
    /// Of the square around it: u along x, v along -z.
    [[nodiscard]] DVec2 uv(const DVec3& p, int) const { return {(p.x + 1) / 2, (1 - p.z) / 2}; }

    [[nodiscard]] DirectionSample sampleDirection(const Viewpoint& view, const DVec2& u) const {
        const DiskView::Sample s = DiskView(view, 0).sample(u);
        return view.towards(s.point, s.pdf);
    }
    [[nodiscard]] double pdfDirection(const Viewpoint& view, const DVec3& d) const {
        if (d.y == 0) return 0;
        return DiskView(view, 0).pdf(view.origin - view.origin.y / d.y * d);
    }
};

struct Disk {
    double radius = 1;

    bool operator==(const Disk&) const = default;
    static constexpr std::string_view kind = "disk";
    static constexpr auto fields() {
        return std::tuple{Field{"radius",
                                &Disk::radius,
                                {.min = 0, .exclusiveMin = true, .unit = "m", .doc = "Radius"}}};
    }
    [[nodiscard]] DVec3 halfExtents() const { return DVec3(radius); }
    [[nodiscard]] CanonicalDisk canonical() const { return {}; }
};

}  // namespace glint
