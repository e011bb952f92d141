// Rectangle in y = 0 with normal +y. Canonical form: [-1,1] x [-1,1] in x and z.
#pragma once

#include "tracer/base/reflect.h"
#include "tracer/shapes/crossing.h"
#include "tracer/shapes/spherical_quad.h"

namespace glint {

struct CanonicalQuad {
    static constexpr bool closed = false, convex = true;

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
    /// Over [0,1]^2: u along x, v along -z.
    [[nodiscard]] DVec2 uv(const DVec3& p, int) const { return {(p.x + 1) / 2, (1 - p.z) / 2}; }
    [[nodiscard]] DirectionSample sampleDirection(const DVec3& o, const DVec2& u) const {
        DirectionSample s = seenFrom(o).sample(u);
        s.direction = {s.direction.x, s.direction.z, s.direction.y};
        return s;
    }
    [[nodiscard]] double pdfDirection(const DVec3& o, const DVec3& d) const {
        return seenFrom(o).pdf({d.x, d.z, d.y});
    }

  private:
    /// With y and z exchanged, as SphericalQuad wants it.
    static SphericalQuad seenFrom(const DVec3& o) {
        return {-1 - o.x, -1 - o.z, 1 - o.x, 1 - o.z, -o.y};
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
