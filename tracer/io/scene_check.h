// Rules of a scene that concern more than one field: places that cannot be inverted, cycles, light
// and material combinations that have no meaning. Ranges of single fields are in the field tables.
#pragma once

#include <vector>

#include "tracer/base/result.h"
#include "tracer/scene/scene.h"

namespace glint {

/// What a scene says that cannot be: empty for a sound one. Pointers count entries as formatScene()
/// writes them. A scene without problems whose fields are in range can be saved and read back.
[[nodiscard]] std::vector<Error> sceneProblems(const Scene& scene);

/// A material may blend at most this many leaves through `mix`, counted with repetition.
inline constexpr int kMaxMixLeaves = 256;

}  // namespace glint
