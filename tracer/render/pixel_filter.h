// Reconstruction filters by importance sampling: a sample's place in its pixel is drawn from the filter, so that every sample
// counts the same and no sample writes to another pixel (Ernst et al., "Filter importance sampling", 2006).
#pragma once

#include <array>

#include "tracer/math/types.h"
#include "tracer/scene/scene.h"

namespace glint {

/// Offset from the pixel's centre along one axis, in units of the filter's radius: u in [0, 1) to [-1, 1].
[[nodiscard]] inline double sampleFilter(Filter filter, double u) {
    switch (filter) {
        case Filter::Box: return 2 * u - 1;
        case Filter::Tent: return u < 0.5 ? std::sqrt(2 * u) - 1 : 1 - std::sqrt(2 - 2 * u);
        case Filter::BlackmanHarris: break;
    }
    // Integral of the four-term window a0 + a1 cos(pi x) + a2 cos(2 pi x) + a3 cos(3 pi x), inverted by bracketed Newton.
    constexpr double a0 = 0.35875, a1 = 0.48829, a2 = 0.14128, a3 = 0.01168;
    const auto cdf = [](double x) {
        return 0.5 + (a0 * x + a1 / kPi * std::sin(kPi * x) + a2 / (2 * kPi) * std::sin(2 * kPi * x) +
                      a3 / (3 * kPi) * std::sin(3 * kPi * x)) / (2 * a0);
    };
    double lo = -1, hi = 1, x = 0.6 * (2 * u - 1);
    for (int step = 0; step < 40; ++step) {
        const double error = cdf(x) - u;
        (error > 0 ? hi : lo) = x;
        const double density = (a0 + a1 * std::cos(kPi * x) + a2 * std::cos(2 * kPi * x) + a3 * std::cos(3 * kPi * x)) / (2 * a0);
        double next = x - error / density;
        if (!(next > lo && next < hi)) next = 0.5 * (lo + hi);
        if (std::abs(next - x) < 1e-9) break;  // A billionth of the radius: far below what a picture shows.
        x = next;
    }
    return x;
}

}  // namespace glint
