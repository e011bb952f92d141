// Box. Canonical form: the cube [-1,1]^3. Faces: 2 * axis + (1 on the positive side).
#pragma once

#include <array>

#include "tracer/base/reflect.h"
#include "tracer/shapes/crossing.h"
#include "tracer/shapes/side_view.h"
#include "tracer/shapes/spherical_quad.h"

namespace glint {

struct CanonicalBox {
    static constexpr bool closed = true, convex = true;
    bool operator==(const CanonicalBox&) const = default;

    /// Slabs.
    [[nodiscard]] Span span(const DVec3& o, const DVec3& d) const {
        if (d.x == 0 || d.y == 0 || d.z == 0) return spanAlongFaces(o, d);
        const DVec3 sign(std::copysign(1.0, d.x), std::copysign(1.0, d.y), std::copysign(1.0, d.z));
        const DVec3 enter = (-sign - o) / d, leave = (sign - o) / d;
        const double t0 = std::max(std::max(enter.x, enter.y), enter.z),
                     t1 = std::min(std::min(leave.x, leave.y), leave.z);
        // No branches: which face it is, the processor cannot guess.
        const int axis0 = firstOf(enter.x == t0, enter.y == t0),
                  axis1 = firstOf(leave.x == t1, leave.y == t1);
        return {t0, t1, 2 * axis0 + (d[axis0] < 0), 2 * axis1 + (d[axis1] > 0)};
    }
    [[nodiscard]] Crossing first(const DVec3& o, const DVec3& d, Start start) const {
        return firstCrossing(*this, o, d, start);
    }
    [[nodiscard]] bool inside(const DVec3& p) const {
        return std::abs(p.x) < 1 && std::abs(p.y) < 1 && std::abs(p.z) < 1;
    }
    [[nodiscard]] int nearestFace(const DVec3& p) const {
        const DVec3 a = absolute(p);
        const int axis = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
        return 2 * axis + (p[axis] > 0 ? 1 : 0);
    }
    [[nodiscard]] DVec3 project(const DVec3& p, int face) const {
        const DVec3 n = normal(p, face);
        const auto onFace = [](double x, double side) {
            return side != 0 ? side : std::clamp(x, -1.0, 1.0);
        };
        return {onFace(p.x, n.x), onFace(p.y, n.y), onFace(p.z, n.z)};
    }
    [[nodiscard]] DVec3 normal(const DVec3&, int face) const {
        static constexpr double kNormals[6][3] = {{-1, 0, 0}, {1, 0, 0},  {0, -1, 0},
                                                  {0, 1, 0},  {0, 0, -1}, {0, 0, 1}};
        const auto& n = kNormals[face];
        return {n[0], n[1], n[2]};
    }
    [[nodiscard]] DMat3 normalSlope(const DVec3&, int) const { return DMat3(0.0); }
    /// Each face has the whole square: u and v along the two axes that follow the face's own, in
    /// the order x y z x y.
    [[nodiscard]] DVec2 uv(const DVec3& p, int face) const {
        const int axis = face / 2;
        return {(p[(axis + 1) % 3] + 1) / 2, (p[(axis + 2) % 3] + 1) / 2};
    }

    /// From outside: the faces in view, uniform in their solid angle (of the world, but for shear).
    /// From inside: all directions.
    [[nodiscard]] DirectionSample sampleDirection(const Viewpoint& view, const DVec2& u) const {
        const Visible visible(view);
        if (visible.count == 0)
            return visible.sides.toShape(view, {uniformSphere(u), kUniformSpherePdf});
        double pick = u.x * visible.total;
        std::size_t i = 0;
        while (i + 1 < visible.count && pick >= visible.solidAngle[i])
            pick -= visible.solidAngle[i++];
        const double share = visible.solidAngle[i];
        if (!(share > 0)) return {};
        const DirectionSample s = visible.quad(i).sample({std::clamp(pick / share, 0.0, 1.0), u.y});
        const int axis = visible.axis[i];
        DVec3 direction;
        direction[(axis + 1) % 3] = s.direction.x;
        direction[(axis + 2) % 3] = s.direction.y;
        direction[axis] = s.direction.z;
        return visible.sides.toShape(view, {direction, s.pdf * share / visible.total});
    }
    [[nodiscard]] double pdfDirection(const Viewpoint& view, const DVec3& d) const {
        const Visible visible(view);
        if (visible.count == 0) return visible.sides.worldDensity(view, d, kUniformSpherePdf);
        const int face = span(view.origin, d).face0;
        for (std::size_t i = 0; i < visible.count; ++i) {
            const int axis = visible.axis[i];
            if (axis != face / 2 || !(visible.solidAngle[i] > 0)) continue;
            const DVec3 e = visible.sides.direction(d),
                        turned(e[(axis + 1) % 3], e[(axis + 2) % 3], e[axis]);
            const double density =
                visible.quad(i).pdf(turned) * visible.solidAngle[i] / visible.total;
            return visible.sides.worldDensity(view, d, density);
        }
        return 0;
    }

  private:
    /// 0, 1 or 2: what is first true of two things and anything else.
    static int firstOf(bool a, bool b) { return static_cast<int>(!a) + static_cast<int>(!a & !b); }

    /// span() of a ray that is parallel to some faces. Within such a slab's bounding plane it
    /// counts as inside that slab, so no 0 * infinity arises.
    [[nodiscard, gnu::noinline]] Span spanAlongFaces(const DVec3& o, const DVec3& d) const {
        Span out{-kInfinity, kInfinity};
        for (int axis = 0; axis < 3; ++axis) {
            if (d[axis] == 0) {
                if (std::abs(o[axis]) > 1) return {};
                continue;
            }
            const bool up = d[axis] > 0;
            const double enter = ((up ? -1.0 : 1.0) - o[axis]) / d[axis],
                         leave = ((up ? 1.0 : -1.0) - o[axis]) / d[axis];
            if (enter > out.t0) out.t0 = enter, out.face0 = 2 * axis + (up ? 0 : 1);
            if (leave < out.t1) out.t1 = leave, out.face1 = 2 * axis + (up ? 1 : 0);
        }
        return out;
    }

    /// The at most three faces that a point outside can see.
    struct Visible {
        explicit Visible(const Viewpoint& view) : sides(view) {
            for (int a = 0; a < 3; ++a) {
                if (!(std::abs(view.origin[a]) > 1)) continue;
                axis[count] = a;
                solidAngle[count] = quad(count).solidAngle();
                total += solidAngle[count++];
            }
        }
        [[nodiscard]] SphericalQuad quad(std::size_t i) const {
            const int a = axis[i], b = (a + 1) % 3, c = (a + 2) % 3;
            const DVec3 &o = sides.origin, &half = sides.half;
            return {-half[b] - o[b], -half[c] - o[c], half[b] - o[b], half[c] - o[c],
                    std::copysign(half[a], o[a]) - o[a]};
        }
        SideView sides;
        std::array<int, 3> axis{};
        std::array<double, 3> solidAngle{};
        std::size_t count = 0;
        double total = 0;
    };
};

struct Box {
    DVec3 size{1, 1, 1};

    bool operator==(const Box&) const = default;
    static constexpr std::string_view kind = "box";
    static constexpr auto fields() {
        return std::tuple{Field{
            "size",
            &Box::size,
            {.min = 0, .exclusiveMin = true, .unit = "m", .doc = "Lengths along x, y and z"}}};
    }
    [[nodiscard]] DVec3 halfExtents() const { return size / 2.0; }
    [[nodiscard]] CanonicalBox canonical() const { return {}; }
};

}  // namespace glint
