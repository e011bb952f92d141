// What lies under a pixel of the viewport: one exact ray through the compiled scene.
#pragma once

#include <optional>

#include "tracer/math/ray.h"
#include "tracer/scene/ids.h"

namespace glint {

struct RenderScene;

struct Pick {
    ObjectId object;
    DVec3 position{0.0};  ///< world space, metres
    DVec3 normal{0.0};    ///< unit, outward
    double distance = 0;  ///< from the camera, metres
};

/// The first surface under the point (x, y) of a picture of width x height, in pixels from the top
/// left corner.
[[nodiscard]] std::optional<Pick> pick(const RenderScene& scene, int width, int height, double x,
                                       double y);

}  // namespace glint
