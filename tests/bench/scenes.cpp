#include "scenes.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tracer/compile/compiler.h"
#include "tracer/io/scene_json.h"
#include "tracer/render/render.h"

namespace glint::bench {

namespace {

struct Figures {
    std::string name;
    std::vector<double> compileSeconds, seconds, raysPerSecond;
    double error = 0;  ///< the same in every run
};

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

/// One run of one scene; false with a message if it cannot be rendered.
bool measure(const SceneBenchOptions& options, const std::string& file, Figures& out) {
    auto loaded = loadScene(file);
    if (!loaded) {
        std::fprintf(stderr, "glint-bench: %s\n", loaded.error().text().c_str());
        return false;
    }
    Scene scene = std::move(loaded).value();
    scene.film.width = 320;
    scene.film.height = 180;
    scene.render.spp = options.spp;
    scene.render.timeSeconds = scene.render.errorPercent = 0;

    AssetCache assets;
    const auto start = std::chrono::steady_clock::now();
    const auto compiled = compile(scene, std::filesystem::path(file).parent_path(), assets);
    if (!compiled) {
        std::fprintf(stderr, "glint-bench: %s\n", compiled.error().text().c_str());
        return false;
    }
    out.compileSeconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    const Rendering rendering = render(compiled.value().scene, {.threads = options.threads});
    out.name = std::filesystem::path(file).stem().string();
    out.seconds.push_back(rendering.seconds);
    out.raysPerSecond.push_back(static_cast<double>(rendering.rays.total()) / rendering.seconds);
    out.error = rendering.error;
    return true;
}

}  // namespace

int runScenes(const SceneBenchOptions& options, const std::string& jsonFile) {
    std::vector<Figures> all(options.files.size());
    for (int run = 0; run < options.runs; ++run)
        for (std::size_t i = 0; i < options.files.size(); ++i)
            if (!measure(options, options.files[i], all[i])) return 2;

    std::printf("| scene | compile [ms] | render [s] | Mray/s | error [%%] | efficiency [1/s] |\n|---|---|---|---|---|---|\n");
    auto json = nlohmann::ordered_json::array();
    for (const Figures& f : all) {
        const double compileSeconds = median(f.compileSeconds), seconds = median(f.seconds), rays = median(f.raysPerSecond);
        const double efficiency = 1 / (f.error * f.error * seconds);
        std::printf("| %s | %.1f | %.3f | %.2f | %.2f | %.1f |\n", f.name.c_str(), 1e3 * compileSeconds, seconds, 1e-6 * rays, 100 * f.error, efficiency);
        json.push_back({{"scene", f.name}, {"compile_seconds", compileSeconds}, {"render_seconds", seconds}, {"rays_per_second", rays}, {"error", f.error}, {"efficiency", efficiency}});
    }
    if (jsonFile.empty()) return 0;
    std::ofstream out(jsonFile);
    out << json.dump(2) << '\n';
    if (out.flush()) return 0;
    std::fprintf(stderr, "glint-bench: cannot write %s\n", jsonFile.c_str());
    return 3;
}

}  // namespace glint::bench
