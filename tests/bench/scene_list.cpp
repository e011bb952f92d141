#include "tests/bench/scene_list.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "tests/support/paths.h"
#include "tracer/compile/compiler.h"
#include "tracer/io/scene_json.h"

namespace glint::bench {

std::vector<std::string> scenesIn(const std::vector<std::string>& folders) {
    std::vector<std::string> out;
    for (const std::string& folder : folders) {
        std::vector<std::string> found;
        std::error_code missing;
        for (const auto& entry :
             std::filesystem::directory_iterator(test::inSource(folder), missing))
            if (entry.path().extension() == ".json") found.push_back(entry.path().string());
        std::sort(found.begin(), found.end());
        out.insert(out.end(), found.begin(), found.end());
    }
    return out;
}

void addSceneFiles(CLI::App& app, std::vector<std::string>& files, const std::string& what,
                   const std::vector<std::string>& folders) {
    files = scenesIn(folders);
    app.add_option("FILES", files, "Scene files; by default " + what)->check(CLI::ExistingFile);
}

void scaleFilm(Scene& scene, int width) {
    const double shape = static_cast<double>(scene.film.height) / scene.film.width;
    scene.film.width = width;
    scene.film.height = std::max(1, static_cast<int>(std::lround(width * shape)));
}

Result<LoadedScene> loadScaled(const std::string& file, int width,
                               const std::function<void(Scene&)>& change) {
    const std::filesystem::path path(file);
    Result<Scene> scene = loadScene(file);
    if (!scene) return scene.error();
    LoadedScene out{path.stem().string(), std::move(scene).value(), nullptr};
    scaleFilm(out.scene, width);
    if (change) change(out.scene);
    AssetCache assets;
    const Result<Compiled> compiled = compile(out.scene, path.parent_path(), assets);
    if (!compiled) return compiled.error();
    out.compiled = compiled.value().scene;
    return out;
}

}  // namespace glint::bench
