// Colours for things that have none: values on a scale, and numbers of things.
#pragma once

#include <cstdint>

namespace glint {

/// A scale that grows in lightness all the way, from near black over violet and orange to pale
/// yellow: 0xffRRGGBB of `t`, which is cut to [0, 1]; magenta for not-a-number. Lightness alone
/// tells the order, so that it also works without seeing colours.
[[nodiscard]] std::uint32_t falseColor(float t);

/// A colour of its own for every number, 0xffRRGGBB; 0 is a dark grey.
[[nodiscard]] std::uint32_t idColor(std::uint32_t id);

}  // namespace glint
