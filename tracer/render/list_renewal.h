// ListRenewal: gives shapes that have moved a hierarchy of their own, on a thread beside the
// render. While they move, the old one follows with larger boxes (ShapeLists::moved).
#pragma once

#include <future>
#include <memory>

#include "tracer/compile/render_scene.h"

namespace glint {

class ListRenewal {
  public:
    /// Begins to build where the scene's hierarchy is an old one; one at a time. A build cannot be
    /// cancelled, only left unused.
    void begin(const RenderScene& scene);
    /// Whether something is being built, or is ready.
    [[nodiscard]] bool isBusy() const { return built_.valid(); }
    /// The scene with what was built for it, which changes no picture (ShapeLists answers alike
    /// with any hierarchy); null where nothing is ready.
    [[nodiscard]] std::shared_ptr<const RenderScene> finish(const RenderScene& scene);

  private:
    using Lists = std::shared_ptr<const ShapeLists>;
    Lists old_;  ///< those of the scene that is built for
    std::future<Lists> built_;
};

}  // namespace glint
