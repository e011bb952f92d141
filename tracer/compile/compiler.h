// compile(): the scene document -> an immutable RenderScene that kernels trace. Narrows doubles,
// resolves names and groups, loads assets, gathers lights, finds what features the scene holds.
// Says by name what is missing or not built yet.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "tracer/base/result.h"
#include "tracer/compile/asset_cache.h"
#include "tracer/scene/scene.h"

namespace glint {

struct RenderScene;

/// Something in the scene that the picture cannot show as asked.
struct CompileWarning {
    enum class Kind { NotBuiltYet, MissingAsset, Ignored };
    Kind kind = Kind::Ignored;
    Error error;
};

/// What a compile had to build anew; the rest was shared with the previous scene.
struct CompileStats {
    int shapeListsBuilt = 0, shapeListsRefitted = 0, lightTablesBuilt = 0,
        environmentTablesBuilt = 0, imagesLoaded = 0;
};

struct Compiled {
    std::shared_ptr<const RenderScene> scene;
    std::vector<CompileWarning> warnings;
    CompileStats stats;
};

/// Compiles `scene`; relative asset paths start at `assetFolder`. Fails only for a scene that
/// cannot be drawn at all; what is missing is replaced (a lost environment image by a checker) and
/// listed. Parts of `previous` that `scene` does not change are shared.
[[nodiscard]] Result<Compiled> compile(
    const Scene& scene, const std::filesystem::path& assetFolder, AssetCache& assets,
    const std::shared_ptr<const RenderScene>& previous = nullptr);

/// Names of the features that a compiled scene holds, and of the kernel that traces it.
[[nodiscard]] std::vector<std::string> featureNames(const RenderScene& scene);
[[nodiscard]] std::string kernelName(const RenderScene& scene);

}  // namespace glint
