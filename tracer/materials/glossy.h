// Glossy: a dielectric coat over a diffuse base, both sides.
#pragma once

#include <span>

#include "tracer/base/reflect.h"
#include "tracer/materials/albedo_curves.h"
#include "tracer/materials/bsdf.h"
#include "tracer/materials/by_index.h"
#include "tracer/scene/ids.h"

namespace glint {

/// A polished coat: a mirror by Fresnel's law as delta part, and the base under it as smooth part,
/// f = color * (1-F(o))(1-F(i)) / (pi (1-F_avg)): reciprocal, and nothing is lost with a white
/// base. The deeper colour that reflections within the coat would give is left out.
class PolishedGlossyBsdf {
  public:
    static constexpr bool kSmooth = true, kDelta = true;

    /// `around`: the indices of the media that it can stand in, that of most use first.
    PolishedGlossyBsdf(const Rgb& color, float ior, std::span<const float> around)
        : color_(color),
          coats_(around, [ior](float index) { return Coat(index / ior); }),
          entering_(coats_.nearest(around[0]).entering) {}
    [[nodiscard]] Rgb albedo() const { return color_ * entering_; }
    [[nodiscard]] BsdfValue value(const Vec3& wo, const Vec3& wi, float around) const {
        if (!sameSide(wo, wi)) return {};
        const Coat& coat = coats_.nearest(around);
        const float passes = (1 - fresnelDielectric(std::abs(wo.z), coat.eta)) *
                             (1 - fresnelDielectric(std::abs(wi.z), coat.eta));
        return {color_ * (passes / (kPiF * coat.entering)), std::abs(wi.z) * (1 / kPiF)};
    }
    [[nodiscard]] BsdfSample sample(const Vec3& wo, const Vec3& u, float eta) const {
        const Vec3 wi = cosineOnSideOf(wo, {u.x, u.y});
        return {wi, value(wo, wi, eta)};
    }
    [[nodiscard]] int branches(const Vec3& wo, float around, DeltaBranch* out) const {
        const float reflectance = fresnelDielectric(std::abs(wo.z), coats_.nearest(around).eta);
        out[0] = {mirrored(wo), Rgb(reflectance)};
        return reflectance > 0 ? 1 : 0;
    }

  private:
    struct Coat {
        float eta, entering;  ///< index around over the coat's; 1 - F_avg
        explicit Coat(float ratio)
            : eta(ratio), entering(static_cast<float>(1 - averageFresnel(ratio))) {}
    };

    Rgb color_;
    ByIndex<Coat> coats_;  ///< by the index around
    float entering_;       ///< in the first of them
};

/// A rough coat: GGX with Fresnel's law, over the same base with the coat's albedo E in place of F.
/// Light that bounces twice within the coat's relief counts as entering the base.
class GlossyBsdf {
  public:
    static constexpr bool kSmooth = true, kDelta = false;

    /// alpha in [kMinAlpha, 1], ior >= 1; `around` as for the polished coat.
    GlossyBsdf(const Rgb& color, float ior, float alpha, std::span<const float> around)
        : color_(color),
          ior_(ior),
          ggx_(alpha),
          coats_(around, [alpha, ior](float index) { return Coat(alpha, index / ior); }),
          entering_(static_cast<float>(coats_.nearest(around[0]).passing.average())) {}
    [[nodiscard]] Rgb albedo() const { return color_ * entering_ + Rgb(1 - entering_); }
    [[nodiscard]] BsdfValue value(const Vec3& wo, const Vec3& wi, float around) const {
        const ReflectionPair p(wo, wi);
        if (!p.valid) return {};
        const Coat& coat = coats_.nearest(around);
        return value(p, coat, coat.passing(p.o.z));
    }
    /// The part of f that is the base's.
    [[nodiscard]] Rgb baseValue(const Vec3& wo, const Vec3& wi, float around) const {
        const ReflectionPair p(wo, wi);
        if (!p.valid) return Rgb(0.0f);
        const Coat& coat = coats_.nearest(around);
        return color_ * coat.base(p, coat.passing(p.o.z));
    }
    [[nodiscard]] BsdfSample sample(const Vec3& wo, const Vec3& u, float around) const {
        const DVec3 o = unitOnSide(wo, wo.z);
        if (o.z < kMinCosine) return {};
        const Coat& coat = coats_.nearest(around);
        const double passes = coat.passing(o.z);
        Vec3 wi = u.z < coatShare(passes)
                      ? toFloat(reflectAbout(o, ggx_.reflectingNormal(o, DVec2(u.x, u.y))))
                      : cosineHemisphere({u.x, u.y});
        if (wi.z <= 0) return {};
        if (wo.z < 0) wi.z = -wi.z;
        const ReflectionPair p(wo, wi);
        if (!p.valid) return {};
        return {wi, value(p, coat, passes)};
    }
    [[nodiscard]] Gloss gloss() const {
        return {ggx_.alpha(), std::min(1.0f, 3 * fresnelDielectric(std::sqrt(0.5f), 1 / ior_))};
    }
    /// The mirror of the polished coat that it is near to (classic).
    [[nodiscard]] int perfectBranches(const Vec3& wo, float around, DeltaBranch* out) const {
        const float reflectance = fresnelDielectric(std::abs(wo.z), around / ior_);
        out[0] = {mirrored(wo), Rgb(reflectance)};
        return reflectance > 0 ? 1 : 0;
    }

  private:
    struct Coat {
        double eta;           ///< index around over the coat's
        CoatPassing passing;  ///< the share that enters the coat, or leaves it from within
        Coat(float alpha, float ratio) : eta(ratio), passing(alpha, ratio) {}
        [[nodiscard]] float base(const ReflectionPair& p, double passes) const {
            return static_cast<float>(passes * passing(p.i.z) / (kPi * passing.average()));
        }
    };

    /// `passes`: what passes the coat along p.o.
    [[nodiscard]] BsdfValue value(const ReflectionPair& p, const Coat& coat, double passes) const {
        const double mirror =
            ggx_.d(p.h) * ggx_.visibility(p.o, p.i) * fresnelTerm(p.cosHalf, coat.eta).reflectance;
        const double share = coatShare(passes);
        return {color_ * coat.base(p, passes) + Rgb(static_cast<float>(mirror)),
                static_cast<float>(share * ggx_.reflectionPdf(p.o, p.h) +
                                   (1 - share) * p.i.z * (1 / kPi))};
    }
    /// How often the coat is sampled: as much as it reflects. The floor keeps a density wherever
    /// the coat has a value.
    [[nodiscard]] double coatShare(double passes) const {
        const double mirror = std::max(1e-3, 1 - passes);
        return mirror / (mirror + passes * maxComponent(color_));
    }

    Rgb color_;
    float ior_;
    Ggx ggx_;
    ByIndex<Coat> coats_;  ///< by the index around
    float entering_;       ///< average of what passes in the first of them
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
            builder.add(PolishedGlossyBsdf(base, n, builder.surroundings()), weight);
        else
            builder.add(GlossyBsdf(base, n, alpha, builder.surroundings()), weight);
    }
};

}  // namespace glint
