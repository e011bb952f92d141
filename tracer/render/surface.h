// The surface where a ray ends: place, frame, material, and which media meet there.
#pragma once

#include "tracer/compile/render_scene.h"
#include "tracer/math/frame.h"

namespace glint {

inline constexpr Medium kVacuum{};

/// The shape whose medium fills the place: the highest priority, of equals the one entered last;
/// kNoShape outside all.
[[nodiscard]] inline std::uint32_t fillingShape(const RenderScene& scene, const MediaStack& media) {
    std::uint32_t best = kNoShape;
    int priority = 0;
    for (int i = 0; i < media.size(); ++i) {
        const int p = scene.materials[scene.shapes[media[i]].material].medium.priority;
        if (best == kNoShape || p >= priority) best = media[i], priority = p;
    }
    return best;
}
[[nodiscard]] inline const Medium& mediumOf(const RenderScene& scene, std::uint32_t shape) {
    return shape == kNoShape ? kVacuum : scene.materials[scene.shapes[shape].material].medium;
}

/// The shapes whose media meet where a path in `media` crosses the boundary of `shape`.
struct BoundarySides {
    std::uint32_t here, there;
};
[[nodiscard]] inline BoundarySides sidesOf(const RenderScene& scene, const MediaStack& media,
                                           std::uint32_t shape) {
    if (media.empty()) return {kNoShape, shape};
    if (media.size() == 1 && media[0] == shape) return {shape, kNoShape};
    MediaStack beyond = media;
    beyond.cross(shape);
    return {fillingShape(scene, media), fillingShape(scene, beyond)};
}

/// Share of light left after `distance` metres: exp(-absorption * distance), also where that is
/// infinite.
template <Features F>
[[nodiscard]] Rgb transmittance(const Medium& medium, double distance, WorkCounts& work) {
    if (!has(F, Feature::NoSkips) && isBlack(medium.absorption)) return Rgb(1.0f);
    ++work[Work::Exponentials];
    const auto channel = [distance](double a) {
        return a > 0 ? static_cast<float>(std::exp(-a * distance)) : 1.0f;
    };
    return {channel(medium.absorption.r), channel(medium.absorption.g),
            channel(medium.absorption.b)};
}

/// The dielectrics around a camera ray's origin.
[[nodiscard]] inline MediaStack mediaAt(const RenderScene& scene, const DVec3& origin) {
    MediaStack media = scene.cameraMedia;
    for (const std::uint32_t shape : scene.cameraBoundaries)
        if (scene.shapes[shape].holds(origin)) media.cross(shape);
    return media;
}

struct SurfacePoint {
    DVec3 position{0.0};  ///< on the surface, in render space
    Frame frame;          ///< z along the outward normal
    Vec3 wo{0.0f};        ///< local, towards where the ray came from
    std::uint32_t shape = kNoShape;
    int face = 0;         ///< of the shape
    bool outside = true;  ///< the ray came from the outward side
    float eta =
        1;  ///< index on wo's side over the other side; over 1 where there is no medium behind
    std::uint64_t rank = 0;  ///< tieRank(); 0 for dielectrics
    bool hidden = false;  ///< the boundary of a dielectric inside one of higher priority: there is
                          ///< nothing to see

    [[nodiscard]] const ShapeInstance& instance(const RenderScene& scene) const {
        return scene.shapes[shape];
    }
    /// The normal on wo's side.
    [[nodiscard]] DVec3 facingNormal() const { return outside ? frame.n : -frame.n; }
    /// A ray that starts here in the local direction `wi`.
    [[nodiscard]] Ray ray(const Vec3& wi) const {
        return ray(renormalize(frame.toWorld(wi)), wi.z < 0);
    }
    /// A ray that starts here in a direction of render space, inwards or outwards.
    [[nodiscard]] Ray ray(const DVec3& direction, bool inwards) const {
        return {position, direction,          shape,
                inwards,  inwards != outside, inwards == outside ? rank : 0};
    }
};

/// The point hit by `ray`, which is in `media`. The hit is put back onto the surface in local
/// space, so its error is a few roundings of the shape's own size however far the ray came.
[[nodiscard]] inline SurfacePoint surfacePoint(const RenderScene& scene, const Ray& ray,
                                               const ShapeHit& hit, const MediaStack& media) {
    const ShapeInstance& instance = scene.shapes[hit.shape];
    SurfacePoint out;
    out.shape = hit.shape;
    out.face = hit.face;
    const DVec3 raw = instance.localVector(ray.origin - instance.center + hit.t * ray.direction);
    DVec3 local, localNormal;
    std::visit(
        [&]<class Shape>(const Shape& shape) {
            local = shape.project(raw, hit.face);
            localNormal = shape.normal(local, hit.face);
            if (!instance.dielectric) out.rank = tieRank(hit.shape, Shape::closed);
        },
        instance.shape);
    out.position = instance.center + instance.worldFromLocal * local;
    out.frame = Frame(
        renormalize(instance.normalScale * (localNormal * instance.localFromWorld)));  // (M^-1)^T n
    DVec3 wo = out.frame.toLocal(-ray.direction);
    out.outside = wo.z > 0;
    if (instance.dielectric) {
        // The tracked side is the truth; at grazing angles rounding may have put the direction on
        // the other, or in between: its sign tells every BSDF the side, so it must have one.
        out.outside = !media.contains(hit.shape);
        constexpr double kLeast = 0x1p-53;  // one rounding of a unit vector
        wo.z = std::copysign(std::max(std::abs(wo.z), kLeast), out.outside ? 1.0 : -1.0);
        const BoundarySides sides = sidesOf(scene, media, hit.shape);
        out.hidden = sides.here == sides.there;
        out.eta = mediumOf(scene, sides.here).ior / mediumOf(scene, sides.there).ior;
    } else if (!media.empty()) {
        out.eta = mediumOf(scene, fillingShape(scene, media)).ior;
    }
    out.wo = toFloat(wo);
    return out;
}

}  // namespace glint
