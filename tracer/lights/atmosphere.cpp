#include "tracer/lights/atmosphere.h"

#include <algorithm>

namespace glint {

namespace {

constexpr double kGroundRadius = 6360e3, kTopRadius = 6460e3;  // [m]
constexpr double kViewerHeight = 50;                           // [m]
constexpr double kMieAsymmetry = 0.8;
constexpr int kViewSteps = 40;
// Where the sun may still light the air although it is below the horizon: the grids' smallest
// cosine.
constexpr double kLowestCosine = -0.3;

// Grid rows are spaced by the square root of height, because the air is densest below.
double heightOfRow(double share) { return share * share * (kTopRadius - kGroundRadius); }
double rowOfHeight(double height) {
    return std::sqrt(std::clamp(height / (kTopRadius - kGroundRadius), 0.0, 1.0));
}

/// Distance from `from` along unit `d` to where it leaves the sphere of `radius` about the origin;
/// negative if it misses.
double distanceOut(const DVec3& from, const DVec3& d, double radius) {
    const double b = glm::dot(from, d), c = glm::dot(from, from) - radius * radius;
    const double discriminant = b * b - c;
    return discriminant < 0 ? -1 : -b + std::sqrt(discriminant);
}

/// Distance to where the ray enters the ground; negative if it does not.
double distanceToGround(const DVec3& from, const DVec3& d) {
    const double b = glm::dot(from, d), c = glm::dot(from, from) - kGroundRadius * kGroundRadius;
    const double discriminant = b * b - c;
    return discriminant < 0 || b > 0 ? -1 : -b - std::sqrt(discriminant);
}

double rayleighPhase(double cosine) { return 3 / (16 * kPi) * (1 + cosine * cosine); }

/// Cornette and Shanks 1992.
double miePhase(double cosine) {
    const double g2 = kMieAsymmetry * kMieAsymmetry;
    return 3 / (8 * kPi) * (1 - g2) * (1 + cosine * cosine) /
           ((2 + g2) * std::pow(1 + g2 - 2 * kMieAsymmetry * cosine, 1.5));
}

double heightAt(const DVec3& p) { return glm::length(p) - kGroundRadius; }

}  // namespace

DVec3 Atmosphere::Grid::at(double height, double cosine) const {
    const double x = rowOfHeight(height) * (heights - 1);
    const double y =
        std::clamp((cosine - kLowestCosine) / (1 - kLowestCosine), 0.0, 1.0) * (cosines - 1);
    const int i = std::min(static_cast<int>(x), heights - 2),
              j = std::min(static_cast<int>(y), cosines - 2);
    const auto cell = [&](int row, int column) {
        return values[static_cast<std::size_t>(row) * static_cast<std::size_t>(cosines) +
                      static_cast<std::size_t>(column)];
    };
    return glm::mix(glm::mix(cell(i, j), cell(i, j + 1), y - j),
                    glm::mix(cell(i + 1, j), cell(i + 1, j + 1), y - j), x - i);
}

template <class Value>
Atmosphere::Grid Atmosphere::tabulate(int heights, int cosines, Value&& value) {
    Grid grid{heights, cosines, {}};
    grid.values.reserve(static_cast<std::size_t>(heights) * static_cast<std::size_t>(cosines));
    for (int i = 0; i < heights; ++i)
        for (int j = 0; j < cosines; ++j) {
            const double cosine = kLowestCosine + (1 - kLowestCosine) * j / (cosines - 1);
            grid.values.push_back(value(heightOfRow(double(i) / (heights - 1)), cosine));
        }
    return grid;
}

Atmosphere::Atmosphere(const DVec3& towardsSun, double turbidity, double solarIrradiance)
    : sun_(glm::normalize(towardsSun)),
      haze_(std::max(turbidity - 1, 0.0)),
      solarIrradiance_(solarIrradiance) {
    transmittance_ = tabulate(64, 1024, [this](double height, double cosine) {
        const DVec3 d(std::sqrt(std::max(0.0, 1 - cosine * cosine)), cosine, 0);
        return opticalTransmittance(DVec3(0, kGroundRadius + height, 0), d);
    });
    multiple_ = tabulate(32, 64, [this](double height, double cosine) {
        return multipleScattering(height, cosine);
    });
}

Atmosphere::Medium Atmosphere::mediumAt(double height) const {
    const double air = std::exp(-height / 8000), haze = haze_ * std::exp(-height / 1200);
    const double ozone = std::max(0.0, 1 - std::abs(height - 25000) / 15000);
    const DVec3 rayleigh = DVec3(5.802e-6, 13.558e-6, 33.1e-6) * air;
    return {rayleigh,
            rayleigh + DVec3(0.650e-6, 1.881e-6, 0.085e-6) * ozone + DVec3(4.440e-6 * haze),
            3.996e-6 * haze};
}

DVec3 Atmosphere::opticalTransmittance(const DVec3& from, const DVec3& d) const {
    if (distanceToGround(from, d) >= 0) return DVec3(0.0);
    constexpr int kSteps = 64;
    const double length = distanceOut(from, d, kTopRadius);
    DVec3 depth(0.0);
    for (int i = 0; i < kSteps; ++i) {
        // Steps grow with the square of the distance, as the air thins out.
        const double a = double(i) / kSteps, b = double(i + 1) / kSteps;
        depth += mediumAt(heightAt(from + d * (length * (a * a + b * b) / 2))).extinction *
                 (length * (b * b - a * a));
    }
    return glm::exp(-depth);
}

DVec3 Atmosphere::inScattering(const Medium& medium, const DVec3& at, double cosine,
                               const DVec3& sun, Light light) const {
    const double height = heightAt(at), sunCosine = glm::dot(at, sun) / glm::length(at);
    const DVec3 direct = transmittance_.at(height, sunCosine);
    if (light == Light::SunOnly) return (medium.rayleigh + medium.mie) * direct / (4 * kPi);
    return direct * (medium.rayleigh * rayleighPhase(cosine) + medium.mie * miePhase(cosine)) +
           multiple_.at(height, sunCosine) * (medium.rayleigh + medium.mie);
}

Atmosphere::March Atmosphere::march(const DVec3& from, const DVec3& d, double length,
                                    const DVec3& sun, int steps, Light light) const {
    March result;
    const double cosine = glm::dot(d, sun);
    for (int i = 0; i < steps; ++i) {
        const double a = double(i) / steps, b = double(i + 1) / steps;
        const double t = length * (a * a + b * b) / 2, dt = length * (b * b - a * a);
        const Medium medium = mediumAt(heightAt(from + d * t));
        const DVec3 through = glm::exp(-medium.extinction * dt);
        // The integral over the step of what is scattered, with the medium taken as constant in it.
        const DVec3 weight = result.transmittance * (1.0 - through) / medium.extinction;
        result.light += weight * inScattering(medium, from + d * t, cosine, sun, light);
        result.scattered += weight * (medium.rayleigh + medium.mie);
        result.transmittance *= through;
    }
    return result;
}

// Section 5.5 of the paper: light of the second order averaged over the sphere, and the geometric
// sum of all further ones.
DVec3 Atmosphere::multipleScattering(double height, double sunCosine) const {
    constexpr int kDirections = 64, kSteps = 20;
    constexpr double kGroundAlbedo = 0.3;
    const DVec3 from(0, kGroundRadius + height + 1, 0);
    const DVec3 sun(std::sqrt(std::max(0.0, 1 - sunCosine * sunCosine)), sunCosine, 0);
    DVec3 second(0.0), again(0.0);
    for (int k = 0; k < kDirections; ++k) {
        // A spiral of equal areas.
        const double y = 1 - (2 * k + 1.0) / kDirections, r = std::sqrt(1 - y * y),
                     phi = k * kPi * (3 - std::sqrt(5.0));
        const DVec3 d(r * std::cos(phi), y, r * std::sin(phi));
        const double ground = distanceToGround(from, d);
        const March m = march(from, d, ground >= 0 ? ground : distanceOut(from, d, kTopRadius), sun,
                              kSteps, Light::SunOnly);
        second += m.light / double(kDirections);
        again += m.scattered / double(kDirections);
        if (ground >= 0) {
            const double groundCosine = glm::dot(glm::normalize(from + d * ground), sun);
            second += m.transmittance * transmittance_.at(0, groundCosine) *
                      (std::max(0.0, groundCosine) * kGroundAlbedo / kPi / kDirections);
        }
    }
    return second / (1.0 - again);
}

DVec3 Atmosphere::sunIrradianceAt(double height) const {
    return solarIrradiance_ * transmittance_.at(height, sun_.y);
}

DVec3 Atmosphere::sunIrradiance() const { return sunIrradianceAt(kViewerHeight); }

DVec3 Atmosphere::radiance(const DVec3& d, const DVec3& groundAlbedo) const {
    const DVec3 from(0, kGroundRadius + kViewerHeight, 0);
    const double ground = distanceToGround(from, d);
    const March m = march(from, d, ground >= 0 ? ground : distanceOut(from, d, kTopRadius), sun_,
                          kViewSteps, Light::All);
    DVec3 light = m.light;
    if (ground >= 0) {
        // Sun, and the scattered light taken as the same from everywhere.
        const double cosine = glm::dot(glm::normalize(from + d * ground), sun_);
        const DVec3 irradiance =
            transmittance_.at(0, cosine) * std::max(0.0, cosine) + multiple_.at(0, cosine) * kPi;
        light += m.transmittance * groundAlbedo * irradiance / kPi;
    }
    return light * solarIrradiance_;
}

}  // namespace glint
