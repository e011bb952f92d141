// What single scattering between microfacets loses, and what a rough coat reflects, by viewing
// angle: curves from which the leaves give the lost light back (Kulla and Conty, "Revisiting
// physically based shading at Imageworks", SIGGRAPH 2017 course). Each is computed by quadrature
// for its own alpha and index when a leaf is made, and shared by all leaves that ask for the same.
#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <memory>

#include "tracer/materials/microfacet.h"

namespace glint {

/// Places cosines in [0, 1] on an axis where the curves of one alpha and index are nearly even: a
/// part of the axis resolves cosines near alpha, where Smith's losses peak, with the same spacing
/// relative to alpha however small it is; a part is even in the angle near the normal, where long
/// tails of the lobe make (1 - cosine)^1.5; one lies between; and where total reflection begins,
/// one is even in the logarithm of the distance from that cosine.
class CosineAxis {
  public:
    /// eta as for leaves; at most 1 where there is no total reflection.
    CosineAxis(double alpha, double eta);
    /// Monotone, 0 at 0 and 1 at 1.
    [[nodiscard]] double operator()(double cosine) const {
        double sum = 1 - std::sqrt(std::max(0.0, 1 - cosine));
        for (const double width : {near_, between_}) sum += cosine * (1 + width) / (cosine + width);
        if (width_ > 0) sum += (turn(cosine) - turnStart_) * turnScale_;
        return sum * scale_;
    }

  private:
    [[nodiscard]] double turn(double cosine) const {
        return std::asinh((cosine - critical_) / width_);
    }

    double near_, between_, critical_ = 0, width_ = 0, turnStart_ = 0, turnScale_ = 0, scale_;
};

/// A function of the cosine in [0, 1]: cubic between nodes that are even on a CosineAxis.
class CosineCurve {
  public:
    static constexpr int kNodes = 80;

    CosineCurve(const CosineAxis& axis, const std::function<double(double)>& value);
    [[nodiscard]] double operator()(double cosine) const {
        const double x = axis_(cosine) * (kNodes - 1);
        const int first = std::clamp(static_cast<int>(x) - 1, 0, kNodes - 4);
        const double* p = nodes_.data() + first;
        // Lagrange's polynomial through the four nodes at -1, 0, 1, 2.
        const double b = x - first - 1, a = b + 1, c = b - 1, d = b - 2;
        return (c * d * (3 * a * p[1] - b * p[0]) + a * b * (c * p[3] - 3 * d * p[2])) * (1.0 / 6);
    }
    /// 2 * integral of value(cosine) * cosine, for a function as smooth between the nodes as the
    /// curve.
    [[nodiscard]] double average(const std::function<double(double)>& value) const;

  private:
    CosineAxis axis_;
    std::array<double, kNodes> cosines_, nodes_;
};

using SharedCurve = std::shared_ptr<const CosineCurve>;

/// 1 - E: the share of light lost by single scattering at a microsurface that reflects everything,
/// or at a lossless dielectric (reflection and transmission together). To 5e-5
/// (tests/numeric/albedo_curves_test.cpp).
class MicrosurfaceLoss {
  public:
    /// Everything is reflected. alpha in (0, 1].
    explicit MicrosurfaceLoss(double alpha) : MicrosurfaceLoss(alpha, 0) {}
    /// A dielectric; light comes from the side whose index over the other side's is `eta` > 0.
    MicrosurfaceLoss(double alpha, double eta);
    [[nodiscard]] double operator()(double cosine) const {
        return std::max(0.0, (*relative_)(cosine)) * scale(alpha_, cosine);
    }
    /// 2 * integral of it times the cosine; above 0.
    [[nodiscard]] double average() const { return average_; }

  private:
    /// How losses of narrow lobes fall off over many powers of ten: the curve over this keeps its
    /// digits.
    [[nodiscard]] static double scale(double alpha, double cosine) {
        return alpha * alpha / (alpha * alpha + cosine * cosine);
    }

    double alpha_;
    SharedCurve relative_;  ///< over scale()
    double average_;
};

/// What a rough coat lets through, 1 - E, E its albedo by reflection once, light coming from the
/// side whose index over the coat's is `eta`. To 5e-5.
class CoatPassing {
  public:
    CoatPassing(double alpha, double eta);
    [[nodiscard]] double operator()(double cosine) const {
        const double polished = eta_ < 1 ? 1 - fresnelTerm(cosine, eta_).reflectance : 0;
        return std::max(0.0, polished + (*rest_)(cosine));
    }
    [[nodiscard]] double average() const { return average_; }

  private:
    double eta_, average_ = 0;
    SharedCurve rest_;  ///< less what the polished coat lets through, where that is smooth
};

/// Fresnel's reflectance averaged over the hemisphere, from the side whose index over the other's
/// is `eta`. To 1e-6.
[[nodiscard]] double averageFresnel(double eta);

}  // namespace glint
