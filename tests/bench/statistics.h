// The statistics that every measurement shares.
#pragma once

#include <vector>

namespace glint::bench {

/// Of at least one value; the upper one of the middle two.
[[nodiscard]] double median(std::vector<double> values);

/// exp(mean(log)) of positive values.
[[nodiscard]] double geometricMean(const std::vector<double>& values);

/// A mean and the half width of its 95 % interval by Student's t; infinite for a single value.
struct Interval {
    double mean = 0, half = 0;
};
[[nodiscard]] Interval meanInterval(const std::vector<double>& values);

/// A ratio with its 95 % interval [low, high]: geometric mean over pairs a[i] / b[i] of positive values, which were measured one
/// right after the other, so that what slows the machine slows both.
struct Ratio {
    double value = 0, low = 0, high = 0;
};
[[nodiscard]] Ratio pairedRatio(const std::vector<double>& a, const std::vector<double>& b);

/// The line log(y) = intercept + slope log(x) by least squares, with the slope's 95 % half width. At least two points.
struct PowerLaw {
    double slope = 0, slopeHalf = 0, intercept = 0;
    [[nodiscard]] double at(double x) const;
};
[[nodiscard]] PowerLaw fitPowerLaw(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace glint::bench
