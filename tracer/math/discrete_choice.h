// A choice among few things by weight, by one uniform number.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace glint {

/// Chooses i with probability weight i / sum of weights.
class DiscreteChoice {
  public:
    DiscreteChoice() = default;
    /// Weights above 0.
    explicit DiscreteChoice(const std::vector<double>& weights) {
        double sum = 0;
        for (const double weight : weights) ends_.push_back(sum += weight);
        for (double& end : ends_) end /= sum;
        if (!ends_.empty()) ends_.back() = 1;
    }
    /// The choice at `u` in [0, 1).
    [[nodiscard]] std::size_t pick(double u) const {
        return static_cast<std::size_t>(std::upper_bound(ends_.begin(), ends_.end() - 1, u) -
                                        ends_.begin());
    }
    [[nodiscard]] double probability(std::size_t i) const {
        return ends_[i] - (i ? ends_[i - 1] : 0.0);
    }

  private:
    std::vector<double> ends_;  ///< sums of the weights so far, over all of them
};

}  // namespace glint
