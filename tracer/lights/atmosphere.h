// The clear daylight sky: light of the sun scattered by air, haze and ozone over a round planet.
// Model: Hillaire 2020, "A Scalable and Production Ready Sky and Atmosphere Rendering Technique"
// (EGSR), with the coefficients of Bruneton and Neyret 2008 (revised 2017) at 680, 550 and 440 nm
// taken as linear Rec.709.
#pragma once

#include <vector>

#include "tracer/math/types.h"

namespace glint {

/// Radiance of the sky for one place of the sun. Making it takes some 0.3 s; radiance() may be
/// called from any thread.
class Atmosphere {
  public:
    /// `towardsSun` need not have unit length; y is up. `turbidity` 1 is pure air, 2 clear, 10
    /// hazy. `solarIrradiance` is the sun's above the atmosphere on a facing plane, in every
    /// channel.
    Atmosphere(const DVec3& towardsSun, double turbidity, double solarIrradiance);

    /// Radiance that arrives from unit direction `d` at a viewer 50 m above the ground, without the
    /// sun's disc. Below the horizon: Lambertian ground of the given albedo under the haze in
    /// between.
    [[nodiscard]] DVec3 radiance(const DVec3& d, const DVec3& groundAlbedo) const;
    /// Irradiance of the disc at the viewer on a facing plane.
    [[nodiscard]] DVec3 sunIrradiance() const;
    /// The same at a height above the viewer's ground [m], for whatever floats there.
    [[nodiscard]] DVec3 sunIrradianceAt(double height) const;
    /// Unit vector.
    [[nodiscard]] const DVec3& towardsSun() const { return sun_; }

  private:
    /// What a metre of atmosphere does at one height.
    struct Medium {
        DVec3 rayleigh, extinction;  ///< [1/m]
        double mie = 0;              ///< scattering [1/m]
    };
    /// Grid over (height, cosine of the sun's zenith angle).
    struct Grid {
        int heights = 0, cosines = 0;
        std::vector<DVec3> values;  ///< heights x cosines, row-major
        [[nodiscard]] DVec3 at(double height, double cosine) const;
    };
    /// Light gathered along a ray, and what is left of the light from its end.
    struct March {
        DVec3 light{0.0}, transmittance{1.0};
        DVec3 scattered{0.0};  ///< share of isotropic light of radiance 1 everywhere that is
                               ///< scattered towards the viewer
    };
    enum class Light { SunOnly, All };

    [[nodiscard]] Medium mediumAt(double height) const;
    [[nodiscard]] DVec3 opticalTransmittance(const DVec3& from, const DVec3& d) const;
    [[nodiscard]] DVec3 multipleScattering(double height, double sunCosine) const;
    [[nodiscard]] March march(const DVec3& from, const DVec3& d, double length, const DVec3& sun,
                              int steps, Light light) const;
    [[nodiscard]] DVec3 inScattering(const Medium& medium, const DVec3& at, double cosine,
                                     const DVec3& sun, Light light) const;
    template <class Value>
    [[nodiscard]] static Grid tabulate(int heights, int cosines, Value&& value);

    DVec3 sun_;
    double haze_, solarIrradiance_;
    Grid transmittance_, multiple_;
};

}  // namespace glint
