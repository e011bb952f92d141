// The renderers that `peers` compares. Each loads one scene and renders it as often as asked.
#pragma once

#include <memory>

#include "tests/bench/peers/peer_scene.h"

namespace glint::bench {

/// Glint itself, in this process.
class GlintRenderer : public Renderer {
  public:
    /// Renders until the picture's error is down to so many percent, sampling where the error is.
    virtual Result<TimedPicture> renderTo(double errorPercent, int seed) = 0;
};
[[nodiscard]] Result<std::unique_ptr<GlintRenderer>> startGlint(const PeerScene& scene);

/// Blender's Cycles on the processor, in a Blender of its own that is kept for all renders: no
/// clamping, glossy filter, adaptive stop, light threshold or denoiser.
[[nodiscard]] Result<std::unique_ptr<Renderer>> startCycles(const PeerScene& scene);

}  // namespace glint::bench
