// Paths of pictures and models in a scene: relative to its file where that is possible, so that a
// folder can be moved.
#pragma once

#include <filesystem>

#include "tracer/scene/scene.h"

namespace glint {

/// How a scene in `sceneFile` refers to `asset`: relative with '/', or absolute while the scene is
/// untitled.
[[nodiscard]] std::string assetPath(const std::filesystem::path& asset,
                                    const std::filesystem::path& sceneFile);

/// The scene with its relative paths, which start at `from`, changed to name the same files from
/// `sceneFile`.
[[nodiscard]] Scene withAssetsFrom(Scene scene, const std::filesystem::path& from,
                                   const std::filesystem::path& sceneFile);

}  // namespace glint
