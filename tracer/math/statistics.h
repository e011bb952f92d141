// The statistics that tests, benches and the error report share.
#pragma once

#include <cstdint>
#include <vector>

namespace glint {

/// Mean and variance of a stream of numbers, by Welford's method (stable for any offset).
class RunningMoments {
  public:
    void add(double value) {
        ++count_;
        const double difference = value - mean_;
        mean_ += difference / static_cast<double>(count_);
        squares_ += difference * (value - mean_);
    }
    [[nodiscard]] std::int64_t count() const { return count_; }
    [[nodiscard]] double mean() const { return mean_; }
    /// Unbiased variance of one number; 0 for fewer than two.
    [[nodiscard]] double variance() const {
        return count_ > 1 ? squares_ / static_cast<double>(count_ - 1) : 0;
    }
    /// Variance of the mean.
    [[nodiscard]] double varianceOfMean() const {
        return count_ > 0 ? variance() / static_cast<double>(count_) : 0;
    }

  private:
    std::int64_t count_ = 0;
    double mean_ = 0, squares_ = 0;
};

/// Of at least one value; the upper one of the middle two.
[[nodiscard]] double median(std::vector<double> values);

/// exp(mean(log)) of positive values.
[[nodiscard]] double geometricMean(const std::vector<double>& values);

/// A mean and the half width of its 95 % interval by Student's t; infinite for a single value.
struct Interval {
    double mean = 0, half = 0;
};
[[nodiscard]] Interval meanInterval(const std::vector<double>& values);

/// A ratio with its 95 % interval [low, high].
struct Ratio {
    double value = 0, low = 0, high = 0;
};
/// Geometric mean over pairs a[i] / b[i] of positive values, which were measured one right after
/// the other, so that what slows the machine slows both.
[[nodiscard]] Ratio pairedRatio(const std::vector<double>& a, const std::vector<double>& b);

/// The line log(y) = intercept + slope log(x) by least squares, with the slope's 95 % half width
/// (infinite for two points).
struct PowerLaw {
    double slope = 0, slopeHalf = 0, intercept = 0;
    [[nodiscard]] double at(double x) const;
};
/// Of at least two points with positive coordinates.
[[nodiscard]] PowerLaw fitPowerLaw(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace glint
