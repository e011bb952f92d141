// What of a compiled scene depends on its camera and film alone.
#pragma once

#include <memory>
#include <optional>

#include "tracer/base/result.h"
#include "tracer/compile/render_scene.h"
#include "tracer/scene/scene.h"

namespace glint {

/// Why no picture can be taken with this camera, if so. Files are checked on loading; this holds
/// for scenes made otherwise.
[[nodiscard]] std::optional<Error> cameraProblem(const Camera& camera);

/// Fills in the camera, the media around it and the film, once all else is there.
void setView(RenderScene& out, const Scene& scene);

/// Whether two documents differ at most in what withView() takes from them, and in what the picture
/// does not show.
[[nodiscard]] bool sameButView(const Scene& a, const Scene& b);
/// The compiled scene through the camera of `scene` and on its film: no list, table or texture is
/// made. Fails as compile().
[[nodiscard]] Result<std::shared_ptr<const RenderScene>> withView(const RenderScene& compiled,
                                                                  const Scene& scene);

}  // namespace glint
