// Surfaces that coincide up to rounding: a rug on a floor, a lamp flush with a ceiling, boxes whose
// tops are level, an object and its copy in the same place. Which of them is seen, and what a ray
// meets that starts on them, must not be a matter of the last bits, which differ from pixel to
// pixel. What rounding may have done is derived from the coordinates; nothing else counts as
// touching.
#pragma once

#include <optional>

#include "tracer/math/ray.h"
#include "tracer/shapes/all.h"

namespace glint {

/// What roundings may have moved a surface by, over the coordinates that place it: some thirty of a
/// double's (transforms of groups, the move to the scene's origin, the hit put back onto the
/// surface).
inline constexpr double kPlaceRounding = 0x1p-48;
/// Hits whose t differ by no more than this share are weighed by tieOrder().
inline constexpr double kTieRange = 0x1p-26;

/// Whether rounding alone may be what puts a point at `p` by `height` out of a surface placed at
/// `center`.
[[nodiscard]] inline bool isOn(double height, const DVec3& p, const DVec3& center) {
    return std::abs(height) <= kPlaceRounding * (coordinateSum(p) + coordinateSum(center));
}

/// Hits within this share of the coordinates may be of a surface that the ray starts on: who grazes
/// more flatly than kPlaceRounding / kTouchRange is no case.
inline constexpr double kTouchRange = 0x1p-16;

/// The order in which a path meets surfaces that coincide, from either side: flat ones lie on top
/// of others, and later ones on earlier ones; the higher comes first. Never 0.
[[nodiscard]] constexpr std::uint64_t tieRank(std::uint32_t index, bool closed) {
    const std::uint64_t rank = 1 + index % 256 + (closed ? 0 : 256);
    return rank << 32U | (~index & 0xffffffffU);
}

/// A ray near a surface, in render space: how far above it is, and the cosine to the outward
/// normal.
struct Passing {
    double height = 0, cosine = 0;
};
template <class Shape>
[[nodiscard]] Passing passingOf(const Shape& shape, const DMat3& localFromWorld, const DVec3& local,
                                const DVec3& localDirection, int face) {
    const DVec3 p = shape.project(local, face), n = shape.normal(p, face);
    const double length = glm::length(n * localFromWorld);
    return {glm::dot(local - p, n) / length, glm::dot(localDirection, n) / length};
}

/// A shape where the lists have it.
template <class Shape>
struct Placed {
    const Shape& shape;
    const DMat3& localFromWorld;
    const DVec3& center;
    std::uint32_t index;
};

/// In a closed convex shape or on its boundary: inside once drawn in by a last place.
template <class Shape>
[[nodiscard]] bool isWithin(const Shape& shape, const DVec3& o) {
    if constexpr (Shape::closed && Shape::convex)
        return shape.inside((1 - 0x1p-52) * o - DVec3(0, std::numeric_limits<double>::min(), 0));
    return false;
}

/// For a ray that has gone through a surface: its hit on this one if that coincides with it where
/// the ray starts, at once or never again; else nothing.
template <class Shape>
[[nodiscard, gnu::noinline]] std::optional<Crossing> hitBehindPassed(const Placed<Shape>& placed,
                                                                     const Ray& ray, const DVec3& o,
                                                                     const DVec3& d) {
    const Shape& shape = placed.shape;
    int face = 0;
    if constexpr (requires { shape.nearestFace(o); }) face = shape.nearestFace(o);
    const Passing at = passingOf(shape, placed.localFromWorld, o, d, face);
    if (!isOn(at.height, ray.origin, placed.center) || at.cosine == 0) return {};
    // From a little before it, so that rounding cannot have put it behind the origin.
    const double place = coordinateSum(ray.origin) + coordinateSum(placed.center);
    const double back = 4 * kPlaceRounding * place / std::abs(at.cosine);
    const Crossing found = shape.first(o - back * d, d, Start::Elsewhere);
    if (!(found.t <= 2 * back)) return {};
    if (tieRank(placed.index, Shape::closed) < ray.passed) return Crossing{0.0, found.face};
    return shape.first(o, d, !Shape::closed || at.cosine > 0 ? Start::Leaving : Start::Entering);
}

/// The hit of a ray that starts on a surface that touches this one, see firstHitOf().
template <class Shape>
[[nodiscard, gnu::noinline]] Crossing hitFromTouching(const Placed<Shape>& placed, const Ray& ray,
                                                      const DVec3& o, const DVec3& d,
                                                      const Crossing& found) {
    const Shape& shape = placed.shape;
    const double place = coordinateSum(ray.origin) + coordinateSum(placed.center);
    if constexpr (Shape::closed && Shape::convex)
        if (isWithin(shape, o)) {
            const int face = shape.nearestFace(o);
            const Passing at = passingOf(shape, placed.localFromWorld, o, d, face);
            if (-at.height <= kPlaceRounding * place && at.cosine < 0)
                return ray.returns ? shape.first(o, d, Start::Entering) : Crossing{0.0, face};
        }
    if (!found.found()) return found;
    const Passing at = passingOf(shape, placed.localFromWorld, o, d, found.face);
    if (!isOn(at.height, ray.origin, placed.center)) return found;
    if (!Shape::closed || at.cosine > 0) return shape.first(o, d, Start::Leaving);
    return ray.returns ? shape.first(o, d, Start::Entering) : found;
}

/// The first hit of a ray on a shape; `o` and `d` are its origin and direction in the shape's
/// space. Where the ray starts on another surface and this one coincides with that, it starts on
/// this one too: it does not meet it on the way out, and meets it at once on the way in, unless the
/// path was inside already (a rug on the floor of a room that is a box) and goes back there. What
/// goes through a surface meets the others there one after the other (a film on a wall).
template <class Shape>
[[nodiscard]] Crossing firstHitOf(const Placed<Shape>& placed, const Ray& ray, const DVec3& o,
                                  const DVec3& d, Start start) {
    const Crossing found = placed.shape.first(o, d, start);
    if (ray.fromShape == kNoShape || start != Start::Elsewhere) return found;
    if (ray.passed != 0)
        if (const std::optional<Crossing> hit = hitBehindPassed(placed, ray, o, d)) return *hit;
    const bool mayTouch =
        found.t <= kTouchRange * (coordinateSum(ray.origin) + coordinateSum(placed.center)) ||
        isWithin(placed.shape, o);
    return mayTouch ? hitFromTouching(placed, ray, o, d, found) : found;
}

/// What hits within kTieRange of each other are ordered by: t, less what rounding may have added to
/// it, so many times as the surface has rank. An order of numbers, so it does not depend on which
/// hit was found first.
template <class Shape>
[[nodiscard]] double tieOrder(const Placed<Shape>& placed, const Ray& ray, const Crossing& hit) {
    constexpr double kStep = 0x1p-47;
    const auto rank = static_cast<double>(tieRank(placed.index, Shape::closed) >> 32U);
    const DVec3 o = placed.localFromWorld * (ray.at(hit.t) - placed.center),
                d = placed.localFromWorld * ray.direction;
    const double cosine =
        std::abs(passingOf(placed.shape, placed.localFromWorld, o, d, hit.face).cosine);
    // The same for all that coincide: of the ray and t alone.
    const double near = hit.t + coordinateSum(ray.origin), slack = rank * kStep * near / cosine;
    return hit.t -
           std::min(kTieRange / 2 * near, slack);  // In this order also if slack is no number.
}

}  // namespace glint
