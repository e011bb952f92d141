// ViewHistory: where the camera has been. Back and forward, apart from undo.
#pragma once

#include <optional>
#include <vector>

#include "tracer/scene/scene.h"

namespace glint {

class ViewHistory {
  public:
    /// The view moves away from `left`; what was ahead is forgotten.
    void leave(const Camera& left) {
        back_.push_back(left);
        if (back_.size() > kMost) back_.erase(back_.begin());
        forward_.clear();
    }
    [[nodiscard]] std::optional<Camera> back(const Camera& current) {
        return step(back_, forward_, current);
    }
    [[nodiscard]] std::optional<Camera> forward(const Camera& current) {
        return step(forward_, back_, current);
    }
    void clear() { back_.clear(), forward_.clear(); }

  private:
    static constexpr std::size_t kMost = 200;

    static std::optional<Camera> step(std::vector<Camera>& from, std::vector<Camera>& to,
                                      const Camera& current) {
        if (from.empty()) return std::nullopt;
        to.push_back(current);
        const Camera camera = from.back();
        from.pop_back();
        return camera;
    }

    std::vector<Camera> back_, forward_;
};

}  // namespace glint
