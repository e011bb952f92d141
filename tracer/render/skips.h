// The skips: work that a scene is spared because it lacks something. Each names the count that is
// exactly 0 where it holds. Kernels with Feature::NoSkips do the work all the same and give the
// same picture. What an edit does not rebuild is counted by CompileStats instead, and camera rays
// that it need not trace again (first_hits.h) by Work::KnownHits.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "tracer/base/work.h"

namespace glint {

struct RenderScene;

/// Work that some scenes are spared.
struct Skip {
    std::string_view name;  ///< "what the scene lacks: what is not done"
    Work count;             ///< 0 in every render of a scene for which it holds
    bool (*holds)(const RenderScene& scene);
};

[[nodiscard]] std::span<const Skip> allSkips();
/// Names of those that hold for a scene.
[[nodiscard]] std::vector<std::string> skipNames(const RenderScene& scene);

}  // namespace glint
