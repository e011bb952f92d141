// Diffuse: Lambert's reflection, both sides.
#pragma once

#include "tracer/base/reflect.h"
#include "tracer/materials/bsdf.h"
#include "tracer/scene/ids.h"

namespace glint {

/// f = color / pi.
struct LambertBsdf {
    static constexpr bool kSmooth = true, kDelta = false;
    Rgb color;

    [[nodiscard]] Rgb albedo() const { return color; }
    [[nodiscard]] BsdfValue value(const Vec3& wo, const Vec3& wi, float) const {
        if (!sameSide(wo, wi)) return {};
        return {color * (1 / kPiF), std::abs(wi.z) * (1 / kPiF)};
    }
    [[nodiscard]] BsdfSample sample(const Vec3& wo, const Vec3& u, float) const {
        const Vec3 wi = cosineOnSideOf(wo, {u.x, u.y});
        return {wi, {color * (1 / kPiF), std::abs(wi.z) * (1 / kPiF)}};
    }
};

struct Diffuse {
    Textured<Color> color{Color{0.8, 0.8, 0.8}};

    bool operator==(const Diffuse&) const = default;
    static constexpr std::string_view kind = "diffuse";
    static constexpr auto fields() {
        return std::tuple{Field{
            "color", &Diffuse::color, {.min = 0, .max = 1, .doc = "Share of light reflected"}}};
    }
    template <class Builder>
    void compile(Builder& builder, const Rgb& weight) const {
        builder.add(LambertBsdf{builder.value(color)}, weight);
    }
};

}  // namespace glint
