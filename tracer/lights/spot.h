// Spot light: a point light in a cone with a soft rim.
#pragma once

#include "tracer/base/reflect.h"
#include "tracer/color/rgb.h"

namespace glint {

struct SpotLight {
    DVec3 position{0, 3, 0};
    DVec3 target{0, 0, 0};
    Color intensity{10, 10, 10};
    double coneDegrees = 40;
    double blend = 0.15;

    bool operator==(const SpotLight&) const = default;
    static constexpr std::string_view kind = "spot";
    static constexpr auto fields() {
        return std::tuple{
            Field{"position", &SpotLight::position, {.unit = "m", .doc = "Place"}},
            Field{"target",
                  &SpotLight::target,
                  {.unit = "m", .doc = "Point that the axis goes through"}},
            Field{"intensity",
                  &SpotLight::intensity,
                  {.min = 0, .unit = "W/sr", .doc = "Radiant intensity on the axis"}},
            Field{"cone_degrees",
                  &SpotLight::coneDegrees,
                  {.min = 0,
                   .max = 180,
                   .exclusiveMin = true,
                   .unit = "deg",
                   .doc = "Full angle of the cone"}},
            Field{"blend",
                  &SpotLight::blend,
                  {.min = 0, .max = 1, .doc = "Share of the half angle over which the rim fades"}}};
    }
};

}  // namespace glint
