// Pearson's chi-square test for histograms, and Sidak's correction for suites of tests.
#pragma once

#include <span>

namespace glint::test {

/// Significance of one of `tests` independent tests such that the whole suite rejects a right model
/// with probability `alpha`.
[[nodiscard]] double sidak(double alpha, int tests);

/// P(X >= statistic) for X chi-square distributed with `degrees` > 0 degrees of freedom; relative
/// accuracy 1e-10. Series and continued fraction of the incomplete gamma function (Press et al.,
/// Numerical Recipes, 3rd ed., sec. 6.2).
[[nodiscard]] double chiSquareSurvival(double statistic, double degrees);

struct Chi2Result {
    double statistic = 0;
    int degrees = 0;
    double pValue = 1;
};

/// Tests counts against the counts a model expects, cell by cell. Cells that expect fewer than
/// `minExpected` are pooled, and the pool joins the smallest other cell if it stays below.
/// `samples` is the number of trials: what no cell expects (samples - sum of expected) is a cell of
/// its own, for trials that fell nowhere, if it is more than `tolerance` of all; their number is
/// tested alone too, because a wrong total is lost among many cells: p is twice the smaller of the
/// two. More than `tolerance` of all trials where nothing is expected, or expectations above
/// `samples` by more, give p = 0; `tolerance` is the accuracy of the expectations' sum.
[[nodiscard]] Chi2Result chi2Test(std::span<const double> observed,
                                  std::span<const double> expected, double samples,
                                  double tolerance = 1e-3, double minExpected = 5);

/// True with GLINT_FULL=1 in the environment: the full counts instead of the quick ones.
[[nodiscard]] bool fullCounts();

}  // namespace glint::test
