// How a camera moves: pure functions Camera -> Camera, for mouse, keys and menus.
#pragma once

#include "gui/viewport/bounds.h"
#include "tracer/scene/scene.h"

namespace glint {

/// Turns camera and target about `pivot`: `yaw` about the camera's up, `pitch` about its right,
/// radians. The pitch stops short of looking along up.
[[nodiscard]] Camera orbited(Camera camera, const DVec3& pivot, double yaw, double pitch);
/// Turns the view about the eye, same angles.
[[nodiscard]] Camera turned(Camera camera, double yaw, double pitch);
/// Moves along right, up and forward of the view, metres.
[[nodiscard]] Camera moved(Camera camera, const DVec3& rightUpForward);
/// Brings the eye to `factor` times its distance from `point` (below 1: nearer), which keeps its
/// place on the screen.
[[nodiscard]] Camera dollied(Camera camera, const DVec3& point, double factor);
/// The bounds fill the view of the given width / height, seen from the same side.
[[nodiscard]] Camera framed(Camera camera, const Bounds& bounds, double aspect);
/// Looks along `direction` at the same target from the same distance. Where up would lie along the
/// view, up is chosen.
[[nodiscard]] Camera lookingAlong(Camera camera, const DVec3& direction);
/// Changes the projection so that things at the target keep their size.
[[nodiscard]] Camera withProjection(Camera camera, Projection projection);

}  // namespace glint
