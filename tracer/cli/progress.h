// The progress bar of glint-render.
#pragma once

#include <string>

#include "tracer/render/render.h"

namespace glint {

/// Draws over one line of stderr, where that is a terminal; else shows nothing.
class ProgressBar {
  public:
    enum class Mode { Automatic, Off };
    explicit ProgressBar(Mode mode);
    void show(const RenderProgress& progress);
    /// Clears the line, for other messages.
    void clear();

  private:
    bool active_;
    bool drawn_ = false;
};

/// "[######----]  60 %  154/256 spp  0:12 left".
[[nodiscard]] std::string progressLine(const RenderProgress& progress);
/// "0:07", "12:34", "1:02:03".
[[nodiscard]] std::string clockText(double seconds);

}  // namespace glint
