#include "tracer/materials/albedo_curves.h"

#include <map>
#include <mutex>
#include <tuple>
#include <vector>

#include "tracer/math/quadrature.h"

namespace glint {
namespace {

/// What becomes of light by single scattering at a microsurface, seen from one direction. The rest
/// is transmitted.
struct Shares {
    double reflected = 0, lost = 0;
};

/// A short list of places where a function is not smooth, within an interval.
class Pieces {
  public:
    Pieces(double from, double to) : from_(from), to_(to) { at_[0] = from; }
    void splitAt(double place) {
        if (place > from_ && place < to_) at_[static_cast<std::size_t>(count_++)] = place;
    }
    /// Calls use(place, weight) for the nodes of Gauss's rule on each piece, mapped so that square
    /// roots at its ends are smooth.
    template <class Use>
    void integrate(const Use& use) {
        static const std::vector<QuadratureNode> nodes = gaussLegendre(kNodes);
        std::sort(at_.begin(), at_.begin() + count_);
        at_[static_cast<std::size_t>(count_)] = to_;
        for (std::size_t k = 0; k < static_cast<std::size_t>(count_); ++k) {
            const double size = at_[k + 1] - at_[k];
            if (!(size > 0)) continue;
            for (const QuadratureNode& node : nodes)
                use(at_[k] + size * node.x * node.x * (3 - 2 * node.x),
                    size * 6 * node.x * (1 - node.x) * node.weight);
        }
    }

  private:
    static constexpr int kNodes = 9, kMost = 14;
    double from_, to_;
    std::array<double, kMost> at_{};
    int count_ = 1;
};

/// Integrates over the slopes of the microfacets, (r cos phi, r sin phi) with the viewer in the
/// plane of phi = 0. There every border between smooth pieces has a closed form: directions
/// reflected into the horizon belong to slopes on a circle, so do those refracted into it, total
/// reflection begins on a conic, and facets seen edge-on lie on a line.
class Microsurface {
  public:
    /// Seen from the cosine; eta as for leaves, 0 for one that reflects everything.
    Microsurface(double cosine, double alpha, double eta)
        : ggx_(alpha),
          alpha_(alpha),
          eta_(eta),
          sine_(std::sqrt(std::max(0.0, 1 - cosine * cosine))),
          cosine_(cosine),
          o_(sine_, 0, cosine) {}

    [[nodiscard]] Shares integrate() const {
        // r = alpha tan psi, whose density is sin 2 psi.
        Pieces pieces(0, kPi / 2);
        const auto split = [&](double r) { pieces.splitAt(std::atan(std::abs(r) / alpha_)); };
        split((1 - sine_) / cosine_);
        split((1 + sine_) / cosine_);
        split(cosine_ / sine_);
        // Smooth, but steep from here to there: behind the line of facets seen edge-on, and around
        // slopes of 1.
        for (const double steep : {4 * cosine_ / sine_, 16 * cosine_ / sine_, 0.25, 1.0, 4.0})
            split(steep);
        if (eta_ > 1) {
            split((sine_ - 1 / eta_) / cosine_);
            split((sine_ + 1 / eta_) / cosine_);
            const double critical = std::asin(1 / eta_), theta = std::atan2(sine_, cosine_);
            split(std::tan(theta - critical));
            split(std::tan(theta + critical));
        }
        Shares sum;
        pieces.integrate([&](double psi, double weight) {
            addCircle(sum, alpha_ * std::tan(psi), weight * std::sin(2 * psi));
        });
        const double visible = 2 * cosine_ / (ggx_.slant(o_) + cosine_) / kPi;
        return {visible * sum.reflected, visible * sum.lost};
    }

  private:
    /// Slopes of length r, from both halves.
    void addCircle(Shares& sum, double r, double weight) const {
        Pieces pieces(0, kPi);
        const auto split = [&](double cosPhi) {
            if (std::abs(cosPhi) < 1) pieces.splitAt(std::acos(cosPhi));
        };
        const double across = 2 * r * sine_ * cosine_,
                     base = r * r * cosine_ * cosine_ + sine_ * sine_;
        split((base - 1) / across);
        split(-cosine_ / (r * sine_));
        if (eta_ > 1) {
            split((base - 1 / (eta_ * eta_)) / across);
            split((std::sqrt((1 - 1 / (eta_ * eta_)) * (1 + r * r)) - cosine_) / (r * sine_));
        }
        pieces.integrate([&](double phi, double share) {
            addFacet(sum, {r * std::cos(phi), r * std::sin(phi), 1}, weight * share);
        });
    }
    void addFacet(Shares& sum, const DVec3& slope, double weight) const {
        const double faces = 1 + slope.x * sine_ / cosine_;
        if (faces <= 0) return;
        const DVec3 h = glm::normalize(slope);
        const double c = glm::dot(o_, h);
        const FresnelTerm fresnel = eta_ > 0 ? fresnelTerm(c, eta_) : FresnelTerm{};
        double reflected = 0, transmitted = 0;
        if (const DVec3 i = reflectAbout(o_, h); i.z > 0)
            reflected = fresnel.reflectance * ggx_.shadowing(o_, i);
        if (fresnel.cosTransmitted > 0)
            if (const DVec3 t = (eta_ * c - fresnel.cosTransmitted) * h - eta_ * o_; t.z < 0)
                transmitted = (1 - fresnel.reflectance) * ggx_.shadowing(o_, t);
        sum.reflected += weight * faces * reflected;
        sum.lost +=
            weight * faces * (1 - reflected - transmitted);  // Small losses keep their digits.
    }

    Ggx ggx_;
    double alpha_, eta_, sine_, cosine_;
    DVec3 o_;
};

enum class CurveKind { Loss, Coat };

/// The curve made before, as long as some leaf still holds it.
SharedCurve sharedCurve(CurveKind kind, double alpha, double eta,
                        const std::function<CosineCurve()>& make) {
    static std::mutex mutex;
    static std::map<std::tuple<CurveKind, double, double>, std::weak_ptr<const CosineCurve>> known;
    const std::tuple key{kind, alpha, eta};
    {
        const std::lock_guard lock(mutex);
        if (const auto found = known.find(key); found != known.end())
            if (SharedCurve curve = found->second.lock()) return curve;
    }
    auto curve = std::make_shared<const CosineCurve>(make());
    const std::lock_guard lock(mutex);
    std::erase_if(known, [](const auto& entry) { return entry.second.expired(); });
    known[key] = curve;
    return curve;
}

}  // namespace

CosineAxis::CosineAxis(double alpha, double eta)
    : near_(alpha * 0.2), between_(std::sqrt(alpha) * 0.5), scale_(1.0 / 3) {
    if (eta <= 1) return;
    critical_ = std::sqrt(1 - 1 / (eta * eta));
    width_ = alpha;
    turnStart_ = turn(0);
    turnScale_ = 1 / (turn(1) - turnStart_);
    scale_ = 0.25;
}

CosineCurve::CosineCurve(const CosineAxis& axis, const std::function<double(double)>& value)
    : axis_(axis) {
    for (std::size_t i = 0; i < kNodes; ++i) {
        // The axis has no inverse in closed form: bisection.
        double low = 0, high = 1;
        for (int step = 0; step < 50; ++step) {
            const double middle = 0.5 * (low + high);
            (axis(middle) * (kNodes - 1) < static_cast<double>(i) ? low : high) = middle;
        }
        // At the horizon itself the quotients are 0/0: the limit is next to it.
        cosines_[i] = 0.5 * (low + high);
        nodes_[i] = value(std::max(kMinCosine, cosines_[i]));
    }
}

double CosineCurve::average(const std::function<double(double)>& value) const {
    static const std::vector<QuadratureNode> nodes = gaussLegendre(4);
    double sum = 0;
    for (std::size_t i = 0; i + 1 < kNodes; ++i)
        for (const QuadratureNode& node : nodes) {
            const double size = cosines_[i + 1] - cosines_[i], cosine = cosines_[i] + size * node.x;
            sum += 2 * size * node.weight * cosine * value(cosine);
        }
    return sum;
}

MicrosurfaceLoss::MicrosurfaceLoss(double alpha, double eta)
    : alpha_(alpha),
      relative_(sharedCurve(CurveKind::Loss, alpha, eta,
                            [&] {
                                return CosineCurve(CosineAxis(alpha, eta), [&](double cosine) {
                                    return Microsurface(cosine, alpha, eta).integrate().lost /
                                           scale(alpha, cosine);
                                });
                            })),
      average_(relative_->average(*this)) {}

CoatPassing::CoatPassing(double alpha, double eta) : eta_(eta) {
    const auto polished = [eta](double cosine) {
        return eta < 1 ? 1 - fresnelTerm(cosine, eta).reflectance : 0;
    };
    rest_ = sharedCurve(CurveKind::Coat, alpha, eta, [&] {
        return CosineCurve(CosineAxis(alpha, eta), [&](double cosine) {
            return 1 - Microsurface(cosine, alpha, eta).integrate().reflected - polished(cosine);
        });
    });
    average_ = (eta < 1 ? 1 - averageFresnel(eta) : 0) + rest_->average(*rest_);
}

double averageFresnel(double eta) {
    static const std::vector<QuadratureNode> nodes = gaussLegendre(64);
    const double thinEta = std::min(eta, 1 / eta);
    double thin = 0;
    for (const QuadratureNode& node : nodes)
        thin += 2 * node.weight * node.x * fresnelTerm(node.x, thinEta).reflectance;
    // The dense side's average follows from reciprocity: n^2 (1 - F) is equal on both sides.
    return eta > 1 ? 1 - (1 - thin) / (eta * eta) : thin;
}

}  // namespace glint
