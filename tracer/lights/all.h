// Every light without a surface. Emissive objects are lights too: see compile/light_table.h.
#pragma once

#include "tracer/lights/point.h"
#include "tracer/lights/spot.h"
#include "tracer/lights/sun.h"

namespace glint {

using AllLights = TypeList<PointLight, SpotLight, SunLight>;

}  // namespace glint
