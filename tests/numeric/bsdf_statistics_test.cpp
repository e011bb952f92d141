// The statistical helpers themselves, against tabled values.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "tests/support/chi2.h"
#include "tests/support/ztest.h"

namespace glint::test {
namespace {

TEST(Statistics, ChiSquareSurvivalMatchesTables) {
    EXPECT_NEAR(chiSquareSurvival(3.841458820694124, 1), 0.05, 1e-10);
    EXPECT_NEAR(chiSquareSurvival(18.307038053275146, 10), 0.05, 1e-10);
    EXPECT_NEAR(chiSquareSurvival(149.4492527, 100), 0.001, 1e-9);
    EXPECT_NEAR(chiSquareSurvival(2, 2), std::exp(-1.0), 1e-12);
    EXPECT_EQ(chiSquareSurvival(0, 5), 1);
}

TEST(Statistics, SidakKeepsTheSuiteLevel) {
    EXPECT_NEAR(1 - std::pow(1 - sidak(1e-3, 500), 500), 1e-3, 1e-12);
    EXPECT_DOUBLE_EQ(sidak(0.05, 1), 0.05);
}

TEST(Statistics, Chi2PoolsSmallCellsAndRejectsTheImpossible) {
    const std::array<double, 4> expected{50, 45, 3, 2};
    const Chi2Result fair = chi2Test(std::array<double, 4>{52, 43, 4, 1}, expected, 100);
    EXPECT_EQ(fair.degrees, 2);
    EXPECT_NEAR(fair.statistic, 4.0 / 50 + 4.0 / 45, 1e-12);
    EXPECT_EQ(chi2Test(std::array<double, 2>{90, 10}, std::array<double, 2>{100, 0}, 100).pValue,
              0);
    EXPECT_EQ(chi2Test(std::array<double, 2>{50, 50}, std::array<double, 2>{60, 60}, 100).pValue,
              0);
}

TEST(Statistics, ZTestUsesTheVarianceOfTheMean) {
    RunningMoments moments;
    for (const double x : {1e9 + 1, 1e9 + 2, 1e9 + 3, 1e9 + 4}) moments.add(x);
    EXPECT_DOUBLE_EQ(moments.mean(), 1e9 + 2.5);
    EXPECT_NEAR(moments.variance(), 5.0 / 3, 1e-9);
    EXPECT_NEAR(zTest(1.96, 1, 0), 0.04999579, 1e-7);
    EXPECT_EQ(zTest(1.001, 0, 1, 1e-2), 1);
    EXPECT_EQ(zTest(1.1, 0, 1, 1e-2), 0);
}

}  // namespace
}  // namespace glint::test
