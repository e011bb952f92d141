#include "tests/bench/scenes.h"

#include <cstdio>
#include <filesystem>

#include "tests/bench/clock.h"
#include "tests/bench/output.h"
#include "tracer/compile/compiler.h"
#include "tracer/io/scene_json.h"
#include "tracer/math/statistics.h"
#include "tracer/render/render.h"

namespace glint::bench {

namespace {

struct SceneBenchOptions {
    std::vector<std::string> files;
    int spp = 16;
    int threads = 0;
    int runs = 5;
    std::string json;
};

struct Figures {
    std::string name;
    std::vector<double> compileSeconds, seconds, raysPerSecond;
    double error = 0;  ///< the same in every run
};

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
    const Stopwatch watch;
    const auto compiled = compile(scene, std::filesystem::path(file).parent_path(), assets);
    if (!compiled) {
        std::fprintf(stderr, "glint-bench: %s\n", compiled.error().text().c_str());
        return false;
    }
    out.compileSeconds.push_back(watch.wallSeconds());
    const Rendering rendering = render(compiled.value().scene, {.threads = options.threads});
    out.name = std::filesystem::path(file).stem().string();
    out.seconds.push_back(rendering.seconds);
    out.raysPerSecond.push_back(static_cast<double>(rendering.rays.total()) / rendering.seconds);
    out.error = rendering.error;
    return true;
}

/// Renders the scenes in turn at 320 x 180 and prints a table: compile time, time, rays a second,
/// error of the picture (see pictureError in tracer/render/tile_error.h) and efficiency 1 /
/// (error^2 * time).
int runScenes(const SceneBenchOptions& options) {
    if (!canWrite(options.json)) return kCannotWrite;
    std::vector<Figures> all(options.files.size());
    for (int run = 0; run < options.runs; ++run)
        for (std::size_t i = 0; i < options.files.size(); ++i)
            if (!measure(options, options.files[i], all[i])) return kBadScene;

    std::printf(
        "| scene | compile [ms] | render [s] | Mray/s | error [%%] | efficiency [1/s] "
        "|\n|---|---|---|---|---|---|\n");
    Json json = Json::array();
    for (const Figures& f : all) {
        const double compileSeconds = median(f.compileSeconds), seconds = median(f.seconds),
                     rays = median(f.raysPerSecond);
        const double efficiency = 1 / (f.error * f.error * seconds);
        std::printf("| %s | %.1f | %.3f | %.2f | %.2f | %.1f |\n", f.name.c_str(),
                    1e3 * compileSeconds, seconds, 1e-6 * rays, 100 * f.error, efficiency);
        json.push_back({{"scene", f.name},
                        {"compile_seconds", compileSeconds},
                        {"render_seconds", seconds},
                        {"rays_per_second", rays},
                        {"error", f.error},
                        {"efficiency", efficiency}});
    }
    return writeJson(options.json, json) ? kOk : kCannotWrite;
}

}  // namespace

Command scenesCommand(CLI::App& root) {
    auto options = std::make_shared<SceneBenchOptions>();
    CLI::App* app = root.add_subcommand(
        "scenes", "Speed, error and efficiency of the path integrator on scenes");
    app->add_option("FILES", options->files, "Scene files")->required()->check(CLI::ExistingFile);
    app->add_option("--spp", options->spp, "Samples a pixel, a power of two")
        ->check(CLI::Range(2, 65536));
    app->add_option("--threads", options->threads, "Threads; 0 is one a processor")
        ->check(CLI::Range(0, 4096));
    app->add_option("--runs", options->runs, "Runs of each scene, in turn; the median counts")
        ->check(CLI::Range(1, 100));
    app->add_option("--json", options->json, "Write the figures to this file as JSON");
    return {app, [options] { return runScenes(*options); }};
}

}  // namespace glint::bench
