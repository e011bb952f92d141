// A density on [0, 1] that is linear between evenly spaced values.
#pragma once

#include <array>

#include "tracer/math/warp.h"

namespace glint {

template <std::size_t Steps>
class LinearDensity {
  public:
    LinearDensity() = default;
    /// `value(s)` at s = 0, 1 / Steps ... 1; not negative.
    template <class Value>
    explicit LinearDensity(const Value& value) {
        for (std::size_t i = 0; i <= Steps; ++i) at_[i] = value(static_cast<double>(i) / Steps);
        for (std::size_t i = 0; i < Steps; ++i) integral_ += (at_[i] + at_[i + 1]) / (2 * Steps);
    }

    /// Of the values, not normalised.
    [[nodiscard]] double integral() const { return integral_; }
    /// Normalised.
    [[nodiscard]] double density(double s) const {
        const double place = std::clamp(s, 0.0, 1.0) * Steps;
        const std::size_t i = std::min(static_cast<std::size_t>(place), Steps - 1);
        return glm::mix(at_[i], at_[i + 1], place - static_cast<double>(i)) / integral_;
    }
    [[nodiscard]] double sample(double u) const {
        double left = u * integral_ * Steps;
        for (std::size_t i = 0; i < Steps; ++i) {
            const double area = (at_[i] + at_[i + 1]) / 2;
            if (left < area)
                return (static_cast<double>(i) +
                        invertLinearDensity(left / area, at_[i], at_[i + 1])) /
                       Steps;
            left -= area;
        }
        return 1;
    }

  private:
    std::array<double, Steps + 1> at_{};
    double integral_ = 0;
};

}  // namespace glint
