#include "tests/bench/filter.h"

#include <cstdio>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "tests/bench/clock.h"
#include "tests/bench/output.h"
#include "tracer/compile/compiler.h"
#include "tracer/io/scene_json.h"
#include "tracer/math/statistics.h"
#include "tracer/render/picture_error.h"
#include "tracer/render/preview_filter.h"
#include "tracer/render/scheduler.h"

namespace glint::bench {

namespace {

struct FilterOptions {
    std::vector<std::string> files;
    int spp = 4, referenceSpp = 64, width = 640, height = 360, threads = 0, runs = 5;
    std::string json;
};

struct Figures {
    double raw = 0, filtered = 0;                    ///< relMSE, see PictureErrors
    double sampleMs = 0, guideMs = 0, filterMs = 0;  ///< at 1280 x 720: processor time over threads
};

std::shared_ptr<const RenderScene> compiled(Scene scene, const std::string& file, int width,
                                            int height, int spp, int seed) {
    scene.film.width = width;
    scene.film.height = height;
    scene.render.spp = spp;
    scene.render.seed = seed;
    scene.render.timeSeconds = scene.render.errorPercent = 0;
    AssetCache assets;
    auto out = compile(scene, std::filesystem::path(file).parent_path(), assets);
    return out.ok() ? out.value().scene : nullptr;
}

void measureError(const Scene& scene, const std::string& file, const FilterOptions& options,
                  Figures& out) {
    RenderRequest request;
    request.threads = options.threads;
    ReferenceSum sum;
    constexpr int kReferences = 2;
    for (int seed = 1; seed <= kReferences; ++seed)
        sum.add(
            render(compiled(scene, file, options.width, options.height, options.referenceSpp, seed),
                   request)
                .beauty);
    request.filter = true;
    const Rendering few =
        render(compiled(scene, file, options.width, options.height, options.spp, 0), request);
    const Reference reference = sum.reference();
    out.raw = pictureErrors(few.beauty, reference).relMse;
    out.filtered = pictureErrors(few.filtered, reference).relMse;
}

void measureTime(const Scene& scene, const std::string& file, const FilterOptions& options,
                 Figures& out) {
    constexpr int kWidth = 1280, kHeight = 720;
    const auto full = compiled(scene, file, kWidth, kHeight, 2, 0);
    WorkerPool pool(options.threads > 0
                        ? options.threads
                        : static_cast<int>(std::max(1u, std::thread::hardware_concurrency())));
    const auto milliseconds = [&](auto&& work) {
        const Stopwatch watch;
        work();
        return 1e3 * watch.processSeconds() / pool.threads();
    };
    Scheduler scheduler(pool);
    Film film(kWidth, kHeight);
    RenderCounts counts;
    const auto sample = [&](std::uint32_t n) {
        scheduler.renderPass(*full, film, nullptr, {0, 0, kWidth, kHeight}, 1, {.samples = n}, {},
                             counts);
    };
    out.sampleMs = milliseconds([&] { sample(1); });
    sample(2);
    GuideFilm guides;
    out.guideMs = milliseconds([&] { guides.refine(full, kWidth, kHeight, 1, 1, {}, pool); });
    PreviewFilter filter;
    std::vector<Rgb> light;
    filter.run(film, guides, pool, {}, light);
    std::vector<double> times;
    for (int i = 0; i < options.runs; ++i)
        times.push_back(milliseconds([&] { filter.run(film, guides, pool, {}, light); }));
    out.filterMs = median(times);
}

int runFilter(const FilterOptions& options) {
    Table table({"scene", "relMSE", "filtered", "ratio", "1 spp ms", "guides ms", "filter ms"});
    Json json = Json::array();
    for (const std::string& file : options.files) {
        auto loaded = loadScene(file);
        if (!loaded.ok() || !compiled(loaded.value(), file, 16, 16, 1, 0)) {
            std::fprintf(stderr, "glint-bench: %s\n",
                         loaded.ok() ? (file + ": cannot be compiled").c_str()
                                     : loaded.error().text().c_str());
            return kBadScene;
        }
        Figures f;
        measureError(loaded.value(), file, options, f);
        measureTime(loaded.value(), file, options, f);
        const std::string name = std::filesystem::path(file).stem().string();
        table.add({name, format("%.2e", f.raw), format("%.2e", f.filtered),
                   format("%.3f", f.filtered / f.raw), format("%.0f", f.sampleMs),
                   format("%.0f", f.guideMs), format("%.1f", f.filterMs)});
        json.push_back({{"scene", name},
                        {"spp", options.spp},
                        {"relmse", f.raw},
                        {"relmse_filtered", f.filtered},
                        {"sample_ms", f.sampleMs},
                        {"guides_ms", f.guideMs},
                        {"filter_ms", f.filterMs}});
    }
    std::printf("%s", table.markdown().c_str());
    return writeJson(options.json, json) ? kOk : kCannotWrite;
}

}  // namespace

Command filterCommand(CLI::App& root) {
    auto options = std::make_shared<FilterOptions>();
    CLI::App* app = root.add_subcommand("filter",
                                        "What the preview filter gains (relMSE of few samples, raw "
                                        "and filtered) and costs at 1280 x 720");
    app->add_option("FILES", options->files, "Scene files")->required()->check(CLI::ExistingFile);
    app->add_option("--spp", options->spp, "Samples a pixel that are filtered")
        ->check(CLI::Range(1, 65536));
    app->add_option("--reference", options->referenceSpp,
                    "Samples a pixel of each of the two references")
        ->check(CLI::Range(2, 1 << 20));
    app->add_option("--width", options->width, "Of the pictures whose error is measured")
        ->check(CLI::Range(16, 4096));
    app->add_option("--height", options->height, "Of the same")->check(CLI::Range(16, 4096));
    app->add_option("--threads", options->threads, "Threads; 0 is one a processor")
        ->check(CLI::Range(0, 4096));
    app->add_option("--runs", options->runs, "Runs of the filter; the median counts")
        ->check(CLI::Range(1, 100));
    app->add_option("--json", options->json, "Write the figures to this file as JSON");
    return {app, [options] { return runFilter(*options); }};
}

}  // namespace glint::bench
