// Shadow rays: how much light arrives from a point or a direction, through whatever lets it pass
// unbent.
#pragma once

#include "tracer/render/kernel.h"
#include "tracer/render/scattering.h"

namespace glint {

/// The media of a ray that leaves `point` in the local direction `wi`.
template <Features F>
[[nodiscard, gnu::always_inline]] inline MediaStack mediaBeyond(KernelState& state,
                                                                const SurfacePoint& point,
                                                                const MediaStack& media,
                                                                const Vec3& wi) {
    MediaStack out = media;
    if constexpr (has(F, Feature::Media))
        if (point.instance(state.scene).dielectric && (wi.z > 0) != point.outside) {
            ++state.work[Work::MediaSteps];
            out.cross(point.shape);
        }
    return out;
}

/// Surfaces so near before a lamp, over the coordinates, count as coincident with it:
/// kPlaceRounding for lamps seen at a thousandth of a right angle and more.
inline constexpr double kLampRange = 0x1p-38;

/// What a shadow ray comes from.
struct ShadowTarget {
    std::uint32_t light;  ///< its index
    double distance;      ///< along the ray [m]
    std::uint32_t shape;  ///< the light's own, which does not shadow itself; kNoShape: it has none
};

/// shadowTransmittance() up to tMax where some surfaces let light pass; `few`: the shapes that may
/// be met.
template <Features F>
[[nodiscard, gnu::noinline]] Rgb transmittanceThrough(KernelState& state, const Ray& start,
                                                      const MediaStack& around, std::uint32_t light,
                                                      double tMax, const FewShapes* few, int passes,
                                                      bool tinted) {
    const RenderScene& scene = state.scene;
    Ray ray = start;
    MediaStack media = around;
    Rgb share(1.0f);
    while (true) {
        ++state.work[Work::ShadowSteps];
        const ShapeHit hit = scene.lists->closest(ray, media, tMax, state.work, few);
        const bool toLight = hit.found() && hit.shape == light, arrived = !hit.found() || toLight;
        if constexpr (has(F, Feature::Media))
            share *= transmittance<F>(mediumOf(scene, fillingShape(scene, media)),
                                      arrived ? tMax : hit.t, state.work);
        if (!hit.found() || isBlack(share)) return share;
        const ShapeInstance& instance = scene.shapes[hit.shape];
        if (toLight && !instance.dielectric) return share;
        const SurfacePoint point = surfacePoint(scene, ray, hit, media);
        // Paths find nothing at a hidden boundary, so no light either.
        if (toLight) return point.hidden ? Rgb(0.0f) : share;
        const bool tints = tinted && instance.dielectric;
        const CompiledMaterial& material = scene.materials[instance.material];
        // Of an opaque surface nothing counts but that it is one, and of a clear one that it is
        // clear: edits that change this start anew.
        const bool isClear = tints && scene.clearShadows;
        if (!isClear && (tints || !isBlack(material.straight))) state.materials |= material.bit;
        if (!tints && !point.hidden) {
            if (passes-- <= 0) return Rgb(0.0f);
            if (isBlack(material.straight)) return Rgb(0.0f);
            share *= straightWeight(material, point.wo, point.eta, state.work);
            if (isBlack(share)) return share;
        }
        if (!isClear) state.follow(point.shape * 16 + static_cast<std::uint32_t>(point.face));
        if (instance.dielectric) media.cross(hit.shape);
        tMax -= hit.t;
        ray = point.ray(ray.direction, point.outside);
    }
}

/// Share of light that comes along `start` from the target; `around`: the media that it is in. At
/// most `passes` surfaces may be gone through. With `tinted`, dielectrics let light pass unbent and
/// only absorb (classic's transparent shadows).
template <Features F>
[[nodiscard, gnu::always_inline]] inline Rgb shadowTransmittance(KernelState& state,
                                                                 const Ray& start,
                                                                 const MediaStack& around,
                                                                 const ShadowTarget& target,
                                                                 int passes, bool tinted) {
    const RenderScene& scene = state.scene;
    double tMax = target.distance;
    const FewShapes* few =
        has(F, Feature::NoSkips) ? nullptr : scene.lightBuffers.between(target.light, start.origin);
    // What a lamp lies flush with does not shadow it.
    if (target.shape != kNoShape) tMax -= kLampRange * (tMax + coordinateSum(start.origin));
    ++state.rays.shadow;
    const bool opaque = !has(F, Feature::NoSkips) && !has(scene.features, Feature::Straight);
    const bool isClear = !has(F, Feature::NoSkips) && tinted && scene.clearShadows;
    if (((has(F, Feature::Straight) && !opaque) || tinted) && !isClear)
        return transmittanceThrough<F>(state, start, around, target.shape, tMax, few, passes,
                                       tinted);
    if (scene.lists->occluded(start, around, tMax, target.shape, state.work, few, isClear))
        return Rgb(0.0f);
    if constexpr (has(F, Feature::Media))
        return transmittance<F>(mediumOf(scene, fillingShape(scene, around)), tMax, state.work);
    return Rgb(1.0f);
}

}  // namespace glint
