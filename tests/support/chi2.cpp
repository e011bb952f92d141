#include "tests/support/chi2.h"

#include "tests/support/ztest.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <string_view>
#include <vector>

namespace glint::test {
namespace {

/// Lower regularised incomplete gamma function P(a, x) by its series, for x < a + 1.
double gammaSeries(double a, double x) {
    double term = 1 / a, sum = term;
    for (double n = a + 1; std::abs(term) > std::abs(sum) * 1e-15; ++n) sum += term *= x / n;
    return sum * std::exp(-x + a * std::log(x) - std::lgamma(a));
}

/// Upper regularised incomplete gamma function Q(a, x) by Lentz's continued fraction, for x >= a
/// + 1.
double gammaFraction(double a, double x) {
    constexpr double kTiny = 1e-300;
    double b = x + 1 - a, c = 1 / kTiny, d = 1 / b, h = d;
    for (int i = 1; i < 100000; ++i) {
        const double an = -i * (i - a);
        b += 2;
        d = an * d + b;
        if (std::abs(d) < kTiny) d = kTiny;
        c = b + an / c;
        if (std::abs(c) < kTiny) c = kTiny;
        d = 1 / d;
        const double factor = d * c;
        h *= factor;
        if (std::abs(factor - 1) < 1e-14) break;
    }
    return std::exp(-x + a * std::log(x) - std::lgamma(a)) * h;
}

struct Cell {
    double observed = 0, expected = 0;
};

/// The cells large enough for the test. Returns the count where nothing is expected.
double poolCells(std::span<const double> observed, std::span<const double> expected,
                 double minExpected, std::vector<Cell>& cells) {
    Cell pool;
    double impossible = 0;
    for (std::size_t i = 0; i < observed.size(); ++i) {
        if (!(expected[i] > 0)) impossible += observed[i];
        if (expected[i] >= minExpected) {
            cells.push_back({observed[i], expected[i]});
        } else {
            pool.observed += observed[i];
            pool.expected += expected[i];
        }
    }
    if (pool.expected >= minExpected || cells.empty()) {
        cells.push_back(pool);
    } else {
        const auto smallest =
            std::min_element(cells.begin(), cells.end(),
                             [](const Cell& a, const Cell& b) { return a.expected < b.expected; });
        smallest->observed += pool.observed;
        smallest->expected += pool.expected;
    }
    return impossible;
}

}  // namespace

double sidak(double alpha, int tests) { return -std::expm1(std::log1p(-alpha) / tests); }

double chiSquareSurvival(double statistic, double degrees) {
    if (!(statistic > 0)) return 1;
    const double a = degrees / 2, x = statistic / 2;
    return x < a + 1 ? 1 - gammaSeries(a, x) : gammaFraction(a, x);
}

Chi2Result chi2Test(std::span<const double> observed, std::span<const double> expected,
                    double samples, double tolerance, double minExpected) {
    const Chi2Result rejected{std::numeric_limits<double>::infinity(), 1, 0};
    std::vector<Cell> cells;
    if (poolCells(observed, expected, minExpected, cells) > tolerance * samples) return rejected;
    const double nowhere = samples - std::accumulate(observed.begin(), observed.end(), 0.0);
    const double expectedNowhere = samples - std::accumulate(expected.begin(), expected.end(), 0.0);
    const double slack = std::max(tolerance * samples, minExpected);
    if (expectedNowhere < -slack) return rejected;
    if (expectedNowhere > slack) cells.push_back({nowhere, expectedNowhere});

    Chi2Result result;
    for (const Cell& cell : cells) {
        const double difference = cell.observed - cell.expected;
        result.statistic += difference * difference / cell.expected;
    }
    result.degrees = std::max(1, static_cast<int>(cells.size()) - 1);
    const double share = std::clamp(expectedNowhere / samples, 1 / samples, 1.0);
    const double totalP =
        zTest(nowhere, share * (1 - share) * samples, std::max(0.0, expectedNowhere), slack);
    result.pValue =
        std::min(1.0, 2 * std::min(totalP, chiSquareSurvival(result.statistic, result.degrees)));
    return result;
}

bool fullCounts() {
    const char* value = std::getenv("GLINT_FULL");
    return value && std::string_view(value) != "0" && std::string_view(value) != "";
}

}  // namespace glint::test
