#include "tests/bench/choices.h"

#include <cstdio>
#include <filesystem>
#include <memory>

#include "tests/bench/clock.h"
#include "tests/bench/output.h"
#include "tests/bench/reference_cache.h"
#include "tests/bench/scene_list.h"
#include "tracer/render/error_report.h"
#include "tracer/render/path.h"
#include "tracer/render/worker_pool.h"

namespace glint::bench {

namespace {

namespace fs = std::filesystem;

struct ChoicesOptions {
    std::vector<std::string> files;
    int width = 48, spp = 64, runs = 4;
    std::string only;  ///< ways of this choice alone, beside the one that is built; empty: all
    std::string json, cache = usualCacheFolder().string();
};

/// Balance between densities of one magnitude; the much smaller one counts for nothing (Veach 1997,
/// sec. 9.2.3).
template <int kPercent>
struct Cutoff {
    static double share(double a, double b) {
        constexpr double kLeast = 0.01 * kPercent;
        return a < kLeast * b ? 0 : b < kLeast * a ? 1 : a / (a + b);
    }
    static double lightWeight(double light, double bsdf) { return share(light, bsdf); }
    static double bsdfWeight(double bsdf, double light) { return share(bsdf, light); }
};
template <int kMost>
struct Splits : UsualEffort {
    static constexpr int kMostSplits = kMost;
};
struct NoConnections : UsualEffort {
    static constexpr bool kConnects = false;
};
struct NoHighlights : UsualEffort {
    static constexpr bool kHighlights = false;
};
template <int kPercent>
struct Roulette : UsualEffort {
    static constexpr float kDim = 0.01f * kPercent, kDimBranch = kDim;
};
struct OneLight : UsualEffort {
    static constexpr std::size_t kAllLights = 0;
};
struct EachLight : UsualEffort {
    static constexpr bool kAllSized = true;
};

/// One way to trace a scene.
struct Way {
    std::string_view choice, name;
    KernelFunction run;
    void (*prepare)(RenderScene&) = nullptr;
};

/// Lights are chosen by what they emit, wherever they are.
void chooseByPower(RenderScene& scene) {
    std::vector<LightBounds> bounds;
    for (const CompiledLight& light : scene.lights.lights)
        bounds.push_back({DVec3(0.0), kInfinity, light.power});
    scene.lights.choice = LightChoice(std::move(bounds));
}

template <class Heuristic, class Effort = UsualEffort>
Rgb trace(KernelState& state, int x, int y, std::uint32_t sample) {
    const Sampler sampler = samplerFor(state.scene, x, y, sample);
    return PathTracer<kAllFeatures, Heuristic, Effort>(state, sampler)
        .radiance(cameraRay<kAllFeatures>(state.scene, sampler, x, y, state.work));
}

/// The first one is what Glint does.
constexpr std::array kWays = {
    Way{"-", "as built", trace<UsualHeuristic>},
    Way{"weights", "balance", trace<BalanceHeuristic>},
    Way{"weights", "power 2", trace<PowerHeuristic>},
    Way{"weights", "cutoff 0.5", trace<Cutoff<50>>},
    Way{"weights", "cutoff 0.25", trace<Cutoff<25>>},
    Way{"lights", "one by power", trace<UsualHeuristic>, chooseByPower},
    Way{"lights", "one", trace<UsualHeuristic, OneLight>},
    Way{"lights", "each of four", trace<UsualHeuristic, EachLight>},
    Way{"splitting", "none", trace<UsualHeuristic, Splits<0>>},
    Way{"splitting", "at the first", trace<UsualHeuristic, Splits<1>>},
    Way{"splitting", "at the first two", trace<UsualHeuristic, Splits<2>>},
    Way{"caustics", "no connections", trace<UsualHeuristic, NoConnections>},
    Way{"highlights", "none", trace<UsualHeuristic, NoHighlights>},
    Way{"roulette", "below 1", trace<UsualHeuristic, Roulette<100>>},
    Way{"roulette", "below 0.25", trace<UsualHeuristic, Roulette<25>>},
    Way{"roulette", "below 0.05", trace<UsualHeuristic, Roulette<5>>},
};

/// Errors and processor times of one way on one scene, one of each a run.
struct Figures {
    std::vector<double> relMse, seconds;
    [[nodiscard]] std::vector<double> efficiency() const {
        std::vector<double> out;
        for (std::size_t i = 0; i < seconds.size(); ++i)
            out.push_back(1 / (meanInterval(relMse).mean * seconds[i]));
        return out;
    }
};

void measure(const Way& way, RenderScene scene, int spp, int seed, const Reference& reference,
             Figures& out) {
    scene.settings.seed = seed;
    if (way.prepare) way.prepare(scene);
    const int width = scene.film.width, height = scene.film.height;
    Image image{width, height, std::vector<float>(reference.mean.rgb.size())};
    KernelState state{scene, {}, {}, false};
    const Stopwatch watch;
    for (int y = 0, i = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            DVec3 sum(0.0);
            for (int s = 0; s < spp; ++s)
                sum += toDouble(way.run(state, x, y, static_cast<std::uint32_t>(s)));
            for (int c = 0; c < 3; ++c)
                image.rgb[static_cast<std::size_t>(i++)] = static_cast<float>(sum[c] / spp);
        }
    out.seconds.push_back(watch.threadSeconds());
    out.relMse.push_back(pictureErrors(image, reference).relMse);
}

bool isWanted(const ChoicesOptions& options, const Way& way) {
    return options.only.empty() || way.choice == options.only || &way == kWays.data();
}

Result<std::vector<Figures>> measureAll(const ChoicesOptions& options, const std::string& file) {
    const Result<LoadedScene> loaded = loadScaled(
        file, options.width, [](Scene& scene) { scene.render.integrator = Integrator::Path; });
    if (!loaded) return loaded.error();
    ErrorReportSettings settings;
    settings.lastPower = static_cast<int>(std::ceil(std::log2(options.spp)));
    const Result<Reference> reference = reportReference(options.cache, loaded.value(), settings);
    if (!reference) return reference.error();
    std::vector<Figures> out(kWays.size());
    for (int run = 0; run < options.runs; ++run)
        for (std::size_t i = 0; i < kWays.size(); ++i) {
            const std::size_t way = run % 2 ? kWays.size() - 1 - i : i;
            if (isWanted(options, kWays[way]))
                measure(kWays[way], *loaded.value().compiled, options.spp, run + 1,
                        reference.value(), out[way]);
        }
    return out;
}

int runChoices(const ChoicesOptions& options) {
    if (!canWrite(options.json)) return kCannotWrite;
    flushDenormals();
    Json json = Json::array();
    std::vector<std::vector<double>> ratios(kWays.size());
    Table table({"scene", "choice", "way", "relMSE", "us a sample", "efficiency to as built"});
    for (const std::string& file : options.files) {
        std::fprintf(stderr, "%s ...\n", file.c_str());
        const Result<std::vector<Figures>> measured = measureAll(options, file);
        if (!measured) return complain(measured.error(), kBadScene);
        const std::string scene = fs::path(file).stem().string();
        for (std::size_t i = 0; i < kWays.size(); ++i) {
            if (!isWanted(options, kWays[i])) continue;
            const Figures& f = measured.value()[i];
            const double error = meanInterval(f.relMse).mean;
            const Ratio ratio = pairedRatio(f.efficiency(), measured.value()[0].efficiency());
            if (error > 0) ratios[i].push_back(ratio.value);
            const double microseconds =
                1e6 * median(f.seconds) /
                (static_cast<double>(options.spp) * options.width * options.width);
            table.add({scene, std::string(kWays[i].choice), std::string(kWays[i].name),
                       format("%.2e", error), format("%.2f", microseconds),
                       format("%.2f", ratio.value)});
            json.push_back({{"scene", scene},
                            {"choice", kWays[i].choice},
                            {"way", kWays[i].name},
                            {"rel_mse", f.relMse},
                            {"seconds", f.seconds},
                            {"efficiency_ratio", ratio.value}});
        }
    }
    for (std::size_t i = 0; i < kWays.size(); ++i)
        if (!ratios[i].empty())
            table.add({"geometric mean", std::string(kWays[i].choice), std::string(kWays[i].name),
                       "", "", format("%.2f", geometricMean(ratios[i]))});
    std::printf("%s", table.markdown().c_str());
    return writeJson(options.json, json) ? kOk : kCannotWrite;
}

}  // namespace

Command choicesCommand(CLI::App& root) {
    auto options = std::make_shared<ChoicesOptions>();
    CLI::App* app =
        root.add_subcommand("choices",
                            "The path integrator's choices (weights, splitting, roulette, choice "
                            "of lights) against the other ways, one thread, in turn");
    addSceneFiles(*app, options->files, "scenes/demo and tests/bench/scenes/path",
                  {"scenes/demo", "tests/bench/scenes/path"});
    app->add_option("--width", options->width, "Pixels across; the shape stays")
        ->check(CLI::Range(4, 8192))
        ->capture_default_str();
    app->add_option("--spp", options->spp, "Samples a pixel, a power of two")
        ->check(CLI::Range(1, 65536))
        ->capture_default_str();
    app->add_option("--runs", options->runs, "Renders of each way, in turn, each with its own seed")
        ->check(CLI::Range(2, 1000))
        ->capture_default_str();
    app->add_option("--only", options->only,
                    "Only this choice: weights, lights, splitting, caustics, highlights, roulette");
    app->add_option("--cache", options->cache, "Folder where references are kept")
        ->capture_default_str();
    app->add_option("--json", options->json, "Write the figures to this file as JSON");
    return {app, [options] { return runChoices(*options); }};
}

}  // namespace glint::bench
