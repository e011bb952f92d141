#include "tracer/render/pixel_filter.h"

#include <array>

#include "tracer/math/types.h"

namespace glint {

namespace {

/// Edges of strips of equal weight under the four-term Blackman-Harris window a0 + a1 cos(pi x) +
/// a2 cos(2 pi x) + a3 cos(3 pi x) (Harris, "On the use of windows", 1978) on [-1, 1].
class BlackmanHarris {
  public:
    static constexpr int kStrips = 4096;

    BlackmanHarris() {
        for (int i = 0; i <= kStrips; ++i)
            edge_[static_cast<std::size_t>(i)] = invert(static_cast<double>(i) / kStrips);
    }
    [[nodiscard]] double sample(double u) const {
        const double place = u * kStrips;
        const auto i = static_cast<std::size_t>(place);
        return edge_[i] + (place - static_cast<double>(i)) * (edge_[i + 1] - edge_[i]);
    }

  private:
    static double cumulative(double x) {
        constexpr double a0 = 0.35875, a1 = 0.48829, a2 = 0.14128, a3 = 0.01168;
        return 0.5 +
               (a0 * x + a1 / kPi * std::sin(kPi * x) + a2 / (2 * kPi) * std::sin(2 * kPi * x) +
                a3 / (3 * kPi) * std::sin(3 * kPi * x)) /
                   (2 * a0);
    }
    static double invert(double u) {
        double lo = -1, hi = 1;
        for (int step = 0; step < 60; ++step) {
            const double middle = 0.5 * (lo + hi);
            (cumulative(middle) > u ? hi : lo) = middle;
        }
        return 0.5 * (lo + hi);
    }

    std::array<double, kStrips + 1> edge_{};
};

}  // namespace

double sampleFilter(Filter filter, double u) {
    switch (filter) {
        case Filter::Box:
            return 2 * u - 1;
        case Filter::Tent:
            return u < 0.5 ? std::sqrt(2 * u) - 1 : 1 - std::sqrt(2 - 2 * u);
        case Filter::BlackmanHarris:
            break;
    }
    static const BlackmanHarris table;
    return table.sample(u);
}

}  // namespace glint
