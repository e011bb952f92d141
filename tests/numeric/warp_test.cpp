// Maps from uniform numbers: accuracy of the trigonometry, filters against their windows,
// stratification of the sampler.
#include <gtest/gtest.h>

#include "tracer/math/sobol.h"
#include "tracer/math/warp.h"
#include "tracer/render/pixel_filter.h"

namespace glint {
namespace {

TEST(CosSinTurn, IsWithinItsBound) {
    double worst = 0;
    for (int i = -20000; i <= 20000; ++i) {
        const double u = i / 9999.7;
        const DVec2 found = cosSinTurn(u);
        worst = std::max({worst, std::abs(found.x - std::cos(2 * kPi * u)),
                          std::abs(found.y - std::sin(2 * kPi * u))});
    }
    EXPECT_LE(worst, 1e-13);
}

TEST(CosSinEighth, IsWithinItsBounds) {
    double worst = 0, worstOfFloats = 0;
    for (int i = -20000; i <= 20000; ++i) {
        const auto x = static_cast<float>(kPi / 4 * i / 20000);
        const DVec2 exact(std::cos(static_cast<double>(x)), std::sin(static_cast<double>(x)));
        const auto far = [&](const DVec2& found) {
            return std::max(std::abs(found.x - exact.x), std::abs(found.y - exact.y));
        };
        worst = std::max(worst, far(cosSinEighth(static_cast<double>(x))));
        worstOfFloats = std::max(worstOfFloats, far(DVec2(cosSinEighth(x))));
    }
    EXPECT_LE(worst, 1e-13);
    EXPECT_LE(worstOfFloats, 2e-7);
}

TEST(CosineHemisphere, DrawsUnitVectorsOverTheConcentricDisk) {
    constexpr float kLast = 1 - 0x1p-24f;
    for (const float x : {0.0f, 1e-7f, 0.2f, 0.5f, 0.500001f, 0.8f, kLast})
        for (const float y : {0.0f, 3e-6f, 0.35f, 0.5f, 0.499999f, 0.9f, kLast}) {
            const Vec3 w = cosineHemisphere({x, y});
            const DVec2 disk = concentricDisk(DVec2(x, y));
            EXPECT_NEAR(static_cast<double>(w.x), disk.x, 4e-7) << x << " " << y;
            EXPECT_NEAR(static_cast<double>(w.y), disk.y, 4e-7) << x << " " << y;
            EXPECT_NEAR(glm::length(DVec3(w)), 1, 4e-7) << x << " " << y;
            EXPECT_GE(w.z, 0) << x << " " << y;
        }
}

/// Mean of x^2 under the filter, by its sampler.
double secondMoment(Filter filter) {
    constexpr int kSteps = 200000;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) sum += std::pow(sampleFilter(filter, (i + 0.5) / kSteps), 2);
    return sum / kSteps;
}

TEST(PixelFilter, DrawsFromItsWindow) {
    EXPECT_NEAR(secondMoment(Filter::Box), 1.0 / 3, 1e-6);
    EXPECT_NEAR(secondMoment(Filter::Tent), 1.0 / 6, 1e-6);
    // Integral of x^2 (a0 + a1 cos(pi x) + a2 cos(2 pi x) + a3 cos(3 pi x)) over that of the
    // window.
    const double exact =
        1.0 / 3 + (-2 * 0.48829 + 2 * 0.14128 / 4 - 2 * 0.01168 / 9) / (kPi * kPi * 0.35875);
    EXPECT_NEAR(secondMoment(Filter::BlackmanHarris), exact,
                1e-3 * exact);  // The outermost strips are wide.
}

TEST(PixelFilter, StaysInItsRadiusAndIsSymmetric) {
    for (const Filter filter : {Filter::Box, Filter::Tent, Filter::BlackmanHarris})
        for (const double u : {1e-9, 0.1, 0.4999, 0.5, 0.75, 1 - 0x1p-24}) {
            EXPECT_LE(std::abs(sampleFilter(filter, u)), 1);
            EXPECT_NEAR(sampleFilter(filter, u), -sampleFilter(filter, 1 - u), 1e-9);
        }
}

/// Whether the first 2^(a + b) points have one in each of 2^a x 2^b cells of dimensions i and j.
bool isNet(std::uint32_t block, int i, int j, int a, int b) {
    const int columns = 1 << a, rows = 1 << b;
    std::vector<int> count(static_cast<std::size_t>(columns * rows));
    for (std::uint32_t n = 0; n < static_cast<std::uint32_t>(columns * rows); ++n) {
        const SampleBlock p =
            Sampler(7, 1234, 2 * n).block(block);  // Even samples: one half of the film.
        const int cell = static_cast<int>(p[i] * static_cast<float>(columns)) * rows +
                         static_cast<int>(p[j] * static_cast<float>(rows));
        if (++count[static_cast<std::size_t>(cell)] > 1) return false;
    }
    return true;
}

TEST(Sampler, FirstTwoDimensionsOfEveryBlockAreANetInBaseTwo) {
    for (std::uint32_t block = 0; block < 20; ++block)
        for (int a = 0; a <= 6; ++a)
            EXPECT_TRUE(isNet(block, 0, 1, a, 6 - a)) << "block " << block << ", " << a;
}

TEST(Sampler, EveryDimensionIsStratified) {
    for (std::uint32_t block = 0; block < 20; ++block)
        for (int d = 0; d < 4; ++d)
            EXPECT_TRUE(isNet(block, d, (d + 1) % 4, 8, 0))
                << "block " << block << ", dimension " << d;
}

TEST(Sampler, BlocksPixelsHalvesAndSeedsAreIndependent) {
    // Correlation over 4096 points; 1/64 is its standard deviation where there is none.
    const auto correlation = [](auto first, auto second) {
        double sum = 0;
        for (std::uint32_t n = 0; n < 4096; ++n) sum += (first(n) - 0.5) * (second(n) - 0.5) * 12;
        return std::abs(sum / 4096);
    };
    const auto base = [](std::uint32_t n) { return Sampler(1, 50, 2 * n).block(3).x; };
    EXPECT_GT(correlation(base, base), 0.9);  // The measure can fail.
    EXPECT_LT(correlation(base, [](std::uint32_t n) { return Sampler(1, 50, 2 * n).block(4).x; }),
              5.0 / 64);
    EXPECT_LT(correlation(base, [](std::uint32_t n) { return Sampler(1, 51, 2 * n).block(3).x; }),
              5.0 / 64);
    EXPECT_LT(
        correlation(base, [](std::uint32_t n) { return Sampler(1, 50, 2 * n + 1).block(3).x; }),
        5.0 / 64);
    EXPECT_LT(correlation(base, [](std::uint32_t n) { return Sampler(2, 50, 2 * n).block(3).x; }),
              5.0 / 64);
}

}  // namespace
}  // namespace glint
