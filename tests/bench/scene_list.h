// Which scenes a measurement takes, and at what size.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "tracer/base/result.h"
#include "tracer/scene/scene.h"

namespace glint {
struct RenderScene;
}

namespace glint::bench {

/// Scene files in folders of the source tree, in the order of their names.
[[nodiscard]] std::vector<std::string> scenesIn(const std::vector<std::string>& folders);

/// The positional argument FILES, by default all scenes of `folders` (`what` in words for the help
/// text).
void addSceneFiles(CLI::App& app, std::vector<std::string>& files, const std::string& what,
                   const std::vector<std::string>& folders);

/// Makes the film `width` pixels wide in its own shape.
void scaleFilm(Scene& scene, int width);

struct LoadedScene {
    std::string name;  ///< of the file, without its ending
    Scene scene;
    std::shared_ptr<const RenderScene> compiled;
};
/// The scene of a file, scaled to `width`, compiled after `change`.
[[nodiscard]] Result<LoadedScene> loadScaled(const std::string& file, int width,
                                             const std::function<void(Scene&)>& change = {});

}  // namespace glint::bench
