#include "tests/bench/skip.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>

#include "tests/bench/clock.h"
#include "tests/bench/output.h"
#include "tests/bench/process.h"
#include "tests/bench/scene_list.h"
#include "tests/support/paths.h"
#include "tracer/compile/render_scene.h"
#include "tracer/math/statistics.h"
#include "tracer/render/render.h"
#include "tracer/render/skips.h"

namespace glint::bench {

namespace {

namespace fs = std::filesystem;

struct SkipOptions {
    std::vector<std::string> files;
    int width = 64, spp = 4, pairs = 15;
    bool callgrind = true;
    std::string json;
};

/// The kernels beside the smallest one, and what they show.
constexpr std::array kOthers = {std::pair{KernelChoice::Full, "full"},
                                std::pair{KernelChoice::NoSkips, "no_skips"}};

Result<LoadedScene> load(const SkipOptions& options, const std::string& file) {
    return loadScaled(file, options.width, [&](Scene& scene) {
        scene.render.spp = options.spp;
        scene.render.timeSeconds = scene.render.errorPercent = 0;
    });
}

Rendering renderWith(const LoadedScene& scene, KernelChoice kernel) {
    return render(scene.compiled, {.threads = 1, .kernel = kernel});
}

/// Ratio of processor time of the smallest kernel to another's, by pairs in the order ABBA.
Ratio timeRatio(const LoadedScene& scene, KernelChoice other, int pairs) {
    std::vector<double> smallest, others;
    for (int pair = 0; pair < pairs; ++pair)
        for (int turn = 0; turn < 2; ++turn) {
            const bool first = (pair + turn) % 2 == 0;
            const Stopwatch watch;
            static_cast<void>(renderWith(scene, first ? KernelChoice::Smallest : other));
            (first ? smallest : others).push_back(watch.threadSeconds());
        }
    return pairedRatio(smallest, others);
}

/// Instructions that a render takes, by callgrind: of this program, run on that scene alone.
Result<double> instructions(const std::string& file, const SkipOptions& options,
                            const char* kernel) {
    const fs::path out =
        fs::temp_directory_path() / format("glint-callgrind-%d", static_cast<int>(getpid()));
    Result<Finished> run = runProgram(
        {"valgrind", "--tool=callgrind", "--callgrind-out-file=" + out.string(),
         fs::read_symlink("/proc/self/exe").string(), "skip", file, "--width",
         std::to_string(options.width), "--spp", std::to_string(options.spp), "--only", kernel});
    std::error_code ignored;
    fs::remove(out, ignored);
    if (!run) return run.error();
    const std::string mark = "Collected : ";
    const std::size_t at = run.value().output.find(mark);
    if (run.value().exitCode != 0 || at == std::string::npos)
        return Error{"callgrind does not answer: " + run.value().output, {}, 0, 0, {}, {}};
    return std::atof(run.value().output.c_str() + at + mark.size());
}

class SkipBench {
  public:
    explicit SkipBench(const SkipOptions& options) : options_(options) {}

    int run() {
        if (!canWrite(options_.json)) return kCannotWrite;
        const bool valgrind = options_.callgrind && !findProgram("valgrind").empty();
        if (options_.callgrind && !valgrind)
            std::fprintf(stderr,
                         "glint-bench: not installed, so no instruction counts: valgrind (apt-get "
                         "install valgrind)\n");
        std::printf(
            "%zu scenes, %d pixels wide, %d samples, one thread: some seconds a scene%s. Ratios "
            "are of the smallest kernel to the one named.\n\n",
            options_.files.size(), options_.width, options_.spp,
            valgrind ? ", a minute with callgrind" : "");
        Table table({"scene", "kernel", "skips", "not 0", "bits", "time/full", "time/no skips",
                     "instr./full"});
        for (const std::string& file : options_.files) {
            Result<LoadedScene> loaded = load(options_, file);
            if (!loaded) return complain(loaded.error(), kBadScene);
            if (Status measured = measure(loaded.value(), file, valgrind, table); !measured)
                return complain(measured.error(), kFailed);
        }
        std::printf("%s\n%d of %zu scenes have a skip that did work or a picture that differs\n",
                    table.markdown().c_str(), failures_, options_.files.size());
        if (!writeJson(options_.json, json_)) return kCannotWrite;
        return failures_ ? kFailed : kOk;
    }

    /// For callgrind: one render, nothing else.
    static int runOnce(const SkipOptions& options, const std::string& kernel) {
        for (const std::string& file : options.files) {
            Result<LoadedScene> loaded = load(options, file);
            if (!loaded) return complain(loaded.error(), kBadScene);
            KernelChoice choice = KernelChoice::Smallest;
            for (const auto& [other, name] : kOthers)
                if (kernel == name) choice = other;
            static_cast<void>(renderWith(loaded.value(), choice));
        }
        return kOk;
    }

  private:
    Status measure(const LoadedScene& scene, const std::string& file, bool valgrind, Table& table) {
        const Rendering smallest = renderWith(scene, KernelChoice::Smallest);
        const std::vector<std::string> held = skipNames(*scene.compiled);
        Json row{{"scene", scene.name}, {"kernel", smallest.kernel}, {"skips", held}};
        std::vector<std::string> working;
        for (const Skip& skip : allSkips())
            if (skip.holds(*scene.compiled) && smallest.work[skip.count] != 0)
                working.emplace_back(skip.name);
        row["working"] = working;
        bool same = true;
        std::vector<std::string> times;
        for (const auto& [kernel, name] : kOthers) {
            const bool equal = renderWith(scene, kernel).beauty.rgb == smallest.beauty.rgb;
            same = same && equal;
            const Ratio ratio = timeRatio(scene, kernel, options_.pairs);
            times.push_back(format("%.3f (%.3f..%.3f)", ratio.value, ratio.low, ratio.high));
            row[name] = {{"bits_equal", equal},
                         {"time", ratio.value},
                         {"time_low", ratio.low},
                         {"time_high", ratio.high}};
        }
        std::string counted = "-";
        if (valgrind) {
            const Result<double> own = instructions(file, options_, "smallest"),
                                 full = instructions(file, options_, "full");
            if (!own) return own.error();
            if (!full) return full.error();
            counted = format("%.4f", own.value() / full.value());
            row["instructions"] = {{"smallest", own.value()},
                                   {"full", full.value()},
                                   {"ratio", own.value() / full.value()}};
        }
        failures_ += !working.empty() || !same;
        table.add({scene.name, smallest.kernel, format("%zu", held.size()),
                   format("%zu", working.size()), same ? "equal" : "DIFFER", times[0], times[1],
                   counted});
        json_.push_back(std::move(row));
        return Done{};
    }

    const SkipOptions& options_;
    Json json_ = Json::array();
    int failures_ = 0;
};

}  // namespace

Command skipCommand(CLI::App& root) {
    auto options = std::make_shared<SkipOptions>();
    auto only = std::make_shared<std::string>();
    CLI::App* app = root.add_subcommand(
        "skip", "What scenes do not hold costs nothing: counters, equal bits, instructions, time");
    addSceneFiles(*app, options->files, "scenes/demo and tests/bench/scenes",
                  {"scenes/demo", "tests/bench/scenes/path", "tests/bench/scenes/classic"});
    app->add_option("--width", options->width, "Pixels across; the shape stays")
        ->check(CLI::Range(1, 8192))
        ->capture_default_str();
    app->add_option("--spp", options->spp, "Samples a pixel")
        ->check(CLI::Range(1, 65536))
        ->capture_default_str();
    app->add_option("--pairs", options->pairs, "Pairs of renders for the time ratio")
        ->check(CLI::Range(2, 1000))
        ->capture_default_str();
    app->add_flag("!--no-callgrind", options->callgrind, "Leave out the instruction counts");
    app->add_option("--only", *only, "Render once by this kernel and say nothing, for callgrind")
        ->check(CLI::IsMember({"smallest", "full", "no_skips"}));
    app->add_option("--json", options->json, "Write the figures to this file as JSON");
    return {app, [options, only] {
                return only->empty() ? SkipBench(*options).run()
                                     : SkipBench::runOnce(*options, *only);
            }};
}

}  // namespace glint::bench
