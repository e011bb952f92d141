// Tests of means against a known value.
#pragma once

#include "tracer/math/statistics.h"

namespace glint::test {

using glint::RunningMoments;

/// P(|Z| >= |z|) for a standard normal Z.
[[nodiscard]] double normalTwoSided(double z);

/// p-value of `mean`, an estimate with `varianceOfMean`, against `expected`. Differences within
/// `tolerance` (rounding, or the expected value's own accuracy) count as none; without any variance
/// everything beyond it gives p = 0.
[[nodiscard]] double zTest(double mean, double varianceOfMean, double expected,
                           double tolerance = 0);

}  // namespace glint::test
