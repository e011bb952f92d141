// Phong: the material of the original report. f = color * diffuse / pi + specular * (n+2) / (2 pi)
// * cos^n, a mirror ray and a refracted ray, without Fresnel's law. If the shares sum to more than
// 1, all are divided by the sum.
#pragma once

#include "tracer/base/reflect.h"
#include "tracer/materials/diffuse.h"
#include "tracer/materials/mirror.h"
#include "tracer/scene/ids.h"

namespace glint {

/// The highlight: f = (n+2)/(2 pi) cos^n(alpha), alpha from the mirrored direction. Its albedo is 1
/// at normal incidence and less elsewhere (Lafortune and Willems, "Using the modified Phong
/// reflectance model", 1994).
struct PhongBsdf {
    static constexpr bool kSmooth = true, kDelta = false;
    float exponent;

    [[nodiscard]] Rgb albedo() const { return Rgb(1.0f); }
    [[nodiscard]] BsdfValue value(const Vec3& wo, const Vec3& wi, float) const {
        const float power = lobe(wo, wi) / (2 * kPiF);
        return {sameSide(wo, wi) ? Rgb((exponent + 2) * power) : Rgb(0.0f), (exponent + 1) * power};
    }
    /// cos^n falls off as GGX of this alpha.
    [[nodiscard]] Gloss gloss() const {
        return {std::sqrt(2.0 / (static_cast<double>(exponent) + 2)), 1};
    }
    [[nodiscard]] BsdfSample sample(const Vec3& wo, const Vec3& u, float eta) const {
        const double cosine = std::pow(1.0 - static_cast<double>(u.x), 1.0 / (exponent + 1.0));
        const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine)), phi = 2 * kPi * u.y;
        const Vec3 wi =
            toFloat(Frame(toDouble(mirrored(wo)))
                        .toWorld(DVec3(sine * std::cos(phi), sine * std::sin(phi), cosine)));
        return {wi, value(wo, wi, eta)};
    }

  private:
    /// cos^n by way of 1 - cos = |r - wi|^2 / 2: a float cosine near 1 would be wrong by 6 % at an
    /// exponent of 1e6.
    [[nodiscard]] float lobe(const Vec3& wo, const Vec3& wi) const {
        const DVec3 chord = toDouble(mirrored(wo)) - toDouble(wi);
        const double oneMinusCosine = 0.5 * glm::dot(chord, chord);
        return oneMinusCosine < 1
                   ? static_cast<float>(std::exp(exponent * std::log1p(-oneMinusCosine)))
                   : 0.0f;
    }
};

/// The refracted ray without Fresnel's law; beyond the critical angle all is reflected.
struct RefractBsdf {
    static constexpr bool kSmooth = false, kDelta = true;

    [[nodiscard]] int branches(const Vec3& wo, float eta, DeltaBranch* out) const {
        Vec3 wi;
        const bool passes = refract(wo, eta, wi);
        out[0] = {passes ? wi : mirrored(wo), Rgb(1.0f)};
        return 1;
    }
};

struct Phong {
    Textured<Color> color{Color{0.8, 0.8, 0.8}};
    Textured<double> diffuse{0.7};
    Textured<double> specular{0.2};
    Textured<double> exponent{32.0};
    Textured<double> reflection{0.0};
    Textured<double> refraction{0.0};
    Textured<double> ior{1.5};
    Textured<Color> absorption{Color{0, 0, 0}};

    bool operator==(const Phong&) const = default;
    static constexpr std::string_view kind = "phong";
    static constexpr auto fields() {
        return std::tuple{
            Field{"color",
                  &Phong::color,
                  {.min = 0, .max = 1, .doc = "Tints the diffuse and the mirror part"}},
            Field{"diffuse",
                  &Phong::diffuse,
                  {.min = 0, .max = 1, .doc = "Share of Lambert's reflection"}},
            Field{"specular",
                  &Phong::specular,
                  {.min = 0, .max = 1, .doc = "Share of the highlight"}},
            Field{"exponent",
                  &Phong::exponent,
                  {.min = 0, .max = 1e6, .doc = "Sharpness of the highlight"}},
            Field{"reflection",
                  &Phong::reflection,
                  {.min = 0, .max = 1, .doc = "Share of the mirror ray"}},
            Field{"refraction",
                  &Phong::refraction,
                  {.min = 0, .max = 1, .doc = "Share of the refracted ray"}},
            Field{"ior",
                  &Phong::ior,
                  {.min = 0,
                   .max = 100,
                   .exclusiveMin = true,
                   .doc = "Refractive index of the inside"}},
            Field{"absorption",
                  &Phong::absorption,
                  {.min = 0,
                   .unit = "1/m",
                   .doc = "Inside, light fades by exp(-absorption * distance)"}}};
    }
    template <class Builder>
    void compile(Builder& builder, const Rgb& weight) const {
        const float kd = builder.value(diffuse), ks = builder.value(specular);
        const float kr = builder.value(reflection), kt = builder.value(refraction);
        const Rgb scaled = weight / std::max(1.0f, kd + ks + kr + kt), tint = builder.value(color);
        if (kd > 0) builder.add(LambertBsdf{tint}, scaled * kd);
        if (ks > 0) builder.add(PhongBsdf{builder.value(exponent)}, scaled * ks);
        if (kr > 0) builder.add(MirrorBsdf{tint}, scaled * kr);
        if (kt > 0) {
            builder.setMedium(builder.value(ior), builder.color(absorption), 0);
            builder.add(RefractBsdf{}, scaled * kt);
        }
    }
};

}  // namespace glint
