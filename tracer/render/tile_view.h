// What camera rays through some pixels can meet.
#pragma once

#include <optional>

#include "tracer/compile/render_scene.h"

namespace glint {

/// The shapes that camera rays of the pixels from (x0, y0) to before (x1, y1) can meet, put into
/// `few`, which the answer points to; null: it may be any.
[[nodiscard]] inline const FewShapes* shapesSeen(const RenderScene& scene, int x0, int y0, int x1,
                                                 int y1, FewShapes& few) {
    const double margin = scene.film.filterRadius - 0.5;
    const std::optional<RayBundle> bundle =
        scene.camera.bundle(x0 - margin, y0 - margin, x1 + margin, y1 + margin);
    return bundle && scene.lists->cull(*bundle, few) ? &few : nullptr;
}

}  // namespace glint
