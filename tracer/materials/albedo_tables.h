// What single scattering between microfacets loses, and what a rough coat reflects: tables by
// viewing angle, alpha and refractive index, from which the leaves give the lost light back (Kulla
// and Conty, "Revisiting physically based shading at Imageworks", SIGGRAPH 2017 course). Built by
// quadrature when first asked for, the same on every run and thread.
#pragma once

#include <algorithm>
#include <array>

#include "tracer/materials/microfacet.h"

namespace glint {

/// Nodes along the cosine; the last float of a row is the cosine-weighted average over the
/// hemisphere.
inline constexpr int kCosineNodes = 41;
inline constexpr int kRowSize = kCosineNodes + 1;

/// Place of a cosine on the axis of the tables, 0..1. A third of the nodes resolves cosines near
/// alpha, where Smith's losses peak, with the same spacing relative to alpha however small it is; a
/// third is even in the cosine; the last one lies between.
[[nodiscard]] inline double cosineCoordinate(double cosine, double alpha) {
    const double near = alpha * 0.2, between = std::sqrt(alpha) * 0.5;
    return (1.0 / 3) * (cosine * (1 + near) / (cosine + near) +
                        cosine * (1 + between) / (cosine + between) + cosine);
}

/// Cubic Lagrange weights of the nodes -1, 0, 1, 2 at place f.
[[nodiscard]] inline std::array<double, 4> cubicWeights(double f) {
    const double a = f + 1, b = f, c = f - 1, d = f - 2;
    return {-b * c * d / 6, a * c * d / 2, -a * b * d / 2, a * b * c / 6};
}

/// A function of the cosine at one alpha (and one index): a blend of neighbouring rows, cubic along
/// the cosine. Valid as long as the tables, that is for the life of the program.
template <int Rows>
class CosineCurve {
  public:
    CosineCurve() = default;
    CosineCurve(double alpha, const std::array<const float*, Rows>& rows,
                const std::array<float, Rows>& weights)
        : alpha_(alpha), rows_(rows), weights_(weights) {
        for (int r = 0; r < Rows; ++r) average_ += weight(r) * row(r)[kCosineNodes];
    }
    /// cosine in [0, 1].
    [[nodiscard]] double operator()(double cosine) const {
        const double x = cosineCoordinate(cosine, alpha_) * (kCosineNodes - 1);
        const int first = std::clamp(static_cast<int>(x) - 1, 0, kCosineNodes - 4);
        const std::array<double, 4> w = cubicWeights(x - first - 1);
        double sum = 0;
        for (int r = 0; r < Rows; ++r) {
            const float* p = row(r) + first;
            sum += weight(r) * (w[0] * p[0] + w[1] * p[1] + w[2] * p[2] + w[3] * p[3]);
        }
        return sum;
    }
    /// 2 * integral of f(cosine) * cosine over the cosine.
    [[nodiscard]] double average() const { return average_; }

  private:
    [[nodiscard]] const float* row(int r) const { return rows_[static_cast<std::size_t>(r)]; }
    [[nodiscard]] double weight(int r) const { return weights_[static_cast<std::size_t>(r)]; }

    double alpha_ = 1, average_ = 0;
    std::array<const float*, Rows> rows_{};
    std::array<float, Rows> weights_{};
};

using MetalCurve = CosineCurve<4>;

/// Bounds the noise of the metal's average loss: added where it divides, so that noise is never
/// blown up (it matters below alpha 0.01 at grazing angles only).
inline constexpr double kLossNoise = 2e-6;

/// 1 - E of a lossless rough dielectric: the metal's loss (from the thin side, times Fresnel's
/// reflectance) and a tabled residual, less a margin for the tables' error, so that what is given
/// back never exceeds what was lost.
class DielectricLoss {
  public:
    DielectricLoss(double eta, const MetalCurve& metal, const CosineCurve<4>& residual)
        : eta_(eta), metal_(metal), residual_(residual) {}
    [[nodiscard]] double operator()(double cosine) const {
        const double share = eta_ < 1 ? fresnelTerm(cosine, eta_).reflectance : 1;
        return kKept * std::max(0.0, share * metal_(cosine) + residual_(cosine));
    }
    [[nodiscard]] double average() const {
        return kKept * (std::max(0.0, residual_.average()) + kNoise);
    }

  private:
    static constexpr double kKept = 0.98;
    /// Bounds the tables' noise, which must not be divided by a smaller average (alpha < 0.02).
    static constexpr double kNoise = 5e-5;
    double eta_;
    MetalCurve metal_;
    CosineCurve<4> residual_;
};

/// What a rough coat lets through, 1 - E, E its albedo by reflection once.
class CoatPassing {
  public:
    CoatPassing(double ior, const MetalCurve& metal, const CosineCurve<4>& residual);
    [[nodiscard]] double operator()(double cosine) const {
        const double reflectance = fresnelTerm(cosine, eta_).reflectance;
        return std::max(0.0, 1 - reflectance * (1 - metal_(cosine)) + residual_(cosine));
    }
    [[nodiscard]] double average() const { return average_; }

  private:
    double eta_, average_ = 0;
    MetalCurve metal_;
    CosineCurve<4> residual_;
};

/// 1 - E: the share of light lost by single scattering at a microsurface that reflects everything.
/// alpha in [0, 1].
[[nodiscard]] MetalCurve metalLoss(double alpha);

/// The same for a lossless dielectric (reflection and transmission together), light coming from the
/// side whose index over the other side's is `eta` > 0.
[[nodiscard]] DielectricLoss dielectricLoss(double alpha, double eta);

/// 1 - E of a coat of index `ior` >= 1, light coming from outside.
[[nodiscard]] CoatPassing coatPassing(double alpha, double ior);

/// Fresnel's reflectance averaged over the hemisphere, from the side whose index over the other's
/// is `eta`. To 1e-6.
[[nodiscard]] double averageFresnel(double eta);

}  // namespace glint
