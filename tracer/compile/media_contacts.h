// Whether dielectrics meet in a scene, so that a boundary can have one index, or one medium, on
// both sides.
#pragma once

#include "tracer/compile/render_scene.h"

namespace glint {

/// True where a boundary of some dielectric may bend nothing: an index of 1, or two whose bounding
/// boxes touch. May be true where none does, never false where one does.
[[nodiscard]] bool mediaMayMatch(const RenderScene& scene);

/// The most dielectrics whose bounding boxes share a place; once that is above `enough`, it may be
/// more. Gives up, with what it has found, on scenes of tens of thousands that overlap.
[[nodiscard]] int mostMediaAtOnePlace(const RenderScene& scene, int enough);

}  // namespace glint
