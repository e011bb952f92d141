// The daylight sky: finite and positive for every sun, of the brightness that sky.h promises, and
// with a sun to match.
#include "tracer/lights/sky.h"

#include <gtest/gtest.h>

#include <cmath>

namespace glint {
namespace {

constexpr int kWidth = 128;
constexpr double kElevations[] = {-90, -30, -6, -0.3, -0.1, 0, 0.1, 0.3, 2, 10, 30, 60, 90};

Sky makeSky(double elevationDegrees, double turbidity, double azimuthDegrees = 0) {
    const double e = degreesToRadians(elevationDegrees), a = degreesToRadians(azimuthDegrees);
    Sky sky;
    sky.sunDirection = {std::cos(e) * std::sin(a), std::sin(e), -std::cos(e) * std::cos(a)};
    sky.turbidity = turbidity;
    return sky;
}

Rgb texel(const Image& image, int x, int y) {
    const float* p = image.rgb.data() + 3 * (y * image.width + x);
    return {p[0], p[1], p[2]};
}

double zenithLuminance(const Sky& sky) {
    const Image image = skyImage(sky, kWidth);
    double sum = 0;
    for (int x = 0; x < kWidth; ++x) sum += luminance(texel(image, x, 0));
    return sum / kWidth;
}

TEST(Sky, IsFiniteAndNotNegativeForEverySun) {
    for (const double turbidity : {0.0, 1.0, 2.0, 3.0, 6.0, 10.0, 20.0})
        for (const double elevation : kElevations) {
            const Sky sky = makeSky(elevation, turbidity, 77);
            for (const float value : skyImage(sky, 32).rgb)
                ASSERT_TRUE(value >= 0 && value < 100) << elevation << " " << turbidity;
            const SkySun sun = skySun(sky);
            EXPECT_TRUE(isFinite(sun.irradiance) && isFinite(sun.direction));
            for (int channel = 0; channel < 3; ++channel) EXPECT_GE(sun.irradiance[channel], 0);
        }
    Sky nowhere;
    nowhere.sunDirection = {0, 0, 0};
    EXPECT_EQ(skySun(nowhere).direction, DVec3(0, 1, 0));
}

// Preetham's formula by hand: chi = (4/9 - 3/120)(pi - pi/3) = 0.878465, Yz = 7.1649 tan chi
// + 1.7727 = 10.4040 kcd/m2.
TEST(Sky, ZenithLuminanceIsThePapers) {
    EXPECT_NEAR(zenithLuminance(makeSky(60, 3)) / (10.404 * kSkyUnitsPerKilocandela), 1, 0.02);
}

TEST(Sky, NoonIsExposedAsPromised) {
    EXPECT_NEAR(zenithLuminance(makeSky(60, 3)), 0.31, 0.01);
    EXPECT_NEAR(luminance(skySun(makeSky(60, 3)).irradiance), 2.7, 0.1);
}

TEST(Sky, BrightestTowardsTheSun) {
    const Image image = skyImage(makeSky(40, 3, 60), kWidth);
    int brightest = 0;
    for (int i = 0; i < kWidth * kWidth / 2; ++i)
        if (image.rgb[static_cast<std::size_t>(3 * i + 1)] >
            image.rgb[static_cast<std::size_t>(3 * brightest + 1)])
            brightest = i;
    EXPECT_NEAR(brightest % kWidth + 0.5, kWidth * (0.5 + 60.0 / 360), 1.0);
    EXPECT_NEAR(brightest / kWidth + 0.5, kWidth / 2 * 50.0 / 180, 1.5);
}

TEST(Sky, ClearSkyIsBlueAndLowSunRed) {
    const Image noon = skyImage(makeSky(60, 3), kWidth);
    EXPECT_GT(texel(noon, 0, 10).z, 1.5f * texel(noon, 0, 10).x);
    const Rgb high = skySun(makeSky(60, 3)).irradiance, low = skySun(makeSky(5, 3)).irradiance;
    EXPECT_GT(low.x / low.z, 3 * high.x / high.z);
}

TEST(Sky, GroundReflectsWhatFallsOnIt) {
    const Sky sky = makeSky(35, 4, -100);
    const Image image = skyImage(sky, kWidth);
    const int height = kWidth / 2;
    double irradiance = skySun(sky).irradiance.y * skySun(sky).direction.y;
    for (int y = 0; y < height / 2; ++y) {
        const double theta = kPi * (y + 0.5) / height;
        for (int x = 0; x < kWidth; ++x)
            irradiance += texel(image, x, y).y * std::cos(theta) * std::sin(theta) *
                          (2 * kPi / kWidth) * (kPi / height);
    }
    EXPECT_NEAR(texel(image, 5, height - 3).y / (0.2 / kPi * irradiance), 1, 1e-5);
}

TEST(Sky, DarkensSteadilyAsTheSunSinks) {
    double last = zenithLuminance(makeSky(2.25, 3));
    for (double elevation = 2; elevation > -20; elevation -= 0.25) {
        const double now = zenithLuminance(makeSky(elevation, 3));
        EXPECT_LT(now, last) << elevation;
        EXPECT_GT(now, 0.7 * last) << "a jump at " << elevation;
        last = now;
    }
}

// Some 90 to 105 klx reach a facing surface from a high sun in clear air (CIE S 011, IES handbook).
TEST(SkySun, HighSunHasTheMeasuredIlluminance) {
    const double klx = luminance(skySun(makeSky(70, 2.5)).irradiance) / kSkyUnitsPerKilocandela;
    EXPECT_GT(klx, 85);
    EXPECT_LT(klx, 110);
}

TEST(SkySun, FadesWithHazeAndTowardsTheHorizonAndIsGoneBelow) {
    for (int i = 1; i < 10; ++i)
        EXPECT_LT(luminance(skySun(makeSky(45, i + 1)).irradiance),
                  luminance(skySun(makeSky(45, i)).irradiance) + (i == 1 ? 1e-6f : 0.0f));
    float last = 0;
    for (const double elevation : kElevations) {
        const float now = luminance(skySun(makeSky(elevation, 2)).irradiance);
        EXPECT_EQ(now > 0, elevation > -0.265) << elevation;
        EXPECT_GE(now, last) << elevation;
        last = now;
    }
}

TEST(SkySun, DirectionIsTowardsTheSun) {
    Sky sky;
    sky.sunDirection = {0, 3, -4};
    EXPECT_LT(glm::length(skySun(sky).direction - DVec3(0, 0.6, -0.8)), 1e-15);
}

}  // namespace
}  // namespace glint
