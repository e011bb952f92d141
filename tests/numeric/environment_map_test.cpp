// EnvironmentMap: the look-up is the format's, and directions are drawn with the density that pdf()
// states. Significance of the chi-square tests: 1e-3 for the file, Sidak-corrected over kMaps x 2
// densities. Seeds are fixed.
#include "tracer/lights/environment_map.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

#include "tests/support/chi2.h"

namespace glint {
namespace {

using Density = EnvironmentMap::Density;
constexpr std::array kDensities = {Density::Plain, Density::Compensated};

Image makeImage(int width, int height, const std::function<Rgb(int, int)>& color) {
    Image image{width, height, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Rgb c = color(x, y);
            image.rgb.insert(image.rgb.end(), {c.x, c.y, c.z});
        }
    return image;
}

EnvironmentMap makeMap(Image image, Density density = Density::Compensated) {
    return EnvironmentMap(std::make_shared<const Image>(std::move(image)), density);
}

DVec3 directionAt(double u, double v) {
    const double phi = 2 * kPi * (u - 0.5), theta = kPi * v;
    return {std::sin(theta) * std::sin(phi), std::cos(theta), -std::sin(theta) * std::cos(phi)};
}

struct NamedImage {
    const char* name;
    Image image;
};

/// Small pictures, each with one trait that a table gets wrong easily.
std::vector<NamedImage> traitImages() {
    std::mt19937 random(11);
    std::uniform_real_distribution<float> uniform(0, 1);
    const auto noise = [&](int, int) {
        return Rgb(uniform(random), uniform(random), uniform(random));
    };
    const auto spot = [](int column, int row, float peak) {
        return [=](int x, int y) { return Rgb(x == column && y == row ? peak : 1.0f); };
    };
    std::vector<NamedImage> out;
    out.push_back({"noise", makeImage(12, 7, noise)});
    out.push_back({"more columns than a block", makeImage(37, 5, noise)});
    out.push_back({"spot", makeImage(16, 8, spot(5, 3, 50))});
    out.push_back({"spot in the first row", makeImage(16, 8, spot(5, 0, 500))});
    out.push_back({"spot in the last row", makeImage(16, 8, spot(5, 7, 500))});
    out.push_back({"spot left of the seam", makeImage(16, 8, spot(15, 4, 50))});
    out.push_back({"spot right of the seam", makeImage(16, 8, spot(0, 4, 50))});
    out.push_back(
        {"half black", makeImage(16, 8, [](int x, int) { return Rgb(x < 8 ? 0.0f : 1.0f); })});
    out.push_back({"one texel", makeImage(1, 1, noise)});
    out.push_back({"one row of two", makeImage(2, 1, noise)});
    out.push_back({"one column", makeImage(1, 5, noise)});
    return out;
}

TEST(EnvironmentLookUp, FollowsTheFormat) {
    // Texel (x, y) holds 10 y + x.
    const EnvironmentMap map =
        makeMap(makeImage(4, 3, [](int x, int y) { return Rgb(static_cast<float>(10 * y + x)); }));
    const auto at = [&](double x, double y) {
        return map.radiance(directionAt((x + 0.5) / 4, (y + 0.5) / 3)).x;
    };
    EXPECT_NEAR(at(2, 1), 12, 1e-5) << "texel centre";
    EXPECT_NEAR(at(1.25, 1.5), 16.25, 1e-5) << "between four centres";
    EXPECT_NEAR(at(3.25, 1), 0.75 * 13 + 0.25 * 10, 1e-5) << "u wraps to the right";
    EXPECT_NEAR(at(-0.25, 1), 0.75 * 10 + 0.25 * 13, 1e-5) << "u wraps to the left";
    EXPECT_NEAR(at(1, -0.4), 1, 1e-5) << "v clamps at the top";
    EXPECT_NEAR(at(1, 2.4), 21, 1e-5) << "v clamps at the bottom";
    EXPECT_NEAR(map.radiance({0, 0, -1}).x, 11.5, 1e-5) << "the middle of the picture is -z";
    EXPECT_NEAR(map.radiance({1, 0, 0}).x, 12.5, 1e-5) << "+x lies to the right of the middle";
}

TEST(EnvironmentLookUp, IsFiniteAtPolesAndSeam) {
    const EnvironmentMap map =
        makeMap(makeImage(4, 2, [](int x, int y) { return Rgb(static_cast<float>(1 + x + y)); }));
    for (const double zero : {0.0, -0.0})
        for (const double sign : {1.0, -1.0})
            for (const DVec3& d :
                 {DVec3(zero, sign, zero), DVec3(-zero, sign, zero), DVec3(zero, zero, sign),
                  DVec3(1e-200, sign, zero), DVec3(sign * 1e-17, zero, 1)}) {
                const EnvironmentLookup seen = map.evaluate(d);
                EXPECT_GE(seen.radiance.x, 1);
                EXPECT_LE(seen.radiance.x, 5);
                EXPECT_TRUE(std::isfinite(seen.pdf));
            }
}

TEST(EnvironmentLookUp, SurvivesDirectionsThatAreNotFinite) {
    const EnvironmentMap map = makeMap(traitImages()[0].image);
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), kInfinity, -kInfinity})
        for (const DVec3& d : {DVec3(bad), DVec3(bad, 0, 1), DVec3(0, bad, 1), DVec3(0, 1, bad)}) {
            const EnvironmentLookup seen = map.evaluate(d);
            EXPECT_TRUE(seen.pdf >= 0 || std::isnan(seen.pdf));
        }
}

/// Sum of f(u, v) * sin(theta) over the sphere, by midpoints in strips between texel centres, where
/// f is smooth.
double integrateSphere(const Image& image, const std::function<double(double, double)>& f) {
    constexpr int kAcross = 2, kAlong = 200;
    double sum = 0;
    for (int band = 0; band <= image.height; ++band) {
        const double top = std::max(0.0, band - 0.5) / image.height;
        const double bottom = std::min<double>(image.height, band + 0.5) / image.height;
        for (int j = 0; j < kAlong; ++j) {
            const double v = top + (bottom - top) * (j + 0.5) / kAlong;
            double row = 0;
            for (int i = 0; i < image.width * kAcross; ++i)
                row += f((0.5 + (i + 0.5) / kAcross) / image.width, v);
            sum += row * std::sin(kPi * v) * (bottom - top) / kAlong;
        }
    }
    return sum * 2 * kPi * kPi / (image.width * kAcross);
}

TEST(EnvironmentDensity, IntegratesToOne) {
    for (const auto& [name, image] : traitImages())
        for (const Density density : kDensities) {
            const EnvironmentMap map = makeMap(image, density);
            const double sum = integrateSphere(
                image, [&](double u, double v) { return map.pdf(directionAt(u, v)); });
            EXPECT_NEAR(sum, 1, 1e-5) << name;
        }
}

TEST(EnvironmentDensity, MeanRadianceIsTheIntegral) {
    for (const auto& [name, image] : traitImages()) {
        const EnvironmentMap map = makeMap(image);
        const double sum = integrateSphere(
            image, [&](double u, double v) { return double{map.radiance(directionAt(u, v)).y}; });
        EXPECT_NEAR(map.meanRadiance().y / (sum / (4 * kPi)), 1, 1e-5) << name;
    }
}

TEST(EnvironmentDensity, PlainIsProportionalToLuminance) {
    const Image image = traitImages()[0].image;
    const EnvironmentMap map = makeMap(image, Density::Plain);
    const double factor = 1 / (4 * kPi * luminance(map.meanRadiance()));
    for (double u = 0.03; u < 1; u += 0.1)
        for (double v = 0.03; v < 1; v += 0.1) {
            const EnvironmentLookup seen = map.evaluate(directionAt(u, v));
            EXPECT_NEAR(seen.pdf, luminance(seen.radiance) * factor, 1e-6 * factor);
        }
}

TEST(EnvironmentDensity, CompensatedIsZeroBelowTheMean) {
    const EnvironmentMap map = makeMap(
        makeImage(16, 8, [](int x, int y) { return Rgb(x == 5 && y == 3 ? 50.0f : 1.0f); }));
    EXPECT_EQ(map.pdf(directionAt(10.5 / 16, 3.5 / 8)), 0);
    EXPECT_GT(map.pdf(directionAt(5.5 / 16, 3.5 / 8)), 6);
}

/// 80 x 160 cells in the full form, even in the picture's rows and columns.
const int kRows = test::fullCounts() ? 80 : 16, kColumns = 2 * kRows;
using Bins = std::vector<double>;

Bins expectedBins(const EnvironmentMap& map, double samples) {
    const int sub = test::fullCounts() ? 8 : 16;
    Bins bins(static_cast<std::size_t>(kColumns * kRows), 0.0);
    const double cell = 2 * kPi * kPi / (kColumns * kRows * sub * sub);
    for (int j = 0; j < kRows * sub; ++j)
        for (int i = 0; i < kColumns * sub; ++i) {
            const double u = (i + 0.5) / (kColumns * sub), v = (j + 0.5) / (kRows * sub);
            bins[static_cast<std::size_t>(j / sub * kColumns + i / sub)] +=
                map.pdf(directionAt(u, v)) * std::sin(kPi * v) * cell * samples;
        }
    return bins;
}

Bins observedBins(const EnvironmentMap& map, int samples) {
    Bins bins(static_cast<std::size_t>(kColumns * kRows), 0.0);
    std::mt19937 random(5);
    std::uniform_int_distribution<int> uniform(0, (1 << 24) - 1);
    for (int i = 0; i < samples; ++i) {
        const float x = static_cast<float>(uniform(random)) * 0x1p-24f,
                    y = static_cast<float>(uniform(random)) * 0x1p-24f;
        const DVec3 d = map.sample({x, y}).direction;
        const double u = std::atan2(d.x, -d.z) / (2 * kPi) + 0.5,
                     v = std::acos(std::clamp(d.y, -1.0, 1.0)) / kPi;
        const int column = std::min(kColumns - 1, static_cast<int>(u * kColumns));
        const int row = std::min(kRows - 1, static_cast<int>(v * kRows));
        bins[static_cast<std::size_t>(row * kColumns + column)] += 1;
    }
    return bins;
}

const int kSamples = test::fullCounts() ? 4'000'000 : 200'000;
constexpr int kChiSquareTests = 22;
const double kCriticalP = test::sidak(1e-3, kChiSquareTests);

double pValue(const Bins& observed, const Bins& expected) {
    return test::chi2Test(observed, expected, kSamples).pValue;
}

TEST(EnvironmentSample, MatchesPdf) {
    ASSERT_EQ(traitImages().size() * kDensities.size(), std::size_t{kChiSquareTests});
    for (const auto& [name, image] : traitImages())
        for (const Density density : kDensities) {
            const EnvironmentMap map = makeMap(image, density);
            EXPECT_GT(pValue(observedBins(map, kSamples), expectedBins(map, kSamples)), kCriticalP)
                << name << (density == Density::Plain ? ", plain" : ", compensated") << ", seed 5";
        }
}

// The same test must see a density that is 2 % too large, and a table that is a texel off to the
// side or downwards.
TEST(EnvironmentSample, ChiSquareRejectsWrongDensities) {
    const Image image = traitImages()[0].image;
    const EnvironmentMap map = makeMap(image);
    const Bins observed = observedBins(map, kSamples);
    EXPECT_LT(pValue(observed, expectedBins(map, 1.02 * kSamples)), kCriticalP);
    for (const auto& [dx, dy] : {std::pair{1, 0}, std::pair{0, 1}}) {
        const EnvironmentMap shifted =
            makeMap(makeImage(image.width, image.height, [&, dx = dx, dy = dy](int x, int y) {
                const int from = (y + dy) % image.height * image.width + (x + dx) % image.width;
                const float* p = image.rgb.data() + 3 * from;
                return Rgb(p[0], p[1], p[2]);
            }));
        EXPECT_LT(pValue(observed, expectedBins(shifted, kSamples)), kCriticalP);
    }
}

TEST(EnvironmentSample, AgreesWithLookUpOfItsDirection) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> uniform(0, 1 - 0x1p-24f);
    for (const auto& [name, image] : traitImages())
        for (const Density density : kDensities) {
            const EnvironmentMap map = makeMap(image, density);
            double largest = 0;
            for (int y = 0; y < image.height; ++y)
                for (int x = 0; x < image.width; ++x)
                    largest = std::max(largest, map.pdf(directionAt((x + 0.5) / image.width,
                                                                    (y + 0.5) / image.height)));
            for (int i = 0; i < 1000; ++i) {
                const EnvironmentSample s = map.sample({uniform(random), uniform(random)});
                const EnvironmentLookup seen = map.evaluate(s.direction);
                EXPECT_GT(s.pdf, 0) << name;
                EXPECT_NEAR(glm::length(s.direction), 1, 1e-14);
                EXPECT_NEAR(seen.pdf, s.pdf, 1e-9 * largest) << name;
                EXPECT_NEAR(seen.radiance.y, s.radiance.y, 2e-6f * (1 + s.radiance.y)) << name;
            }
        }
}

TEST(EnvironmentSample, IsMonotonicInBothNumbers) {
    const EnvironmentMap map = makeMap(traitImages()[1].image, Density::Plain);
    double lastY = 2, lastAzimuth = -1;
    for (int i = 0; i < 4096; ++i) {
        const float u = static_cast<float>(i) / 4096;
        const double y = map.sample({0.3f, u}).direction.y;
        EXPECT_LT(y, lastY + 1e-14);
        lastY = y;
        // The first column's centre is half a texel right of the seam.
        const DVec3 d = map.sample({u, 0.6f}).direction;
        const double turn = std::atan2(d.x, -d.z) / (2 * kPi) + 0.5 - 0.5 / 37;
        const double azimuth = turn < -1e-12 ? turn + 1 : turn;
        EXPECT_GT(azimuth, lastAzimuth - 1e-14);
        lastAzimuth = azimuth;
    }
}

TEST(EnvironmentSample, CornersGiveFiniteSamplesOrNone) {
    constexpr std::array kCorners = {0.0f, 0x1p-32f, 0.5f, 1 - 0x1p-24f};
    for (const auto& [name, image] : traitImages())
        for (const Density density : kDensities)
            for (const float x : kCorners)
                for (const float y : kCorners) {
                    const EnvironmentMap map = makeMap(image, density);
                    const EnvironmentSample s = map.sample({x, y});
                    EXPECT_TRUE(isFinite(s.direction) && std::isfinite(s.pdf) && s.pdf >= 0)
                        << name << x << y;
                }
}

TEST(EnvironmentSample, BlackPictureHasNone) {
    const EnvironmentMap map = makeMap(makeImage(8, 4, [](int, int) { return Rgb(0.0f); }));
    EXPECT_EQ(map.sample({0.3f, 0.7f}).pdf, 0);
    EXPECT_EQ(map.pdf({0, 1, 0}), 0);
}

TEST(EnvironmentSample, ConstantPictureIsUniform) {
    for (const Density density : kDensities) {
        const EnvironmentMap map =
            makeMap(makeImage(64, 32, [](int, int) { return Rgb(0.3f, 0.1f, 0.7f); }), density);
        for (const float u : {0.0f, 0.1f, 0.6f, 0.99f})
            EXPECT_NEAR(map.sample({u, 1 - u * 0.9f - 0.05f}).pdf, kUniformSpherePdf, 1e-9);
    }
}

TEST(EnvironmentSample, HugeTexelDoesNotSwallowItsRow) {
    constexpr int kWidth = 4096, kSun = 3000;
    const EnvironmentMap map =
        makeMap(makeImage(kWidth, 1, [](int x, int) { return Rgb(x == kSun ? 1e9f : 1.0f); }),
                Density::Plain);
    // Columns 0 to 1000 hold 1000 parts of 1e9 + 4095: the integral runs from the first centre.
    const DVec3 d = map.sample({static_cast<float>(1000 / (1e9 + kWidth - 1)), 0.4f}).direction;
    EXPECT_NEAR((std::atan2(d.x, -d.z) / (2 * kPi) + 0.5) * kWidth - 0.5, 1000, 1e-3);
}

TEST(EnvironmentSample, NonFiniteTexelsDoNotSpoilTheTable) {
    for (const float bad :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()})
        for (const Density density : kDensities) {
            const EnvironmentMap map = makeMap(
                makeImage(16, 8,
                          [&](int x, int y) {
                              return Rgb(x == 3 && y == 3 ? bad : 1.0f + static_cast<float>(x));
                          }),
                density);
            EXPECT_TRUE(isFinite(map.meanRadiance()));
            for (float u = 0.02f; u < 1; u += 0.07f) {
                const EnvironmentSample s = map.sample({u, u});
                EXPECT_TRUE(isFinite(s.direction) && std::isfinite(s.pdf));
            }
        }
}

}  // namespace
}  // namespace glint
