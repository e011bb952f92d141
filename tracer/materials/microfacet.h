// The GGX distribution of microfacets with Smith's height-correlated shadowing: the mathematics
// that metal, rough glass and glossy share. Not a leaf itself. Everything is in doubles and on the
// side z > 0; leaves mirror their directions there.
//
// Sources: Walter et al., "Microfacet models for refraction through rough surfaces", EGSR 2007;
// Heitz, "Understanding the masking-shadowing function", JCGT 3(2), 2014; Dupuy and Benyoub,
// "Sampling visible GGX normals with spherical caps", HPG 2023; Tokuyoshi and Eto, "Bounded VNDF
// sampling for the Smith-GGX BRDF", I3D 2024.
#pragma once

#include <algorithm>

#include "tracer/math/types.h"

namespace glint {

/// Below this alpha (roughness 0.01) a lobe is narrower than float directions resolve well: leaves
/// are delta there.
inline constexpr float kMinAlpha = 1e-4f;

/// Directions closer to the horizon (cosine) carry no light: keeps every quotient of the model
/// within float's range.
inline constexpr double kMinCosine = 1e-7;

/// A float direction as a double one of unit length to 1e-14 (one step of Newton). At grazing
/// angles this brings back the bits of the long component, without which half vectors of narrow
/// lobes are wrong by a tenth of alpha.
[[nodiscard]] inline DVec3 unitDirection(const Vec3& w) {
    const DVec3 d = toDouble(w);
    return d * (1.5 - 0.5 * glm::dot(d, d));
}

/// As unitDirection, mirrored to the side z > 0 if `side` < 0.
[[nodiscard]] inline DVec3 unitOnSide(const Vec3& w, float side) {
    DVec3 d = unitDirection(w);
    if (side < 0) d.z = -d.z;
    return d;
}

/// Schlick's weight of white: F = f0 + (1 - f0) * schlickWeight(cosine).
[[nodiscard]] inline double schlickWeight(double cosine) {
    const double m = std::clamp(1 - cosine, 0.0, 1.0), m2 = m * m;
    return m2 * m2 * m;
}

class Ggx {
  public:
    explicit Ggx(double alpha) : alpha_(alpha), alpha2_(alpha * alpha) {}
    [[nodiscard]] double alpha() const { return alpha_; }

    /// Density of normals; integral of D * h.z over the hemisphere is 1. The form in h.xy has no
    /// cancellation.
    [[nodiscard]] double d(const DVec3& h) const {
        const double q = h.x * h.x + h.y * h.y + alpha2_ * h.z * h.z;
        return alpha2_ / (kPi * q * q);
    }
    /// |z| * sqrt(1 + alpha^2 tan^2 theta): Smith's terms follow from it without a division by z.
    [[nodiscard]] double slant(const DVec3& w) const {
        return std::sqrt(alpha2_ * (w.x * w.x + w.y * w.y) + w.z * w.z);
    }
    /// Share seen from both directions, heights correlated, divided by 4 |o.z i.z|. The cosines are
    /// absolute values, so that it serves transmission too.
    [[nodiscard]] double visibility(const DVec3& o, const DVec3& i) const {
        return 0.5 / (slant(o) * std::abs(i.z) + slant(i) * std::abs(o.z));
    }
    /// G2(o, i) / G1(o): the share of a visible normal's light that is not shadowed on its way out.
    [[nodiscard]] double shadowing(const DVec3& o, const DVec3& i) const {
        const double so = slant(o), zo = std::abs(o.z), zi = std::abs(i.z);
        return zi * (so + zo) / (so * zi + slant(i) * zo);
    }

    /// A normal visible from o, distributed as D * G1(o) * (o . h) / o.z. u in [0, 1)^2.
    [[nodiscard]] DVec3 visibleNormal(const DVec3& o, const DVec2& u) const {
        const DVec3 standard = stretched(o);
        return sampleCap(standard, standard.z, u);
    }
    /// Density per solid angle of that normal.
    [[nodiscard]] double visibleNormalPdf(const DVec3& o, const DVec3& h) const {
        return 2 * d(h) * std::max(0.0, glm::dot(o, h)) / (slant(o) + o.z);
    }

    /// A normal for reflection: visible ones, less most of those that reflect below the horizon.
    [[nodiscard]] DVec3 reflectingNormal(const DVec3& o, const DVec2& u) const {
        const DVec3 standard = stretched(o);
        return sampleCap(standard, capBound(o) * standard.z, u);
    }
    /// Density per solid angle of the direction o reflected by that normal.
    [[nodiscard]] double reflectionPdf(const DVec3& o, const DVec3& h) const {
        return d(h) / (2 * (capBound(o) * o.z + slant(o)));
    }

  private:
    [[nodiscard]] DVec3 stretched(const DVec3& o) const {
        return DVec3(alpha_ * o.x, alpha_ * o.y, o.z) / slant(o);
    }
    /// k of Tokuyoshi and Eto: how far the cap reaches below the horizon, as a share of the
    /// unbounded one; alpha <= 1.
    [[nodiscard]] double capBound(const DVec3& o) const {
        const double s = 1 + std::sqrt(o.x * o.x + o.y * o.y), s2 = s * s;
        return (1 - alpha2_) * s2 / (s2 + alpha2_ * o.z * o.z);
    }
    /// The normal half way between `standard` and a uniform point of the cap z > -bound, stretched
    /// back.
    [[nodiscard]] DVec3 sampleCap(const DVec3& standard, double bound, const DVec2& u) const {
        const double z = (1 - u.y) * (1 + bound) - bound;
        const double r = std::sqrt(std::max(0.0, 1 - z * z));
        const float phi = static_cast<float>(2 * kPi * u.x);
        const DVec3 h{alpha_ * (standard.x + r * static_cast<double>(std::cos(phi))),
                      alpha_ * (standard.y + r * static_cast<double>(std::sin(phi))),
                      standard.z + z};
        const double length2 = glm::dot(h, h);
        return length2 > 0 ? h / std::sqrt(length2) : DVec3(0, 0, 1);
    }

    double alpha_, alpha2_;
};

/// Directions for light that bounced more than once: half of them by the cosine, half as the losses
/// of narrow lobes fall off, by cosine / (alpha^2 + cosine^2).
class MultipleLobe {
  public:
    explicit MultipleLobe(double alpha) : alpha2_(alpha * alpha), range_(std::log1p(1 / alpha2_)) {}
    /// A direction with z >= 0. u in [0, 1)^2.
    [[nodiscard]] DVec3 sample(const DVec2& u) const {
        const bool even = u.x < 0.5;
        const double v = even ? 2 * u.x : 2 * u.x - 1;
        const double cos2 = even ? 1 - v : std::min(1.0, alpha2_ * std::expm1(v * range_));
        const double sine = std::sqrt(1 - cos2), phi = 2 * kPi * u.y;
        return {sine * std::cos(phi), sine * std::sin(phi), std::sqrt(cos2)};
    }
    /// Its density per solid angle; cosine > 0.
    [[nodiscard]] double pdf(double cosine) const {
        return (0.5 / kPi) * cosine * (1 + 1 / (range_ * (cosine * cosine + alpha2_)));
    }

  private:
    double alpha2_, range_;
};

/// o mirrored about h.
[[nodiscard]] inline DVec3 reflectAbout(const DVec3& o, const DVec3& h) {
    return 2 * glm::dot(o, h) * h - o;
}

/// Two directions on one side, brought to z > 0, with the normal between them.
struct ReflectionPair {
    DVec3 o, i, h{0, 0, 1};
    double cosHalf = 0;  ///< o . h = i . h
    bool valid = false;  ///< false: on different sides, or at the horizon

    ReflectionPair(const Vec3& wo, const Vec3& wi)
        : o(unitOnSide(wo, wo.z)), i(unitOnSide(wi, wo.z)) {
        valid = o.z >= kMinCosine && i.z >= kMinCosine;
        if (!valid) return;
        const DVec3 sum = o + i;
        const double length = std::sqrt(glm::dot(sum, sum));
        h = sum / length;
        cosHalf = 0.5 * length;
    }
};

/// Fresnel's reflectance of a dielectric in doubles, with the cosine of the refracted direction (0:
/// total reflection).
struct FresnelTerm {
    double reflectance = 1, cosTransmitted = 0;
};
[[nodiscard]] inline FresnelTerm fresnelTerm(double cosine, double eta) {
    const double c = std::min(1.0, cosine), cos2 = 1 - eta * eta * (1 - c * c);
    if (cos2 <= 0) return {};
    const double ct = std::sqrt(cos2);
    const double parallel = (c - eta * ct) / (c + eta * ct),
                 perpendicular = (eta * c - ct) / (eta * c + ct);
    return {0.5 * (parallel * parallel + perpendicular * perpendicular), ct};
}

}  // namespace glint
