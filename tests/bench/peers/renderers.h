// The renderers that `peers` compares. Each loads one scene and renders it as often as asked.
#pragma once

#include <memory>

#include "tests/bench/peers/peer_scene.h"

namespace glint::bench {

/// Glint itself, in this process.
[[nodiscard]] Result<std::unique_ptr<Renderer>> startGlint(const PeerScene& scene);

/// Blender's Cycles on the processor, in a Blender of its own that is kept for all renders: no clamping, glossy filter, adaptive
/// stop, light threshold or denoiser.
[[nodiscard]] Result<std::unique_ptr<Renderer>> startCycles(const PeerScene& scene);

}  // namespace glint::bench
