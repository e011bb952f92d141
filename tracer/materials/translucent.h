// Translucent: diffuse to both sides.
#pragma once

#include "tracer/base/reflect.h"
#include "tracer/materials/bsdf.h"
#include "tracer/scene/ids.h"

namespace glint {

/// f = reflectance / pi on wo's side, transmittance / pi on the other.
class TranslucentBsdf {
  public:
    static constexpr bool kSmooth = true, kDelta = false;

    TranslucentBsdf(const Rgb& reflectance, const Rgb& transmittance)
        : reflectance_(reflectance), transmittance_(transmittance) {
        const float r = maxComponent(reflectance), t = maxComponent(transmittance);
        pickReflection_ = r + t > 0 ? r / (r + t) : 1;
    }
    [[nodiscard]] Rgb albedo() const { return reflectance_ + transmittance_; }
    [[nodiscard]] BsdfValue value(const Vec3& wo, const Vec3& wi, float) const {
        const bool back = sameSide(wo, wi);
        return {(back ? reflectance_ : transmittance_) * (1 / kPiF),
                (back ? pickReflection_ : 1 - pickReflection_) * std::abs(wi.z) * (1 / kPiF)};
    }
    [[nodiscard]] BsdfSample sample(const Vec3& wo, const Vec3& u, float eta) const {
        const Vec3 wi = cosineOnSideOf(u.z < pickReflection_ ? wo : -wo, {u.x, u.y});
        return {wi, value(wo, wi, eta)};
    }

  private:
    Rgb reflectance_, transmittance_;
    float pickReflection_;
};

struct Translucent {
    Textured<Color> reflectance{Color{0.4, 0.4, 0.4}};
    Textured<Color> transmittance{Color{0.4, 0.4, 0.4}};

    bool operator==(const Translucent&) const = default;
    static constexpr std::string_view kind = "translucent";
    static constexpr auto fields() {
        return std::tuple{
            Field{"reflectance",
                  &Translucent::reflectance,
                  {.min = 0, .max = 1, .doc = "Share sent back to the lit side"}},
            Field{"transmittance",
                  &Translucent::transmittance,
                  {.min = 0,
                   .max = 1,
                   .doc = "Share sent to the other side; with the reflectance at most 1"}}};
    }
    template <class Builder>
    void compile(Builder& builder, const Rgb& weight) const {
        builder.add(TranslucentBsdf(builder.value(reflectance), builder.value(transmittance)),
                    weight);
    }
};

}  // namespace glint
