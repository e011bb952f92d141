// Glass: a dielectric, smooth or rough, with absorption inside, or a thin sheet of it.
#pragma once

#include "tracer/base/reflect.h"
#include "tracer/materials/bsdf.h"
#include "tracer/materials/rough_glass.h"
#include "tracer/scene/ids.h"

namespace glint {

/// A smooth boundary between two media.
struct GlassBsdf {
    static constexpr bool kSmooth = false, kDelta = true;

    [[nodiscard]] int branches(const Vec3& wo, float eta, DeltaBranch* out) const {
        return smoothDielectricBranches(wo, eta, out);
    }
};

struct Glass {
    Textured<double> ior{1.5};
    Textured<Color> absorption{Color{0, 0, 0}};
    Textured<double> roughness{0.0};
    bool thin = false;
    int priority = 0;

    bool operator==(const Glass&) const = default;
    static constexpr std::string_view kind = "glass";
    static constexpr auto fields() {
        return std::tuple{
            Field{"ior",
                  &Glass::ior,
                  {.min = 0, .max = 100, .exclusiveMin = true, .doc = "Refractive index"}},
            Field{"absorption",
                  &Glass::absorption,
                  {.min = 0,
                   .unit = "1/m",
                   .doc = "Inside, light fades by exp(-absorption * distance)"}},
            Field{"roughness",
                  &Glass::roughness,
                  {.min = 0, .max = 1, .doc = "0 polished, 1 matt; alpha is its square"}},
            Field{"thin", &Glass::thin, {.doc = "A sheet: no offset and no absorption"}},
            Field{"priority",
                  &Glass::priority,
                  {.min = -1000,
                   .max = 1000,
                   .doc = "Where dielectrics overlap, the higher one fills"}}};
    }
    template <class Builder>
    void compile(Builder& builder, const Rgb& weight) const {
        const float n = builder.value(ior), alpha = alphaFromRoughness(builder.value(roughness));
        const bool smooth = alpha < kMinAlpha;
        if (thin) {
            if (smooth)
                builder.add(ThinGlassBsdf{n}, weight);
            else
                builder.add(RoughThinGlassBsdf(n, alpha, builder.surroundings()), weight);
            return;
        }
        builder.setMedium(n, builder.color(absorption), priority);
        if (smooth)
            builder.add(GlassBsdf{}, weight);
        else
            builder.add(RoughGlassBsdf(alpha, builder.ratiosTo(n)), weight);
    }
};

}  // namespace glint
