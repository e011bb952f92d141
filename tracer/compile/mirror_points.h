// Where a surface mirrors a place to an eye (Alhazen's problem, for every shape), and how much that
// spreads light. Pure geometry, for highlights.h.
//
// A mirror point makes the length of the way from the eye over the surface to the place stationary.
// On convex shapes, seen from outside, it is the one minimum of a convex function; Newton's method
// on the surface finds it but for some eyes that nearly touch a stretched shape. On a torus there
// are several, and which of them are found depends on where the search starts. What is found is a
// function of eye and place alone, so that whoever must know whether a point would have been found
// can ask. Source of the equations: Zeltner, Georgiev, Jakob, "Specular Manifold Sampling", ACM TOG
// 39(4), 2020, sec. 3, with half vectors replaced by lengths.
#pragma once

#include <array>

#include "tracer/compile/shape_lists.h"

namespace glint {

/// Where mirrored light comes from: a place, or a unit direction towards it if it is infinitely
/// far.
struct MirrorTarget {
    DVec3 place{0.0};
    bool far = false;
};

/// Faces of a shape, as its normal() numbers them.
[[nodiscard]] int faceCount(const ShapeInstance& shape);
/// The face lies in a plane.
[[nodiscard]] bool isFlat(const ShapeInstance& shape, int face);

/// The points of a curved face, in render space, at which it mirrors the target to the eye, both on
/// its outer side. What lies in between is not looked at. Each solves the law of reflection to
/// about 1e-9. Answers how many were written to `out`.
inline constexpr std::size_t kMaxMirrorPoints = 2;
[[nodiscard]] int findMirrorPoints(const ShapeInstance& shape, int face, const DVec3& eye,
                                   const MirrorTarget& target,
                                   std::array<DVec3, kMaxMirrorPoints>& out);

/// A ray from an eye as it is reflected at a point.
struct Reflected {
    DVec3 direction{0.0};  ///< unit
    /// Solid angle behind the point per solid angle at the eye, for light from infinitely far.
    double spread = 0;
    /// Area perpendicular to the ray at `distance` behind the point per solid angle at the eye.
    [[nodiscard]] double areaAt(double distance) const;

    DVec3 footprint[2]{}, turn[2]{};  ///< changes of the point and of the direction with two
                                      ///< perpendicular turns of the ray at the eye
};
/// `point` lies on the face.
[[nodiscard]] Reflected reflectAt(const ShapeInstance& shape, int face, const DVec3& eye,
                                  const DVec3& point);

}  // namespace glint
