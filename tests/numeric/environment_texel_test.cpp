// One very bright texel over a plane that faces it: a picture of 4096 x 2048 with radiance 1 and
// one texel of 1e5 (in the polar rows 1e9). Light samples and cosine samples are combined by the
// balance heuristic, 64 of each a pixel.
//
// Closed form. The look-up adds (S - 1) times a tent over the texel and half of its neighbours;
// with D = pi / H and d = 2 pi / W a plane facing the texel's centre (theta, phi) receives
//   K = cos(theta) d P + sin(theta) d sinc^2(d / 2) Q,   P = integral of tent sin cos,   Q =
//   integral of tent sin^2,
// where for rows away from the poles the tent's Fourier transform gives P = sin(2 theta) / 2 * D
// sinc^2(D) and Q = (D - cos(2 theta) D sinc^2(D)) / 2, and for the first row (constant up to the
// pole) integration by parts gives them as second integrals from D / 2 to 3 D / 2. The irradiance
// is pi + (S - 1) K.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/ztest.h"
#include "tracer/lights/environment_map.h"
#include "tracer/math/frame.h"
#include "tracer/math/sobol.h"

namespace glint {
namespace {

using Density = EnvironmentMap::Density;
constexpr int kWidth = 4096, kHeight = 2048;

struct Sun {
    const char* name;
    int column, row;
    float radiance;
};
constexpr Sun kSuns[] = {{"equator", 1234, kHeight / 2, 1e5f},
                         {"first row", 1234, 0, 1e9f},
                         {"last row", 1234, kHeight - 1, 1e9f},
                         {"left of the seam", kWidth - 1, 700, 1e5f},
                         {"right of the seam", 0, 1500, 1e5f}};

std::shared_ptr<const Image> sunImage(const Sun& sun) {
    auto image = std::make_shared<Image>(
        Image{kWidth, kHeight, std::vector<float>(std::size_t{3} * kWidth * kHeight, 1.0f)});
    const auto at =
        (static_cast<std::size_t>(sun.row) * kWidth + static_cast<std::size_t>(sun.column)) * 3;
    for (std::size_t channel = 0; channel < 3; ++channel) image->rgb[at + channel] = sun.radiance;
    return image;
}

DVec3 texelCenter(const Sun& sun) {
    const double theta = kPi * (sun.row + 0.5) / kHeight,
                 phi = 2 * kPi * ((sun.column + 0.5) / kWidth - 0.5);
    return {std::sin(theta) * std::sin(phi), std::cos(theta), -std::sin(theta) * std::cos(phi)};
}

long double squaredSinc(long double x) { return std::sin(x) / x * (std::sin(x) / x); }

/// K of the closed form above for a texel of `row`.
double tentIrradiance(int row) {
    const int fromPole = std::min(row, kHeight - 1 - row);
    const long double height = kPi / kHeight, across = 2 * kPi / kWidth,
                      theta = (fromPole + 0.5L) * height;
    long double p = 0.5L * std::sin(2 * theta) * height * squaredSinc(height);
    long double q = 0.5L * height * (1 - std::cos(2 * theta) * squaredSinc(height));
    if (fromPole == 0) {
        const auto secondP = [](long double t) { return t / 4 - std::sin(2 * t) / 8; };
        const auto secondQ = [](long double t) { return t * t / 4 + std::cos(2 * t) / 8; };
        p = (secondP(theta + height) - secondP(theta)) / height;
        q = (secondQ(theta + height) - secondQ(theta)) / height;
    }
    return static_cast<double>(std::cos(theta) * across * p +
                               std::sin(theta) * across * squaredSinc(across / 2) * q);
}

/// Irradiance of pixels of 64 samples.
using Pixels = test::RunningMoments;

double relativeSigma(const Pixels& pixels) { return std::sqrt(pixels.variance()) / pixels.mean(); }

/// `pdfFactor` other than 1 is the deliberate error; `table` draws, `map` is seen.
Pixels irradiance(const EnvironmentMap& map, const EnvironmentMap& table, const DVec3& normal,
                  double pdfFactor = 1) {
    constexpr std::uint32_t kPixels = 2048, kSpp = 64;
    const Frame frame(normal);
    const auto weighted = [&](const DVec3& d, double pdf) {
        const double cosine = glm::dot(d, normal);
        return cosine > 0 ? map.radiance(d).y * cosine / (pdf * pdfFactor + cosine / kPi) : 0.0;
    };
    Pixels pixels;
    for (std::uint32_t pixel = 0; pixel < kPixels; ++pixel) {
        double value = 0;
        for (std::uint32_t i = 0; i < kSpp; ++i) {
            const SampleBlock u = Sampler(1, pixel, i).block(0);
            const EnvironmentSample light = table.sample({u.x, u.y});
            if (light.pdf > 0) value += weighted(light.direction, light.pdf);
            const DVec3 d = frame.toWorld(cosineHemisphere({u.z, u.w}));
            value += weighted(d, table.pdf(d));
        }
        pixels.add(value / kSpp);
    }
    return pixels;
}

double exactIrradiance(const Sun& sun) {
    return kPi + (double{sun.radiance} - 1) * tentIrradiance(sun.row);
}

/// Where the samples hardly vary their spread does not tell the error: one cosine sample in 3e5
/// falls on the tent and differs by its own size, and radiance is rounded to float.
constexpr double kUnseenError = 1e-5;

/// Within 4 sigma and 0.1 %.
bool agrees(const Pixels& pixels, double exact) {
    const double mean = pixels.mean();
    return test::zTest(mean, pixels.varianceOfMean(), exact, kUnseenError * exact) >
               test::normalTwoSided(4) &&
           std::abs(mean - exact) <= 1e-3 * exact;
}

TEST(EnvironmentTexel, ClosedFormAgreesWithQuadrature) {
    for (const int row : {0, 1, 700}) {
        const double height = kPi / kHeight, across = 2 * kPi / kWidth,
                     center = (row + 0.5) * height;
        constexpr int kSteps = 600;
        double sum = 0;
        for (int j = 0; j < 2 * kSteps; ++j)
            for (int i = 0; i < kSteps;
                 ++i) {  // The right half of the tent; the left one is the same.
                const double theta = center + height * ((j + 0.5) / kSteps - 1),
                             phi = across * (i + 0.5) / kSteps;
                if (theta < 0) continue;
                const bool clamped = row == 0 && theta < center;
                const double tent =
                    (clamped ? 1 : 1 - std::abs(theta - center) / height) * (1 - phi / across);
                sum += 2 * tent * std::sin(theta) *
                       (std::cos(center) * std::cos(theta) +
                        std::sin(center) * std::sin(theta) * std::cos(phi));
            }
        EXPECT_NEAR(sum * height * across / (kSteps * double{kSteps}) / tentIrradiance(row), 1,
                    1e-5)
            << row;
    }
}

TEST(EnvironmentTexel, SunGivesTheExactIrradianceAtTwoPercentNoise) {
    for (const Sun& sun : kSuns) {
        const EnvironmentMap map(sunImage(sun));
        const Pixels pixels = irradiance(map, map, texelCenter(sun));
        const double exact = exactIrradiance(sun);
        EXPECT_TRUE(agrees(pixels, exact))
            << sun.name << ": " << pixels.mean() << ", exact " << exact;
        EXPECT_LE(relativeSigma(pixels), 0.02) << sun.name;
    }
}

TEST(EnvironmentTexel, PlainTableIsUnbiasedAndNoisier) {
    const Sun& sun = kSuns[0];
    const auto image = sunImage(sun);
    const EnvironmentMap plain(image, Density::Plain), compensated(image);
    const Pixels noisy = irradiance(plain, plain, texelCenter(sun));
    const Pixels quiet = irradiance(compensated, compensated, texelCenter(sun));
    EXPECT_GT(test::zTest(noisy.mean(), noisy.varianceOfMean(), exactIrradiance(sun)),
              test::normalTwoSided(4));
    EXPECT_GT(relativeSigma(noisy), 2.5 * relativeSigma(quiet));
}

// Errors that must show: a density 2 % too large, and a table that is one texel beside the picture.
TEST(EnvironmentTexel, WrongDensityAndShiftedTableFail) {
    const Sun& sun = kSuns[0];
    const EnvironmentMap map(sunImage(sun));
    EXPECT_FALSE(agrees(irradiance(map, map, texelCenter(sun), 1.02), exactIrradiance(sun)));

    const EnvironmentMap shifted(sunImage({"", sun.column + 1, sun.row, sun.radiance}));
    EXPECT_GT(relativeSigma(irradiance(map, shifted, texelCenter(sun))), 0.01);
}

}  // namespace
}  // namespace glint
