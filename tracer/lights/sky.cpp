#include "tracer/lights/sky.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "tracer/base/check.h"

namespace glint {
namespace {

constexpr double kMinTurbidity = 2, kMaxTurbidity = 10;
constexpr double kSunAngleDegrees = 0.53;
constexpr double kGroundAlbedo = 0.2;
/// Grazing rays cross a long but finite way of air; the formula divides by this cosine.
constexpr double kMinViewCosine = 0.01;

double clampedTurbidity(const Sky& sky) {
    return std::clamp(sky.turbidity, kMinTurbidity, kMaxTurbidity);
}

DVec3 towardsSun(const Sky& sky) {
    const double length = glm::length(sky.sunDirection);
    return length > 0 ? sky.sunDirection / length : DVec3(0, 1, 0);
}

double elevationDegrees(const DVec3& sun) {
    return radiansToDegrees(std::asin(std::clamp(sun.y, -1.0, 1.0)));
}

/// CIE XYZ to linear Rec.709 (IEC 61966-2-1), where no channel can be below 0.
DVec3 rec709FromXyz(const DVec3& c) {
    return glm::max(DVec3(3.2406 * c.x - 1.5372 * c.y - 0.4986 * c.z,
                          -0.9689 * c.x + 1.8758 * c.y + 0.0415 * c.z,
                          0.0557 * c.x - 0.2040 * c.y + 1.0570 * c.z),
                    DVec3(0.0));
}

/// Distribution over the sky of one quantity: Perez's five parameters, linear in turbidity.
struct Perez {
    double a, b, c, d, e;

    [[nodiscard]] double operator()(double cosTheta, double gamma) const {
        const double cosGamma = std::cos(gamma);
        return (1 + a * std::exp(b / cosTheta)) *
               (1 + c * std::exp(d * gamma) + e * cosGamma * cosGamma);
    }
};

/// Preetham's sky for one sun: luminance and chromaticity (Y in kcd/m2, x, y) of a direction.
class DaylightModel {
  public:
    /// thetaSun: from the zenith to the sun, at most pi / 2.
    DaylightModel(double t, double thetaSun)
        : luminance_{0.1787 * t - 1.4630, -0.3554 * t + 0.4275, -0.0227 * t + 5.3251,
                     0.1206 * t - 2.5771, -0.0670 * t + 0.3703},
          x_{-0.0193 * t - 0.2592, -0.0665 * t + 0.0008, -0.0004 * t + 0.2125, -0.0641 * t - 0.8989,
             -0.0033 * t + 0.0452},
          y_{-0.0167 * t - 0.2608, -0.0950 * t + 0.0092, -0.0079 * t + 0.2102, -0.0441 * t - 1.6537,
             -0.0109 * t + 0.0529} {
        const DVec3 zenith(zenithLuminance(t, thetaSun), zenithX(t, thetaSun),
                           zenithY(t, thetaSun));
        scale_ = zenith / DVec3(luminance_(1, thetaSun), x_(1, thetaSun), y_(1, thetaSun));
    }

    /// XYZ in kcd/m2; gamma: from the direction to the sun.
    [[nodiscard]] DVec3 xyz(double cosTheta, double gamma) const {
        const double luminance = scale_.x * luminance_(cosTheta, gamma);
        const double x = scale_.y * x_(cosTheta, gamma), y = scale_.z * y_(cosTheta, gamma);
        return DVec3(x, y, 1 - x - y) * (luminance / y);
    }

  private:
    static double zenithLuminance(double t, double thetaSun) {
        const double chi = (4.0 / 9 - t / 120) * (kPi - 2 * thetaSun);
        return (4.0453 * t - 4.9710) * std::tan(chi) - 0.2155 * t + 2.4192;
    }
    static double cubic(double s, double c3, double c2, double c1, double c0) {
        return ((c3 * s + c2) * s + c1) * s + c0;
    }
    static double zenithX(double t, double s) {
        return (cubic(s, 0.00166, -0.00375, 0.00209, 0) * t +
                cubic(s, -0.02903, 0.06377, -0.03202, 0.00394)) *
                   t +
               cubic(s, 0.11693, -0.21196, 0.06052, 0.25886);
    }
    static double zenithY(double t, double s) {
        return (cubic(s, 0.00275, -0.00610, 0.00317, 0) * t +
                cubic(s, -0.04214, 0.08970, -0.04153, 0.00516)) *
                   t +
               cubic(s, 0.15346, -0.26756, 0.06670, 0.26688);
    }

    Perez luminance_, x_, y_;
    DVec3 scale_{1.0};
};

/// One of the lobes that make up the colour matching functions of Wyman, Sloan and Shirley, "Simple
/// Analytic Approximations to the CIE XYZ Color Matching Functions", JCGT 2(2), 2013. Lengths in
/// nm.
double lobe(double nm, double center, double below, double above) {
    const double t = (nm - center) * (nm < center ? below : above);
    return std::exp(-0.5 * t * t);
}
DVec3 colorMatching(double nm) {
    return {0.362 * lobe(nm, 442.0, 0.0624, 0.0374) + 1.056 * lobe(nm, 599.8, 0.0264, 0.0323) -
                0.065 * lobe(nm, 501.1, 0.0490, 0.0382),
            0.821 * lobe(nm, 568.8, 0.0213, 0.0247) + 0.286 * lobe(nm, 530.9, 0.0613, 0.0322),
            1.217 * lobe(nm, 437.0, 0.0845, 0.0278) + 0.681 * lobe(nm, 459.0, 0.0385, 0.0725)};
}

/// Planck's law up to a factor.
double blackBody(double nm, double kelvin) {
    constexpr double kSecondRadiationConstant = 1.438777e7;  // nm K
    return 1e15 / (std::pow(nm, 5) * std::expm1(kSecondRadiationConstant / (nm * kelvin)));
}

/// Absorption of ozone in 1/cm, every 10 nm from 450 nm (Preetham 1999, table 2).
constexpr std::array<double, 33> kOzone = {
    0.003, 0.006, 0.009, 0.014, 0.021, 0.030, 0.040, 0.048, 0.063, 0.075, 0.085,
    0.103, 0.120, 0.120, 0.115, 0.125, 0.120, 0.105, 0.090, 0.079, 0.067, 0.057,
    0.048, 0.036, 0.028, 0.023, 0.018, 0.014, 0.011, 0.010, 0.009, 0.007, 0.004};

/// Share of sunlight of the wavelength number i (380 nm + 10 nm i) that gets through `mass` times
/// the air overhead.
double transmittance(int i, double mass, double turbidity) {
    constexpr double kOzoneCentimetres = 0.35, kHazeExponent = 1.3;
    const double micrometres = 0.38 + 0.01 * i, haze = 0.04608 * turbidity - 0.04586;
    const double ozone = i >= 7 && i < 40 ? kOzone[static_cast<std::size_t>(i - 7)] : 0.0;
    return std::exp(-mass *
                    (0.008735 * std::pow(micrometres, -4.08) +
                     haze * std::pow(micrometres, -kHazeExponent) + ozone * kOzoneCentimetres));
}

/// XYZ illuminance in klx of the sun on a facing plane, through `mass` times the air overhead.
DVec3 sunXyz(double mass, double turbidity) {
    constexpr int kWavelengths = 41;
    constexpr double kSunKelvin = 5778, kIlluminanceOutside = 133;
    DVec3 sum(0.0);
    double outside = 0;
    for (int i = 0; i < kWavelengths; ++i) {
        const double nm = 380 + 10.0 * i;
        const DVec3 c = colorMatching(nm) * blackBody(nm, kSunKelvin);
        outside += c.y;
        sum += c * transmittance(i, mass, turbidity);
    }
    return sum * (kIlluminanceOutside / outside);
}

/// Share of the sun's disc above the horizon, as a function of the elevation of its centre.
double risenShare(double elevation) {
    const double h = std::clamp(elevation / (0.5 * kSunAngleDegrees), -1.0, 1.0);
    return (std::acos(-h) + h * std::sqrt(1 - h * h)) / kPi;
}

/// What the sky brightens by from its value at sunset: about 400 lx fall to 3 lx in the first six
/// degrees and to 0.01 lx in twelve (Seidelmann, Explanatory Supplement to the Astronomical
/// Almanac, 1992, section 9.3).
double twilight(double elevation) { return elevation < 0 ? std::pow(10.0, 0.4 * elevation) : 1.0; }

}  // namespace

SkySun skySun(const Sky& sky) {
    SkySun out;
    out.direction = towardsSun(sky);
    out.angleDegrees = kSunAngleDegrees;
    const double elevation = elevationDegrees(out.direction), risen = std::max(elevation, 0.0);
    // Relative optical mass: Kasten's formula as Preetham gives it.
    const double mass =
        1 / (std::sin(degreesToRadians(risen)) + 0.15 * std::pow(3.885 + risen, -1.253));
    const DVec3 xyz = sunXyz(mass, clampedTurbidity(sky));
    out.irradiance =
        toFloat(rec709FromXyz(xyz) * (kSkyUnitsPerKilocandela * risenShare(elevation)));
    return out;
}

Image skyImage(const Sky& sky, int width) {
    GLINT_CHECK(width >= 2);
    const int height = width / 2, horizon = (height + 1) / 2;
    Image image{width, height, {}};
    image.rgb.resize(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));

    const SkySun sun = skySun(sky);
    const double elevation = elevationDegrees(sun.direction);
    const DaylightModel model(clampedTurbidity(sky),
                              degreesToRadians(90 - std::max(elevation, 0.0)));
    const double units = kSkyUnitsPerKilocandela * twilight(elevation);
    float* out = image.rgb.data();
    const auto put = [&out](const Rgb& c) {
        for (int channel = 0; channel < 3; ++channel) *out++ = c[channel];
    };

    DVec3 irradiance =
        toDouble(sun.irradiance) * std::max(0.0, sun.direction.y);  // On level ground.
    for (int y = 0; y < horizon; ++y) {
        const double theta = kPi * (y + 0.5) / height, sinTheta = std::sin(theta),
                     cosTheta = std::cos(theta);
        const double viewCosine = std::max(cosTheta, kMinViewCosine);
        DVec3 row(0.0);
        for (int x = 0; x < width; ++x) {
            const double phi = 2 * kPi * ((x + 0.5) / width - 0.5);
            const DVec3 direction(sinTheta * std::sin(phi), cosTheta, -sinTheta * std::cos(phi));
            const double gamma =
                std::acos(std::clamp(glm::dot(direction, sun.direction), -1.0, 1.0));
            const DVec3 radiance = rec709FromXyz(model.xyz(viewCosine, gamma)) * units;
            row += radiance;
            put(toFloat(radiance));
        }
        irradiance +=
            row * (std::max(0.0, cosTheta) * sinTheta * (kPi / height) * (2 * kPi / width));
    }
    const Rgb ground = toFloat(irradiance * (kGroundAlbedo / kPi));
    for (int i = horizon * width; i < height * width; ++i) put(ground);
    return image;
}

}  // namespace glint
