// The materials of a scene as a graph of mixes: cycles, and what a material holds through any
// number of mixes.
#pragma once

#include <unordered_map>
#include <vector>

#include "tracer/scene/scene.h"

namespace glint {

/// What one material holds, through all its mixes.
struct MaterialContent {
    int leaves = 1;           ///< with repetition; stops counting at kMaxMixLeaves + 1
    bool solidGlass = false;  ///< glass that is not thin
};

struct MaterialGraph {
    std::unordered_map<std::uint32_t, MaterialContent> content;  ///< by id
    std::vector<MaterialId> closingCycle;  ///< mixes whose removal leaves no cycle
};

[[nodiscard]] MaterialGraph materialGraph(const Scene& scene);

}  // namespace glint
