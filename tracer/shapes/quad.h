// Rectangle in y = 0 with normal +y. Canonical form: [-1,1] x [-1,1] in x and z.
#pragma once

#include "tracer/base/reflect.h"
#include "tracer/shapes/crossing.h"
#include "tracer/shapes/side_view.h"
#include "tracer/shapes/spherical_quad.h"

namespace glint {

struct CanonicalQuad {
    static constexpr bool closed = false, convex = true;
    bool operator==(const CanonicalQuad&) const = default;

    [[nodiscard]] Crossing first(const DVec3& o, const DVec3& d, Start start) const {
        if (start == Start::Leaving || start == Start::Entering || d.y == 0) return {};
        const double t = -o.y / d.y;
        if (!(t > 0)) return {};
        return std::abs(o.x + t * d.x) <= 1 && std::abs(o.z + t * d.z) <= 1 ? Crossing{t}
                                                                            : Crossing{};
    }
    [[nodiscard]] bool inside(const DVec3&) const { return false; }
    [[nodiscard]] DVec3 project(const DVec3& p, int) const {
        return {std::clamp(p.x, -1.0, 1.0), 0, std::clamp(p.z, -1.0, 1.0)};
    }
    [[nodiscard]] DVec3 normal(const DVec3&, int) const { return {0, 1, 0}; }
    [[nodiscard]] DMat3 normalSlope(const DVec3&, int) const { return DMat3(0.0); }
    /// Over [0,1]^2: u along x, v along -z.
    [[nodiscard]] DVec2 uv(const DVec3& p, int) const { return {(p.x + 1) / 2, (1 - p.z) / 2}; }
    /// Uniform in the solid angle of the space in which the sides have their lengths in the world:
    /// that of the world, but for shear.
    [[nodiscard]] DirectionSample sampleDirection(const Viewpoint& view, const DVec2& u) const {
        const SideView sides(view);
        const DirectionSample s = quadFrom(sides).sample(u);
        if (!(s.pdf > 0)) return {};
        return sides.toShape(view, {{s.direction.x, s.direction.z, s.direction.y}, s.pdf});
    }
    [[nodiscard]] double pdfDirection(const Viewpoint& view, const DVec3& d) const {
        const SideView sides(view);
        const DVec3 e = sides.direction(d);
        return sides.worldDensity(view, d, quadFrom(sides).pdf({e.x, e.z, e.y}));
    }

  private:
    /// With y and z exchanged, as SphericalQuad wants it.
    static SphericalQuad quadFrom(const SideView& sides) {
        const DVec3 &o = sides.origin, &half = sides.half;
        return {-half.x - o.x, -half.z - o.z, half.x - o.x, half.z - o.z, -o.y};
    }
};

struct Quad {
    DVec2 size{1, 1};

    bool operator==(const Quad&) const = default;
    static constexpr std::string_view kind = "quad";
    static constexpr auto fields() {
        return std::tuple{
            Field{"size",
                  &Quad::size,
                  {.min = 0, .exclusiveMin = true, .unit = "m", .doc = "Lengths along x and z"}}};
    }
    [[nodiscard]] DVec3 halfExtents() const {
        return {size.x / 2, (size.x + size.y) / 4, size.y / 2};
    }
    [[nodiscard]] CanonicalQuad canonical() const { return {}; }
};

}  // namespace glint
