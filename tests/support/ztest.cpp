#include "tests/support/ztest.h"

#include <algorithm>
#include <cmath>

namespace glint::test {

double normalTwoSided(double z) { return std::erfc(std::abs(z) / std::sqrt(2.0)); }

double zTest(double mean, double varianceOfMean, double expected, double tolerance) {
    const double difference = std::max(0.0, std::abs(mean - expected) - tolerance);
    if (difference == 0) return 1;
    return varianceOfMean > 0 ? normalTwoSided(difference / std::sqrt(varianceOfMean)) : 0;
}

}  // namespace glint::test
