// What a compiled material is made of: a list of weighted leaves (BSDFs), because every material is
// linear in simple ones.
//
// Directions are unit vectors in the local frame, z along the outward normal; `wo` points to the
// viewer, `wi` to the light, both away from the surface; either may be on either side. A leaf may
// have a smooth part (value/sample; f excludes the cosine, pdf is per solid angle) and a delta part
// (branches). `eta` is the refractive index on wo's side over that on the other side, from the
// media the path is in; behind a surface that encloses no medium it counts as 1, so that `eta` is
// the index around. Leaves depend on nothing else. A rough leaf names the delta part that it is
// near to (perfectBranches).
#pragma once

#include <algorithm>

#include "tracer/color/rgb.h"
#include "tracer/math/warp.h"

namespace glint {

/// A smooth part for two directions: its f, and the density with which it would draw the second
/// one.
struct BsdfValue {
    Rgb f{0.0f};
    float pdf = 0;
};

/// A direction drawn from a smooth part. pdf 0 means "no sample".
struct BsdfSample {
    Vec3 wi{0.0f};
    Rgb f{0.0f};
    float pdf = 0;

    BsdfSample() = default;
    BsdfSample(const Vec3& direction, const BsdfValue& value)
        : wi(direction), f(value.f), pdf(value.pdf) {}
};

/// One direction of a delta part: light from `wi` reaches `wo` with the factor `weight`.
struct DeltaBranch {
    Vec3 wi{0.0f};
    Rgb weight{0.0f};
    bool straight = false;  ///< wi == -wo: a shadow ray can go through
    float scale = 1;        ///< the part of `weight` that only restates radiance in another medium
                            ///< (eta^2); not to choose by
};

/// The narrowest lobe of a leaf: GGX's alpha, and how much of light from 45 degrees goes into it,
/// colour left aside.
struct Gloss {
    static constexpr double kWidest = 0.15;  ///< wider lobes are not narrow
    double alpha = 1;
    float strength = 0;
};

/// At most this many branches come from one leaf.
inline constexpr int kMaxBranches = 2;

[[nodiscard]] inline bool sameSide(const Vec3& a, const Vec3& b) { return a.z * b.z > 0; }
[[nodiscard]] inline Vec3 mirrored(const Vec3& w) { return {-w.x, -w.y, w.z}; }

/// alpha = roughness^2 in every microfacet lobe.
[[nodiscard]] inline float alphaFromRoughness(float roughness) { return roughness * roughness; }

/// Cosine-weighted direction on the side of `reference`.
[[nodiscard]] inline Vec3 cosineOnSideOf(const Vec3& reference, const Vec2& u) {
    const Vec3 w = cosineHemisphere(u);
    return reference.z < 0 ? Vec3(w.x, w.y, -w.z) : w;
}

/// Snell's law: the direction on the other side, with `eta` = n(wo's side) / n(other side). False:
/// total internal reflection.
[[nodiscard]] inline bool refract(const Vec3& wo, float eta, Vec3& wi) {
    const float sin2 = eta * eta * std::max(0.0f, wo.x * wo.x + wo.y * wo.y);
    if (sin2 >= 1) return false;
    wi = {-eta * wo.x, -eta * wo.y, -std::copysign(std::sqrt(1 - sin2), wo.z)};
    return true;
}

/// Fresnel's reflectance of a dielectric for unpolarised light; `cosine` >= 0 on wo's side, `eta`
/// as above. Written without the subtraction of near-equal numbers at grazing angles (Pharr et al.,
/// PBR 4th ed., sec. 9.3.5).
[[nodiscard]] inline float fresnelDielectric(float cosine, float eta) {
    const double c = std::min(1.0, static_cast<double>(cosine)), e = eta;
    const double cos2t = 1 - e * e * (1 - c * c);
    if (cos2t <= 0) return 1;
    const double ct = std::sqrt(cos2t);
    const double parallel = (c - e * ct) / (c + e * ct),
                 perpendicular = (e * c - ct) / (e * c + ct);
    return static_cast<float>(0.5 * (parallel * parallel + perpendicular * perpendicular));
}

}  // namespace glint
