// Rough dielectrics: the boundary of a solid, and a thin sheet. The document's value is Glass.
#pragma once

#include "tracer/materials/albedo_tables.h"
#include "tracer/materials/bsdf.h"

namespace glint {

/// The two directions of a smooth boundary: reflection by Fresnel, transmission by Snell. Radiance
/// that crosses is scaled by eta^2, because it is squeezed into another solid angle (PBR 4th ed.,
/// sec. 9.5.2).
[[nodiscard]] inline int smoothDielectricBranches(const Vec3& wo, float eta, DeltaBranch* out) {
    const float reflectance = fresnelDielectric(std::abs(wo.z), eta);
    Vec3 wi;
    int count = 0;
    if (reflectance > 0) out[count++] = {mirrored(wo), Rgb(reflectance)};
    if (reflectance < 1 && refract(wo, eta, wi))
        out[count++] = {wi, Rgb((1 - reflectance) * eta * eta), false, eta * eta};
    return count;
}

/// GGX reflection and refraction (Walter et al., EGSR 2007) of visible normals, with Smith's
/// correlated shadowing. Light that bounces more than once is given back diffusely to both sides,
/// in shares that keep reciprocity: with losses L per side, f = (1-t) L(o) L(i) / (pi L_avg) on one
/// side and t L(o) L'(i) / (pi L'_avg) across, where t n^2 L'_avg^-1 is the same from both sides
/// because n^2 (1 - F_avg) is. Radiance that crosses is scaled by eta^2. Between media of the same
/// index, or where refraction hardly spreads light, the leaf is the smooth boundary.
class RoughGlassBsdf {
  public:
    static constexpr bool kSmooth = true, kDelta = true;

    /// alpha in [kMinAlpha, 1]. Makes sure that the tables exist, so that no render thread waits
    /// for them.
    explicit RoughGlassBsdf(float alpha);

    [[nodiscard]] Rgb albedo() const { return Rgb(1.0f); }
    [[nodiscard]] Rgb eval(const Vec3& wo, const Vec3& wi, float eta) const {
        return Rgb(valueOf(wo, wi, eta).f);
    }
    [[nodiscard]] float pdf(const Vec3& wo, const Vec3& wi, float eta) const {
        return valueOf(wo, wi, eta).pdf;
    }
    [[nodiscard]] BsdfSample sample(const Vec3& wo, const Vec3& u, float eta) const;
    [[nodiscard]] int branches(const Vec3& wo, float eta, DeltaBranch* out) const;
    /// The polished glass that it is near to (classic).
    [[nodiscard]] int perfectBranches(const Vec3& wo, float eta, DeltaBranch* out) const {
        return isSmooth(eta) ? 0 : smoothDielectricBranches(wo, eta, out);
    }

  private:
    struct Value {
        float f = 0, pdf = 0;
    };
    /// What multiple scattering gives back at one boundary, seen from wo's side.
    struct Multiple;

    /// Refraction spreads light by alpha * |eta - 1|: float directions do not resolve less.
    [[nodiscard]] bool isSmooth(double eta) const { return alpha_ * std::abs(eta - 1) < 2e-5; }
    [[nodiscard]] Value valueOf(const Vec3& wo, const Vec3& wi, double eta) const;
    [[nodiscard]] Value reflected(const DVec3& o, const DVec3& i, double eta) const;
    [[nodiscard]] Value transmitted(const DVec3& o, const DVec3& i, double eta) const;

    double alpha_;
    Ggx ggx_;
    MultipleLobe multipleLobe_;
};

/// A rough thin sheet: each microfacet reflects 2F/(1+F) and lets the rest through as if mirrored
/// to the other side, so the sheet blurs what is behind it as much as what it reflects. Energy is
/// kept as by a white metal.
class RoughThinGlassBsdf {
  public:
    static constexpr bool kSmooth = true, kDelta = false;

    /// alpha in [kMinAlpha, 1].
    RoughThinGlassBsdf(float ior, float alpha);

    [[nodiscard]] Rgb albedo() const { return Rgb(1.0f); }
    [[nodiscard]] Rgb eval(const Vec3& wo, const Vec3& wi, float) const;
    [[nodiscard]] float pdf(const Vec3& wo, const Vec3& wi, float) const;
    [[nodiscard]] BsdfSample sample(const Vec3& wo, const Vec3& u, float eta) const;
    /// The polished sheet that it is near to (classic).
    [[nodiscard]] int perfectBranches(const Vec3& wo, float, DeltaBranch* out) const {
        const auto mirror = static_cast<float>(reflectance(std::abs(static_cast<double>(wo.z))));
        out[0] = {mirrored(wo), Rgb(mirror)};
        out[1] = {-wo, Rgb(1 - mirror), true};
        return 2;
    }

  private:
    [[nodiscard]] double reflectance(double cosine) const {
        const double f = fresnelTerm(cosine, eta_).reflectance;
        return 2 * f / (1 + f);
    }
    [[nodiscard]] double lossAt(double cosine) const { return std::max(0.0, loss_(cosine)); }

    double eta_;
    Ggx ggx_;
    MultipleLobe multipleLobe_;
    MetalCurve loss_;
    double averageReflectance_ = 0;
};

}  // namespace glint
