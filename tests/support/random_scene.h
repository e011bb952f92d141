// Random scene documents, made through the field tables, so that new fields and new kinds are tried
// without a word here.
#pragma once

#include <cstdint>

#include "tracer/scene/scene.h"

namespace glint::test {

/// A sound document (no problems, every field in its range) with some of everything, fields not
/// built yet too. The same seed gives the same scene. Ids have no gaps, and a field that a texture
/// replaces has its default value, as after reading a file.
[[nodiscard]] Scene randomScene(std::uint64_t seed);

}  // namespace glint::test
