// Tests of means against a known value.
#pragma once

#include <cstdint>

namespace glint::test {

/// Mean and variance of a stream of numbers, by Welford's method (stable for any offset).
class RunningMoments {
  public:
    void add(double value);
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

/// P(|Z| >= |z|) for a standard normal Z.
[[nodiscard]] double normalTwoSided(double z);

/// p-value of `mean`, an estimate with `varianceOfMean`, against `expected`. Differences within
/// `tolerance` (rounding, or the expected value's own accuracy) count as none; without any variance
/// everything beyond it gives p = 0.
[[nodiscard]] double zTest(double mean, double varianceOfMean, double expected,
                           double tolerance = 0);

}  // namespace glint::test
