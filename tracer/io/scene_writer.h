// The document -> the JSON value of a scene file, by the field tables.
#pragma once

#include "tracer/io/json_text.h"
#include "tracer/scene/scene.h"

namespace glint {

/// What the file says about fields that have their default value.
enum class Defaults { LeftOut, Written };

[[nodiscard]] Json sceneJson(const Scene& scene, Defaults defaults);

}  // namespace glint
