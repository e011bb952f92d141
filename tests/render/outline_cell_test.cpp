// Means over a square of functions with jumps, against their areas.
#include "tracer/render/outline_cell.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/scenes.h"

namespace glint {
namespace {

using Function = std::function<Probe(const DVec2&)>;

Probe probeOf(double value, int region) {
    return {Rgb(static_cast<float>(value)), static_cast<std::uint32_t>(region), 0};
}

struct Found {
    bool told = false;
    OutlineMean mean;
    int probes = 0;
};
Found find(const Function& f, double tolerance, int leastDepth = 0, int mostProbes = 2000,
           double step = 0) {
    Found out;
    const Function counted = [&](const DVec2& u) {
        EXPECT_TRUE(u.x >= 0 && u.x <= 1 && u.y >= 0 && u.y <= 1);
        ++out.probes;
        return f(u);
    };
    out.told = OutlineCell(counted).integrate(f(DVec2(0.5)), tolerance, leastDepth, mostProbes,
                                              step, out.mean);
    return out;
}

/// Share of the unit square within a distance of `radius` from `c`, by strips.
double discArea(const DVec2& c, double radius) {
    constexpr int kStrips = 200000;
    double sum = 0;
    for (int i = 0; i < kStrips; ++i) {
        const double y = (i + 0.5) / kStrips - c.y,
                     half = std::sqrt(std::max(0.0, radius * radius - y * y));
        sum += std::max(0.0, std::min(1.0, c.x + half) - std::max(0.0, c.x - half));
    }
    return sum / kStrips;
}

/// Of a half plane through the square: the polygon's area, by strips.
double halfPlaneArea(double angle, double offset) {
    constexpr int kStrips = 20000;
    const DVec2 n(std::cos(angle), std::sin(angle));
    double sum = 0;
    for (int i = 0; i < kStrips; ++i) {
        const double y = (i + 0.5) / kStrips - 0.5, rest = offset - n.y * y;
        if (std::abs(n.x) < 1e-12)
            sum += rest > 0;
        else
            sum += n.x > 0 ? std::clamp(rest / n.x + 0.5, 0.0, 1.0)
                           : 1 - std::clamp(rest / n.x + 0.5, 0.0, 1.0);
    }
    return sum / kStrips;
}

TEST(OutlineCell, AHalfPlaneIsFoundWithinTheToleranceByFewProbes) {
    for (const double tolerance : {0.03, 0.003, 1e-4}) {
        double squares = 0, estimated = 0, probes = 0;
        int count = 0;
        for (int i = 0; i < 90; ++i)
            for (const double offset : {-0.41, -0.2, 0.0, 0.13, 0.33}) {
                const double angle = 0.02 + i * 2 * kPi / 90;
                const Found found = find(
                    [&](const DVec2& u) {
                        const bool in =
                            std::cos(angle) * (u.x - 0.5) + std::sin(angle) * (u.y - 0.5) < offset;
                        return probeOf(in ? 1 : 0, in);
                    },
                    tolerance);
                ASSERT_TRUE(found.told);
                const double error = found.mean.value.x - halfPlaneArea(angle, offset);
                squares += error * error, estimated += found.mean.error * found.mean.error,
                    probes += found.probes, ++count;
            }
        EXPECT_LT(std::sqrt(squares / count), tolerance);
        EXPECT_LT(std::sqrt(squares), 1.5 * std::sqrt(estimated)) << tolerance;
        EXPECT_LT(probes / count, 18 - 4 * std::log2(tolerance / 0.03)) << tolerance;
    }
}

TEST(OutlineCell, ADiscIsFoundWithinTheTolerance) {
    // Not of those whose rim also bulges in through a side between two corners: that is seen from
    // beyond the side, or not at all.
    for (const double tolerance : {0.01, 1e-3}) {
        double squares = 0;
        int count = 0;
        for (const double radius : {0.3, 4.0, 20.0})
            for (int i = 0; i < 12; ++i) {
                const DVec2 c = DVec2(0.5) + (radius < 0.5 ? 0.15 : radius) *
                                                 DVec2(std::cos(i * 0.5), std::sin(i * 0.5));
                const Found found = find(
                    [&](const DVec2& u) {
                        const bool in = glm::length(u - c) < radius;
                        return probeOf(in ? 0.8 : 0.2, in);
                    },
                    tolerance);
                ASSERT_TRUE(found.told);
                const double error = found.mean.value.x - (0.2 + 0.6 * discArea(c, radius));
                squares += error * error, ++count;
            }
        EXPECT_LT(std::sqrt(squares / count), tolerance);
    }
}

TEST(OutlineCell, ThreeRegionsThatMeetAreFound) {
    // The corner of a square over a half plane.
    const Found found = find(
        [](const DVec2& u) {
            if (u.x < 0.37 && u.y < 0.61) return probeOf(1, 1);
            return u.x < 0.37 + 0.25 * u.y ? probeOf(0.3, 2) : probeOf(0, 3);
        },
        1e-3);
    ASSERT_TRUE(found.told);
    // The strip 0.37 to 0.37 + y / 4 and what is left of 0.37 above 0.61.
    EXPECT_NEAR(found.mean.value.x, 0.37 * 0.61 + 0.3 * (0.37 * 0.39 + 0.125), 3e-3);
    EXPECT_LT(found.probes, 700);
}

TEST(OutlineCell, SmoothLightIsExactToThirdOrder) {
    const Found found = find(
        [](const DVec2& u) {
            return probeOf(0.2 + 0.5 * u.x - 0.25 * u.y + u.x * u.x + 0.5 * u.x * u.y, 7);
        },
        0.1);
    ASSERT_TRUE(found.told);
    EXPECT_NEAR(found.mean.value.x, 0.2 + 0.25 - 0.125 + 1.0 / 3 + 0.125, 1e-6);
    EXPECT_EQ(found.probes, 4);
}

TEST(OutlineCell, ShadingOnBothSidesOfAnOutlineIsTakenAsLinear) {
    const Found found = find(
        [](const DVec2& u) {
            return u.x < 0.4 ? probeOf(1 + u.y + 0.5 * u.x, 1) : probeOf(0.1 * u.y, 2);
        },
        2e-3);
    ASSERT_TRUE(found.told);
    EXPECT_NEAR(found.mean.value.x, 0.4 * 1.5 + 0.25 * 0.16 + 0.6 * 0.05,
                2 * 2e-3);  // Parts along a straight outline err alike.
}

TEST(OutlineCell, AnOutlineThatEntersIsSaidOfItsSide) {
    const Function cut = [](const DVec2& u) { return probeOf(u.x < 0.3 ? 1 : 0, u.x < 0.3); };
    const Found found = find(cut, 1e-3);
    EXPECT_EQ(found.mean.crossed[0].depth, 0);
    EXPECT_NEAR(found.mean.crossed[0].step, 1, 1e-6);
    EXPECT_LT(found.mean.crossed[1].depth, 0);
    EXPECT_EQ(found.mean.crossed[2].depth, 0);
    EXPECT_LT(found.mean.crossed[3].depth, 0);
    // A strip between the probes is seen where the square is split for it.
    const Function strip = [](const DVec2& u) {
        return probeOf(std::abs(u.x - 0.27) < 0.05 ? 1 : 0, std::abs(u.x - 0.27) < 0.05);
    };
    EXPECT_EQ(find(strip, 1e-3).mean.value.x, 0);
    const Found split = find(strip, 1e-3, 2);
    ASSERT_TRUE(split.told);
    EXPECT_NEAR(split.mean.value.x, 0.1, 5e-3);
    EXPECT_GE(split.mean.crossed[0].depth, 2);
}

TEST(OutlineCell, WhatIsBrightBetweenTwoDarkSidesIsFoundWhereItMayBe) {
    const Function band = [](const DVec2& u) {
        return u.y < 0.2 ? probeOf(0, 1) : u.y < 0.45 ? probeOf(1, 2) : probeOf(0, 3);
    };
    EXPECT_EQ(find(band, 0.01).mean.value.x, 0);
    const Found found = find(band, 0.01, 0, 2000, 1);
    ASSERT_TRUE(found.told);
    EXPECT_NEAR(found.mean.value.x, 0.25, 0.02);
}

TEST(OutlineCell, ItEndsWhereThereIsNoEndOfDetail) {
    const Function noise = [](const DVec2& u) {
        const auto hash =
            static_cast<std::uint32_t>(std::abs(std::sin(u.x * 7919.3 + u.y * 104729.7)) * 1e6);
        return probeOf(hash % 2, static_cast<int>(hash));
    };
    const Found found = find(noise, 1e-6, 0, 100);
    ASSERT_TRUE(found.told);
    EXPECT_LT(found.probes, 100 + 80);
    EXPECT_GT(found.mean.error, 1e-3);
    EXPECT_NEAR(found.mean.value.x, 0.5, 0.3);
}

TEST(OutlineCell, AProbeOfNoUseMakesTheSquareOne) {
    const Function torn = [](const DVec2& u) {
        Probe p = probeOf(u.x < 0.6 ? 1 : 0, u.x < 0.6);
        if (u.x > 0.9) p.doubt = -1;
        return p;
    };
    EXPECT_FALSE(find(torn, 1e-3).told);
}

TEST(OutlineCell, DoubtsOfProbesCount) {
    const Function doubtful = [](const DVec2&) {
        Probe p = probeOf(0.5, 1);
        p.doubt = 0.1f;
        return p;
    };
    EXPECT_NEAR(find(doubtful, 0.1).mean.error, 0.1 / std::sqrt(5), 1e-6);
}

}  // namespace
}  // namespace glint
