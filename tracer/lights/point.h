// Point light: the same intensity in all directions.
#pragma once

#include "tracer/base/reflect.h"
#include "tracer/color/rgb.h"

namespace glint {

struct PointLight {
    DVec3 position{0, 3, 0};
    Color intensity{10, 10, 10};

    bool operator==(const PointLight&) const = default;
    static constexpr std::string_view kind = "point";
    static constexpr auto fields() {
        return std::tuple{Field{"position", &PointLight::position, {.unit = "m", .doc = "Place"}},
                          Field{"intensity",
                                &PointLight::intensity,
                                {.min = 0, .unit = "W/sr", .doc = "Radiant intensity"}}};
    }
};

}  // namespace glint
