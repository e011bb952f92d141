// Metal: GGX with Schlick's Fresnel term, both sides.
#pragma once

#include "tracer/base/reflect.h"
#include "tracer/materials/albedo_curves.h"
#include "tracer/materials/bsdf.h"
#include "tracer/scene/ids.h"

namespace glint {

/// Polished metal: a mirror whose colour rises to white at grazing angles.
struct PolishedMetalBsdf {
    static constexpr bool kSmooth = false, kDelta = true;
    Rgb color;

    [[nodiscard]] int branches(const Vec3& wo, float, DeltaBranch* out) const {
        const float white = static_cast<float>(schlickWeight(std::abs(wo.z)));
        out[0] = {mirrored(wo), color + (Rgb(1.0f) - color) * white};
        return 1;
    }
};

/// f = D G2 F / (4 cos cos) plus what bounces more than once between microfacets, (1-E)(1-E)/(pi
/// (1-E_avg)) coloured by F_avg^2 E_avg / (1 - F_avg (1-E_avg)) (Kulla and Conty, SIGGRAPH 2017
/// course): reciprocal, and white stays white.
class MetalBsdf {
  public:
    static constexpr bool kSmooth = true, kDelta = false;

    /// alpha in [kMinAlpha, 1].
    MetalBsdf(const Rgb& color, float alpha)
        : color_(color), ggx_(alpha), multipleLobe_(alpha), loss_(alpha) {
        const float lost = static_cast<float>(loss_.average());
        average_ = color + (Rgb(1.0f) - color) / 21.0f;
        multiple_ = average_ * average_ * (1 - lost) / (Rgb(1.0f) - average_ * lost);
        multipleScale_ = 1 / (kPi * loss_.average());
    }
    [[nodiscard]] Rgb albedo() const {
        const float lost = static_cast<float>(loss_.average());
        return average_ * (1 - lost) + multiple_ * lost;
    }
    [[nodiscard]] BsdfValue value(const Vec3& wo, const Vec3& wi, float) const {
        const ReflectionPair p(wo, wi);
        return p.valid ? value(p, loss_(p.o.z)) : BsdfValue{};
    }
    [[nodiscard]] BsdfSample sample(const Vec3& wo, const Vec3& u, float) const {
        const DVec3 o = unitOnSide(wo, wo.z);
        if (o.z < kMinCosine) return {};
        const DVec2 place(u.x, u.y);
        const double lost = loss_(o.z);
        Vec3 wi =
            toFloat(u.z < multipleShare(lost) ? multipleLobe_.sample(place)
                                              : reflectAbout(o, ggx_.reflectingNormal(o, place)));
        if (wi.z <= 0) return {};
        if (wo.z < 0) wi.z = -wi.z;
        const ReflectionPair p(wo, wi);
        if (!p.valid) return {};
        return {wi, value(p, lost)};
    }
    [[nodiscard]] Gloss gloss() const { return {ggx_.alpha(), 1}; }
    /// The polished metal that it is near to (classic).
    [[nodiscard]] int perfectBranches(const Vec3& wo, float eta, DeltaBranch* out) const {
        return PolishedMetalBsdf{color_}.branches(wo, eta, out);
    }

  private:
    /// `lost`: what is lost along p.o.
    [[nodiscard]] BsdfValue value(const ReflectionPair& p, double lost) const {
        const float single = static_cast<float>(ggx_.d(p.h) * ggx_.visibility(p.o, p.i));
        const float white = static_cast<float>(schlickWeight(p.cosHalf));
        const float multiple = static_cast<float>(lost * loss_(p.i.z) * multipleScale_);
        const double share = multipleShare(lost);
        return {(color_ + (Rgb(1.0f) - color_) * white) * single + multiple_ * multiple,
                static_cast<float>((1 - share) * ggx_.reflectionPdf(p.o, p.h) +
                                   share * multipleLobe_.pdf(p.i.z))};
    }
    /// How often the second term is sampled.
    [[nodiscard]] double multipleShare(double lost) const {
        const double multiple = lost * maxComponent(multiple_);
        return multiple / (multiple + (1 - lost) * maxComponent(average_));
    }

    Rgb color_, average_{0.0f}, multiple_{0.0f};
    Ggx ggx_;
    MultipleLobe multipleLobe_;
    MicrosurfaceLoss loss_;
    double multipleScale_ = 0;
};

struct Metal {
    Textured<Color> color{Color{0.9, 0.9, 0.9}};
    Textured<double> roughness{0.2};

    bool operator==(const Metal&) const = default;
    static constexpr std::string_view kind = "metal";
    static constexpr auto fields() {
        return std::tuple{
            Field{"color",
                  &Metal::color,
                  {.min = 0, .max = 1, .doc = "Reflectance at normal incidence"}},
            Field{"roughness",
                  &Metal::roughness,
                  {.min = 0, .max = 1, .doc = "0 polished, 1 matt; alpha is its square"}}};
    }
    template <class Builder>
    void compile(Builder& builder, const Rgb& weight) const {
        const Rgb tint = builder.value(color);
        const float alpha = alphaFromRoughness(builder.value(roughness));
        if (alpha < kMinAlpha)
            builder.add(PolishedMetalBsdf{tint}, weight);
        else
            builder.add(MetalBsdf(tint, alpha), weight);
    }
};

}  // namespace glint
