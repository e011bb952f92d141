// POV-Ray as a program that renders one scene with the anti-aliasing that it is told.
#pragma once

#include <filesystem>

#include "tests/bench/peers/peer_scene.h"

namespace glint::bench {

/// One of POV-Ray's ways to smooth edges, and how dim the rays are that it leaves out.
struct PovrayQuality {
    int method = 1;  ///< 1: a grid of depth x depth samples; 2: pixels are divided where corners
                     ///< differ, `depth` times
    int depth = 3;
    double threshold = 0;  ///< difference from which pixels are smoothed; 0: all
    double bailout =
        1.0 /
        255;  ///< rays that count for less at the camera are not traced; this is POV-Ray's own
};

class Povray {
  public:
    /// Writes the scene into its folder.
    [[nodiscard]] static Result<Povray> prepare(const PeerScene& scene);
    /// A render `scale` times as wide and high. Times are POV-Ray's own of its tracing, without
    /// parsing.
    [[nodiscard]] Result<TimedPicture> render(const PovrayQuality& quality, int scale = 1) const;
    [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }

  private:
    PeerScene scene_;
    std::filesystem::path file_;
    std::vector<std::string> notes_;
};

}  // namespace glint::bench
