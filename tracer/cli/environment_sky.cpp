// Skies: sky, sunset, overcast. Scale: the sun above the atmosphere gives an irradiance of 8; at
// sunset 1.6 times as much, as a photographer would open the lens.
#include "tracer/cli/environment_canvas.h"
#include "tracer/cli/environments.h"
#include "tracer/cli/value_noise.h"
#include "tracer/lights/atmosphere.h"

namespace glint {

namespace {

constexpr double kSolarIrradiance = 8;
constexpr double kSunAngularRadius = 0.265 * kPi / 180;

/// Albedo of fields seen from a hill.
DVec3 groundAlbedo(const DVec3& d) {
    if (d.y >= 0) return DVec3(0.0);
    const double field = fractalNoise(DVec2(d.x, d.z) / (0.02 - d.y) * 1.5, 5);
    return glm::mix(DVec3(0.09, 0.11, 0.05), DVec3(0.21, 0.19, 0.12),
                    glm::smoothstep(0.3, 0.7, field));
}

DVec3 directionOf(double azimuthDegrees, double elevationDegrees) {
    const double a = degreesToRadians(azimuthDegrees), e = degreesToRadians(elevationDegrees);
    return {std::cos(e) * std::sin(a), std::sin(e), -std::cos(e) * std::cos(a)};
}

/// Henyey and Greenstein 1941, scaled to 1 for g = 0.
double forwardScattering(double cosine, double g) {
    return (1 - g * g) / std::pow(1 + g * g - 2 * g * cosine, 1.5);
}

/// A thin sheet of high cloud.
struct Cirrus {
    double height = 8000;  ///< [m]
    double amount = 0.3;   ///< share of the sky
    double opacity = 0.5;  ///< of the densest places
    double size = 6000;    ///< of the largest tufts [m]
};

/// How much of the light from behind the sheet is taken by it in direction `d`.
double cirrusCover(const Cirrus& cloud, const DVec3& d) {
    if (d.y <= 0) return 0;
    // Distance to the sheet over a round ground, so that it ends at the horizon instead of going on
    // for ever.
    constexpr double kRadius = 6360e3;
    const double b = kRadius * d.y;
    const double t = -b + std::sqrt(b * b + cloud.height * (2 * kRadius + cloud.height));
    const DVec2 p = DVec2(d.x, d.z) * (t / cloud.size);
    // Long streaks: stretched along one direction, and warped by a second noise.
    const DVec2 streak(0.45 * p.x + 0.2 * p.y, 1.3 * p.y - 0.5 * p.x);
    const double warp = fractalNoise(streak * 0.7 + DVec2(3.7, 1.9), 3);
    const double density = fractalNoise(streak + DVec2(1.8 * warp, 0.9 * warp), 6);
    const double edge = 1 - cloud.amount;
    // Detail finer than a texel is faded out towards the horizon.
    return cloud.opacity * glm::smoothstep(edge - 0.28, edge + 0.22, density) *
           glm::smoothstep(0.0, 0.12, d.y);
}

Image makeClearSky(int width, const Atmosphere& air, const Cirrus& cloud) {
    const DVec3 sunlight = air.sunIrradianceAt(cloud.height);
    LatLongCanvas canvas(width);
    canvas.paint(1, [&](const DVec3& d) {
        const double cover = cirrusCover(cloud, d);
        const DVec3 sky = air.radiance(d, groundAlbedo(d));
        if (cover == 0) return sky;
        // Ice scatters mostly forwards, and lights up where the sun stands behind; the sky's light
        // comes on top.
        const double cosine = glm::dot(d, air.towardsSun());
        const double phase =
            0.5 * forwardScattering(cosine, 0.6) + 0.5 * forwardScattering(cosine, -0.1);
        return glm::mix(sky, sunlight * (phase / (4 * kPi)) * 0.8 + sky * 0.9, cover);
    });
    const double solidAngle = 2 * kPi * (1 - std::cos(kSunAngularRadius));
    canvas.addDisc(air.towardsSun(), kSunAngularRadius, air.sunIrradiance() / solidAngle);
    return canvas.image();
}

}  // namespace

Image makeSky(int width) {
    return makeClearSky(width, Atmosphere(directionOf(-140, 42), 2.2, kSolarIrradiance),
                        {8000, 0.33, 0.6, 3000});
}

Image makeSunset(int width) {
    return makeClearSky(width, Atmosphere(directionOf(28, 4), 2.2, 1.6 * kSolarIrradiance),
                        {7000, 0.44, 0.75, 3500});
}

// Moon and Spencer's overcast sky, L = Lz (1 + 2 sin elevation) / 3, as in CIE S 011, with the
// texture of low clouds.
Image makeOvercast(int width) {
    const DVec3 zenith(0.92, 0.97, 1.04), ground(0.14, 0.14, 0.125);
    LatLongCanvas canvas(width);
    canvas.paint(2, [&](const DVec3& d) {
        if (d.y < 0) return ground * (1 + 0.9 * std::exp(d.y * 12));
        const DVec2 p = DVec2(d.x, d.z) / (d.y + 0.18);
        const double warp = fractalNoise(p * 0.8, 4);
        const double clouds = fractalNoise(p * 1.3 + DVec2(2.2 * warp, -1.4 * warp), 6) - 0.5;
        const double fade = glm::smoothstep(0.0, 0.25, d.y);
        return zenith * ((1 + 2 * d.y) / 3 * (1 + 0.75 * clouds * fade));
    });
    return canvas.image();
}

}  // namespace glint
