// The pictures in resources/env: what the generator promises of them.
#include "tracer/cli/environments.h"
#include "tests/support/paths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tracer/cli/environment_canvas.h"
#include "tracer/io/film_exr.h"
#include "tracer/lights/atmosphere.h"

namespace glint {
namespace {

/// Irradiance of the texels within `radius` [rad] of `axis` on a plane that faces it.
DVec3 irradianceAround(const Image& image, const DVec3& axis, double radius) {
    const LatLongCanvas grid(image.width);
    DVec3 sum(0.0);
    for (int row = 0; row < image.height; ++row)
        for (int column = 0; column < image.width; ++column) {
            const DVec3 d =
                latLongDirection((column + 0.5) / image.width, (row + 0.5) / image.height);
            const double cosine = glm::dot(d, axis);
            if (cosine < std::cos(radius)) continue;
            const auto i = 3 * static_cast<std::size_t>(row * image.width + column);
            sum += DVec3(image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]) *
                   (cosine * grid.texelSolidAngle(row));
        }
    return sum;
}

DVec3 brightestDirection(const Image& image) {
    const auto at = std::max_element(image.rgb.begin(), image.rgb.end()) - image.rgb.begin();
    const auto texel = static_cast<int>(at / 3);
    return latLongDirection((texel % image.width + 0.5) / image.width,
                            (texel / image.width + 0.5) / image.height);
}

TEST(LatLong, MiddleOfThePictureIsMinusZ) {
    EXPECT_LT(glm::length(latLongDirection(0.5, 0.5) - DVec3(0, 0, -1)), 1e-15);
    EXPECT_LT(glm::length(latLongDirection(0.75, 0.5) - DVec3(1, 0, 0)), 1e-15);
    EXPECT_LT(glm::length(latLongDirection(0.3, 0) - DVec3(0, 1, 0)), 1e-15);
}

TEST(LatLong, UvIsTheInverseOfDirection) {
    for (double u = 0.05; u < 1; u += 0.1)
        for (double v = 0.05; v < 1; v += 0.1)
            EXPECT_LT(glm::length(latLongUv(latLongDirection(u, v)) - DVec2(u, v)), 1e-14)
                << u << " " << v;
}

TEST(LatLongCanvas, TexelsCoverTheSphere) {
    const LatLongCanvas canvas(64);
    double sum = 0;
    for (int row = 0; row < canvas.height(); ++row)
        sum += canvas.width() * canvas.texelSolidAngle(row);
    EXPECT_NEAR(sum, 4 * kPi, 1e-12);
}

// The disc is smaller than a texel at the first width and spreads over many at the last.
TEST(LatLongCanvas, DiscKeepsItsIrradianceAtEveryResolution) {
    const double radius = 0.02, radiance = 1000;
    const double exact = kPi * std::sin(radius) * std::sin(radius) * radiance;
    for (const int width : {16, 64, 512})
        for (const DVec3& axis :
             {DVec3(0, 1, 0), DVec3(0, 0, 1), glm::normalize(DVec3(0.3, -0.8, 0.1))}) {
            LatLongCanvas canvas(width);
            canvas.addDisc(axis, radius, DVec3(radiance));
            double power = 0;
            const Image image = canvas.image();
            for (int row = 0; row < image.height; ++row)
                for (int column = 0; column < image.width; ++column)
                    power += image.rgb[3 * static_cast<std::size_t>(row * image.width + column)] *
                             canvas.texelSolidAngle(row);
            EXPECT_NEAR(power / exact, 1, 1e-3) << "width " << width;
        }
}

TEST(Environments, AreFiniteAndNotNegative) {
    for (const EnvironmentRecipe& recipe : environmentRecipes()) {
        const Image image = recipe.make(64);
        EXPECT_EQ(image.width, 64);
        EXPECT_EQ(image.height, 32);
        ASSERT_EQ(image.rgb.size(), 64u * 32u * 3u);
        for (const float x : image.rgb)
            ASSERT_TRUE(std::isfinite(x) && x >= 0) << recipe.name << ": " << x;
    }
}

TEST(Environments, AreTheSameEveryTime) {
    for (const EnvironmentRecipe& recipe : environmentRecipes())
        EXPECT_EQ(recipe.make(64).rgb, recipe.make(64).rgb) << recipe.name;
}

TEST(Environments, NumbersHoldAtMostElevenBits) {
    for (const float x : makeStudio(64).rgb) {
        int exponent = 0;
        const float mantissa = std::ldexp(std::frexp(x, &exponent), 11);
        ASSERT_EQ(mantissa, std::round(mantissa));
    }
}

// Sky and sun as the eye has them: a clear sky gives a tenth to a third of what the sun gives, the
// sun is warmer than it.
TEST(Environments, SunOfTheSkyIsStrongAndWarm) {
    const Image image = makeSky(256);
    const DVec3 sun = irradianceAround(image, brightestDirection(image), 0.03);
    const DVec3 all = irradianceAround(image, DVec3(0, 1, 0), kPi / 2);
    EXPECT_GT(sun.g, 4);
    EXPECT_LT(sun.g, 8);
    EXPECT_GT(sun.r, sun.b);
    const double fromSky = all.g - sun.g * brightestDirection(image).y;
    EXPECT_GT(fromSky, 0.1 * sun.g);
    EXPECT_LT(fromSky, 0.4 * sun.g);
}

TEST(Environments, SunHasTheSameIrradianceAtEveryResolution) {
    const DVec3 coarse = irradianceAround(makeSky(128), brightestDirection(makeSky(128)), 0.06);
    const DVec3 fine = irradianceAround(makeSky(512), brightestDirection(makeSky(512)), 0.06);
    EXPECT_NEAR(coarse.g / fine.g, 1, 0.02);
}

TEST(Environments, OvercastZenithIsThreeTimesTheHorizon) {
    const Image image = makeOvercast(128);
    const auto rowMean = [&](int row) {
        double sum = 0;
        for (int column = 0; column < image.width; ++column)
            sum += image.rgb[3 * static_cast<std::size_t>(row * image.width + column)];
        return sum / image.width;
    };
    EXPECT_NEAR(rowMean(0) / rowMean(image.height / 2 - 1), 3, 0.6);
}

TEST(Environments, CommittedStudioIsWhatTheProgramMakes) {
    const Result<ExrFile> file = loadExr(test::inSource("resources/env/studio.exr"));
    ASSERT_TRUE(file) << file.error().text();
    const Image made = makeStudio(kEnvironmentWidth);
    ASSERT_EQ(file.value().width, made.width);
    ASSERT_EQ(file.value().height, made.height);
    for (const ExrChannel& channel : file.value().channels) {
        ASSERT_EQ(channel.name.size(), 1u);
        const std::size_t k = std::string("RGB").find(channel.name);
        for (std::size_t i = 0; i < channel.values.size(); ++i)
            ASSERT_EQ(channel.values[i], made.rgb[3 * i + k]) << channel.name << " of texel " << i;
    }
}

TEST(Atmosphere, SkyIsBlueOverheadAndBrighterAtTheHorizon) {
    const Atmosphere air(DVec3(0, 1, -1), 2, 1);
    const DVec3 zenith = air.radiance(DVec3(0, 1, 0), DVec3(0.2));
    const DVec3 horizon = air.radiance(glm::normalize(DVec3(0, 0.03, 1)), DVec3(0.2));
    EXPECT_GT(zenith.b, 1.5 * zenith.r);
    EXPECT_GT(horizon.g, 1.5 * zenith.g);
}

// Beer's law through the closed form of exponential layers, for the sun at the zenith in pure air.
TEST(Atmosphere, ZenithSunFadesByTheOpticalDepthOfPureAir) {
    const DVec3 seen = Atmosphere(DVec3(0, 1, 0), 1, 1).sunIrradianceAt(0);
    const DVec3 air = DVec3(5.802e-6, 13.558e-6, 33.1e-6) * 8000.0 * (1 - std::exp(-100e3 / 8000));
    const DVec3 ozone = DVec3(0.650e-6, 1.881e-6, 0.085e-6) * 15000.0;
    for (int k = 0; k < 3; ++k)
        EXPECT_NEAR(seen[k], std::exp(-air[k] - ozone[k]), 1e-3) << "channel " << k;
}

TEST(Atmosphere, LowSunIsRed) {
    const DVec3 low = Atmosphere(DVec3(0, 0.05, -1), 2, 1).sunIrradiance();
    EXPECT_GT(low.r, 2 * low.g);
    EXPECT_GT(low.g, 2 * low.b);
}

}  // namespace
}  // namespace glint
