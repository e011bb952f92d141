// The clear daylight sky: a picture for EnvironmentMap, and the sun as a light of its own.
// Model: Preetham, Shirley and Smits, "A Practical Analytic Model for Daylight", SIGGRAPH 1999. Not
// in here: clouds, stars.
#pragma once

#include "tracer/color/rgb.h"
#include "tracer/io/image_file.h"
#include "tracer/scene/scene.h"

namespace glint {

/// Radiance per luminance, W/(sr m2) per kcd/m2, and so also irradiance per illuminance in klx. It
/// is chosen so that a diffuse surface under a noon sun is well exposed at 0 EV: at turbidity 3 and
/// the sun 60 degrees high, the zenith is 0.31, the irradiance of the facing sun 2.7.
inline constexpr double kSkyUnitsPerKilocandela = 0.03;

/// Radiance of the sky without the sun's disc, and of the diffuse ground (albedo 0.2) that sky and
/// sun light, below the horizon. `width` x `width / 2` texels with the sun in its place by
/// sky.sunDirection (y up, any length; of length 0: the zenith). The model's fit ends at turbidity
/// 2 and 10; what lies beyond counts as these. A sun below the horizon leaves the sky of sunset,
/// darker by 0.4 powers of ten a degree, as measured in twilight.
[[nodiscard]] Image skyImage(const Sky& sky, int width = 1024);

/// The sun as seen through the air.
struct SkySun {
    DVec3 direction{0, 1, 0};  ///< towards the sun, unit length
    Rgb irradiance{
        0.0f};  ///< on a plane that faces the sun; 0 when the whole disc is below the horizon
    double angleDegrees = 0.53;
};

/// Spectrum of a black body of 5778 K with the illuminance of 133 klx outside the air, less
/// Rayleigh scattering, haze and ozone along the way (Preetham 1999, appendix A.1), as linear
/// Rec.709. The disc fades as it sets.
[[nodiscard]] SkySun skySun(const Sky& sky);

}  // namespace glint
