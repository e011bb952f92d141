// Sun: light from infinitely far, a disc on the sky or (angle 0) a single direction.
#pragma once

#include "tracer/base/reflect.h"
#include "tracer/color/rgb.h"

namespace glint {

struct SunLight {
    DVec3 direction{-0.5, -1, -0.5};
    Color irradiance{3, 3, 3};
    double angleDegrees = 0.53;

    bool operator==(const SunLight&) const = default;
    static constexpr std::string_view kind = "sun";
    static constexpr auto fields() {
        return std::tuple{
            Field{
                "direction", &SunLight::direction, {.doc = "Direction in which the light travels"}},
            Field{"irradiance",
                  &SunLight::irradiance,
                  {.min = 0, .unit = "W/m2", .doc = "On a plane that faces the sun"}},
            Field{"angle_degrees",
                  &SunLight::angleDegrees,
                  {.min = 0,
                   .max = 180,
                   .unit = "deg",
                   .doc = "Full angle of the disc; 0 is a single direction without a disc"}}};
    }
};

}  // namespace glint
