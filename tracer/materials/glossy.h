// Glossy: a dielectric coat over a diffuse base, both sides. The coat stands in air: the medium
// around is not asked for.
#pragma once

#include "tracer/base/reflect.h"
#include "tracer/materials/albedo_tables.h"
#include "tracer/materials/bsdf.h"
#include "tracer/scene/ids.h"

namespace glint {

/// A polished coat: a mirror by Fresnel's law as delta part, and the base under it as smooth part,
/// f = color * (1-F(o))(1-F(i)) / (pi (1-F_avg)): reciprocal, and nothing is lost with a white
/// base. The deeper colour that reflections within the coat would give is left out.
class PolishedGlossyBsdf {
  public:
    static constexpr bool kSmooth = true, kDelta = true;

    PolishedGlossyBsdf(const Rgb& color, float ior)
        : color_(color),
          eta_(1 / ior),
          entering_(static_cast<float>(1 - averageFresnel(1.0 / ior))) {}
    [[nodiscard]] Rgb albedo() const { return color_ * entering_; }
    [[nodiscard]] Rgb eval(const Vec3& wo, const Vec3& wi, float) const {
        if (!sameSide(wo, wi)) return Rgb(0.0f);
        const float passes = (1 - fresnelDielectric(std::abs(wo.z), eta_)) *
                             (1 - fresnelDielectric(std::abs(wi.z), eta_));
        return color_ * (passes / (kPiF * entering_));
    }
    [[nodiscard]] float pdf(const Vec3& wo, const Vec3& wi, float) const {
        return sameSide(wo, wi) ? std::abs(wi.z) * (1 / kPiF) : 0.0f;
    }
    [[nodiscard]] BsdfSample sample(const Vec3& wo, const Vec3& u, float eta) const {
        const Vec3 wi = cosineOnSideOf(wo, {u.x, u.y});
        return {wi, eval(wo, wi, eta), pdf(wo, wi, eta)};
    }
    [[nodiscard]] int branches(const Vec3& wo, float, DeltaBranch* out) const {
        const float reflectance = fresnelDielectric(std::abs(wo.z), eta_);
        out[0] = {mirrored(wo), Rgb(reflectance)};
        return reflectance > 0 ? 1 : 0;
    }

  private:
    Rgb color_;
    float eta_, entering_;  ///< entering: 1 - F_avg
};

/// A rough coat: GGX with Fresnel's law, over the same base with the coat's albedo E in place of F.
/// Light that bounces twice within the coat's relief counts as entering the base.
class GlossyBsdf {
  public:
    static constexpr bool kSmooth = true, kDelta = false;

    /// alpha in [kMinAlpha, 1], ior >= 1.
    GlossyBsdf(const Rgb& color, float ior, float alpha)
        : color_(color),
          eta_(1 / static_cast<double>(ior)),
          ggx_(alpha),
          passing_(coatPassing(alpha, ior)) {}
    [[nodiscard]] Rgb albedo() const {
        const float entering = static_cast<float>(passing_.average());
        return color_ * entering + Rgb(1 - entering);
    }
    [[nodiscard]] Rgb eval(const Vec3& wo, const Vec3& wi, float) const {
        const ReflectionPair p(wo, wi);
        return p.valid ? evalPair(p) : Rgb(0.0f);
    }
    /// The part of eval() that is the base's.
    [[nodiscard]] Rgb evalBase(const Vec3& wo, const Vec3& wi) const {
        const ReflectionPair p(wo, wi);
        return p.valid ? color_ * base(p) : Rgb(0.0f);
    }
    [[nodiscard]] float pdf(const Vec3& wo, const Vec3& wi, float) const {
        const ReflectionPair p(wo, wi);
        return p.valid ? pdfPair(p) : 0.0f;
    }
    [[nodiscard]] BsdfSample sample(const Vec3& wo, const Vec3& u, float) const {
        const DVec3 o = unitOnSide(wo, wo.z);
        if (o.z < kMinCosine) return {};
        Vec3 wi = u.z < coatShare(o.z)
                      ? toFloat(reflectAbout(o, ggx_.reflectingNormal(o, DVec2(u.x, u.y))))
                      : cosineHemisphere({u.x, u.y});
        if (wi.z <= 0) return {};
        if (wo.z < 0) wi.z = -wi.z;
        const ReflectionPair p(wo, wi);
        if (!p.valid) return {};
        return {wi, evalPair(p), pdfPair(p)};
    }
    /// The mirror of the polished coat that it is near to (classic).
    [[nodiscard]] int perfectBranches(const Vec3& wo, float, DeltaBranch* out) const {
        out[0] = {mirrored(wo), Rgb(fresnelDielectric(std::abs(wo.z), static_cast<float>(eta_)))};
        return 1;
    }

  private:
    [[nodiscard]] Rgb evalPair(const ReflectionPair& p) const {
        const double coat =
            ggx_.d(p.h) * ggx_.visibility(p.o, p.i) * fresnelTerm(p.cosHalf, eta_).reflectance;
        return color_ * base(p) + Rgb(static_cast<float>(coat));
    }
    [[nodiscard]] float base(const ReflectionPair& p) const {
        return static_cast<float>(passing_(p.o.z) * passing_(p.i.z) / (kPi * passing_.average()));
    }
    [[nodiscard]] float pdfPair(const ReflectionPair& p) const {
        const double share = coatShare(p.o.z);
        return static_cast<float>(share * ggx_.reflectionPdf(p.o, p.h) +
                                  (1 - share) * p.i.z * (1 / kPi));
    }
    /// How often the coat is sampled: as much as it reflects. The floor keeps a density wherever
    /// the coat has a value.
    [[nodiscard]] double coatShare(double cosine) const {
        const double passes = passing_(cosine), coat = std::max(1e-3, 1 - passes);
        return coat / (coat + passes * maxComponent(color_));
    }

    Rgb color_;
    double eta_;
    Ggx ggx_;
    CoatPassing passing_;  ///< the share that enters the coat, or leaves it from within
};

struct Glossy {
    Textured<Color> color{Color{0.8, 0.8, 0.8}};
    Textured<double> ior{1.5};
    Textured<double> roughness{0.1};

    bool operator==(const Glossy&) const = default;
    static constexpr std::string_view kind = "glossy";
    static constexpr auto fields() {
        return std::tuple{
            Field{"color",
                  &Glossy::color,
                  {.min = 0, .max = 1, .doc = "Colour of the base under the coat"}},
            Field{
                "ior", &Glossy::ior, {.min = 1, .max = 100, .doc = "Refractive index of the coat"}},
            Field{"roughness",
                  &Glossy::roughness,
                  {.min = 0, .max = 1, .doc = "0 polished, 1 matt; alpha is its square"}}};
    }
    template <class Builder>
    void compile(Builder& builder, const Rgb& weight) const {
        const Rgb base = builder.value(color);
        const float n = builder.value(ior), alpha = alphaFromRoughness(builder.value(roughness));
        if (alpha < kMinAlpha)
            builder.add(PolishedGlossyBsdf(base, n), weight);
        else
            builder.add(GlossyBsdf(base, n, alpha), weight);
    }
};

}  // namespace glint
