// Rough dielectrics: the boundary of a solid, and a thin sheet. The document's value is Glass.
#pragma once

#include <span>

#include "tracer/materials/albedo_curves.h"
#include "tracer/materials/bsdf.h"
#include "tracer/materials/by_index.h"

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
        out[count++] = {wi, Rgb((1 - reflectance) * eta * eta), eta == 1, eta * eta};
    return count;
}

/// GGX reflection and refraction (Walter et al., EGSR 2007) of visible normals, with Smith's
/// correlated shadowing. Light that bounces more than once is given back diffusely to both sides,
/// in shares that keep reciprocity: with losses L per side, f = (1-t) L(o) L(i) / (pi L_avg) on one
/// side and t L(o) L'(i) / (pi L'_avg) across, where t n^2 L'_avg^-1 is the same from both sides
/// because n^2 (1 - F_avg) is. Between two indices that the leaf was not made for, nothing is given
/// back. Radiance that crosses is scaled by eta^2. Between media of the same index, or where
/// refraction hardly spreads light, the leaf is the smooth boundary.
class RoughGlassBsdf {
  public:
    static constexpr bool kSmooth = true, kDelta = true;

    /// alpha in [kMinAlpha, 1]; `etas`: the ratios of indices that the leaf can meet. Their
    /// inverses are taken in. The curves of a ratio are worked out when it is first met.
    RoughGlassBsdf(float alpha, std::span<const float> etas);

    [[nodiscard]] Rgb albedo() const { return Rgb(1.0f); }
    [[nodiscard]] BsdfValue value(const Vec3& wo, const Vec3& wi, float eta) const;
    [[nodiscard]] BsdfSample sample(const Vec3& wo, const Vec3& u, float eta) const;
    [[nodiscard]] int branches(const Vec3& wo, float eta, DeltaBranch* out) const {
        return isSmooth(eta) ? smoothDielectricBranches(wo, eta, out) : 0;
    }
    /// The polished glass that it is near to (classic).
    [[nodiscard]] int perfectBranches(const Vec3& wo, float eta, DeltaBranch* out) const {
        return isSmooth(eta) ? 0 : smoothDielectricBranches(wo, eta, out);
    }

  private:
    /// What multiple scattering gives back at one boundary, seen from wo's side.
    class Multiple {
      public:
        Multiple(double alpha, double eta);
        /// Share of the light that single scattering loses.
        [[nodiscard]] double lost(double cosine) const { return here_(cosine); }
        /// Share of it that leaves on the other side.
        [[nodiscard]] double across() const { return across_; }
        [[nodiscard]] double back(const DVec3& o, const DVec3& i) const {
            return (1 - across_) * here_(o.z) * here_(i.z) / (kPi * here_.average());
        }
        [[nodiscard]] double through(const DVec3& o, const DVec3& i) const {
            return across_ * here_(o.z) * there_(-i.z) / (kPi * there_.average());
        }

      private:
        MicrosurfaceLoss here_, there_;
        double across_;
    };

    /// Refraction spreads light by alpha * |eta - 1|: float directions do not resolve less.
    [[nodiscard]] bool isSmooth(double eta) const { return alpha_ * std::abs(eta - 1) < 2e-5; }
    [[nodiscard]] BsdfValue reflected(const DVec3& o, const DVec3& i, double eta) const;
    [[nodiscard]] BsdfValue transmitted(const DVec3& o, const DVec3& i, double eta) const;

    double alpha_;
    Ggx ggx_;
    MultipleLobe multipleLobe_;
    ByIndex<Multiple> multiple_;
};

/// A thin sheet: reflectance 2F/(1+F) from all inner reflections, and straight transmission of the
/// rest.
struct ThinGlassBsdf {
    static constexpr bool kSmooth = false, kDelta = true;
    float ior;

    [[nodiscard]] int branches(const Vec3& wo, float around, DeltaBranch* out) const {
        const float f = fresnelDielectric(std::abs(wo.z), around / ior),
                    reflectance = 2 * f / (1 + f);
        out[0] = {mirrored(wo), Rgb(reflectance)};
        out[1] = {-wo, Rgb(1 - reflectance), true};
        return 2;
    }
};

/// A rough thin sheet: each microfacet reflects 2F/(1+F) and lets the rest through as if mirrored
/// to the other side, so the sheet blurs what is behind it as much as what it reflects. Energy is
/// kept as by a white metal.
class RoughThinGlassBsdf {
  public:
    static constexpr bool kSmooth = true, kDelta = false;

    /// alpha in [kMinAlpha, 1]; `around`: the indices of the media that it can stand in.
    RoughThinGlassBsdf(float ior, float alpha, std::span<const float> around);

    [[nodiscard]] Rgb albedo() const { return Rgb(1.0f); }
    [[nodiscard]] BsdfValue value(const Vec3& wo, const Vec3& wi, float around) const;
    [[nodiscard]] BsdfSample sample(const Vec3& wo, const Vec3& u, float around) const;
    /// The polished sheet that it is near to (classic).
    [[nodiscard]] int perfectBranches(const Vec3& wo, float around, DeltaBranch* out) const {
        return ThinGlassBsdf{ior_}.branches(wo, around, out);
    }

  private:
    /// What a microfacet of the sheet reflects: 2F/(1+F).
    struct Reflectance {
        double eta, average = 0;
        explicit Reflectance(double eta);
        [[nodiscard]] double operator()(double cosine) const {
            const double f = fresnelTerm(cosine, eta).reflectance;
            return 2 * f / (1 + f);
        }
    };

    float ior_;
    Ggx ggx_;
    MultipleLobe multipleLobe_;
    MicrosurfaceLoss loss_;
    ByIndex<Reflectance> reflectance_;  ///< by the index around
};

}  // namespace glint
