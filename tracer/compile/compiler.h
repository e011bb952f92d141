// compile(): the scene document -> an immutable RenderScene that kernels trace. Narrows doubles,
// resolves names and groups, loads assets, gathers lights, finds what features the scene holds.
// Says by name what is missing or not built yet.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "tracer/base/result.h"
#include "tracer/io/image_file.h"
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

/// Keeps loaded images between compiles, by path and time of change. One thread uses it at a time.
class AssetCache {
  public:
    /// The picture, loaded at the first call and when its file has changed.
    Result<std::shared_ptr<const Image>> image(const std::filesystem::path& path, ColorSpace space,
                                               int& loads);
    /// The picture of a computed sky; the last one asked for is kept.
    std::shared_ptr<const Image> sky(const Sky& sky);

  private:
    struct Entry {
        std::filesystem::file_time_type time;
        std::shared_ptr<const Image> image;
    };
    std::map<std::pair<std::string, ColorSpace>, Entry> images_;
    Sky sky_;
    std::shared_ptr<const Image> skyImage_;
};

/// Compiles `scene`; relative asset paths start at `assetFolder`. Fails only for a scene that
/// cannot be drawn at all; what is missing is replaced (a lost environment image by a checker) and
/// listed. Parts of `previous` that `scene` does not change are shared.
[[nodiscard]] Result<Compiled> compile(
    const Scene& scene, const std::filesystem::path& assetFolder, AssetCache& assets,
    const std::shared_ptr<const RenderScene>& previous = nullptr);

/// Whether two documents differ at most in what withView() takes from them, and in what the picture
/// does not show.
[[nodiscard]] bool sameButView(const Scene& a, const Scene& b);
/// The compiled scene through the camera of `scene` and on its film: no list, table or texture is
/// made. Fails as compile().
[[nodiscard]] Result<std::shared_ptr<const RenderScene>> withView(const RenderScene& compiled,
                                                                  const Scene& scene);

/// Names of the features that a compiled scene holds, and of the kernel that traces it.
[[nodiscard]] std::vector<std::string> featureNames(const RenderScene& scene);
[[nodiscard]] std::string kernelName(const RenderScene& scene);

}  // namespace glint
