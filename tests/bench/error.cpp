#include "tests/bench/error.h"

#include <cstdio>
#include <filesystem>
#include <memory>

#include "tests/bench/output.h"
#include "tests/bench/reference_cache.h"
#include "tests/bench/scene_list.h"
#include "tracer/render/error_report.h"

namespace glint::bench {

namespace {

namespace fs = std::filesystem;

struct ErrorOptions {
    std::vector<std::string> files;
    int width = 160;
    ErrorReportSettings report;
    std::string json, csv, plot, markdown, cache = usualCacheFolder().string();
};

/// Loads and compiles a scene at the size to measure at, and measures it.
Result<NamedErrorReport> measure(const ErrorOptions& options, const std::string& file) {
    const Result<LoadedScene> loaded = loadScaled(file, options.width);
    if (!loaded) return loaded.error();
    const LoadedScene& target = loaded.value();
    const Result<Reference> reference = reportReference(options.cache, target, options.report);
    if (!reference) return reference.error();
    NamedErrorReport out{target.name, {}};
    out.report = measureErrors(target.compiled, reference.value(), options.report).value();
    return out;
}

Json toJson(const Interval& interval) { return {{"mean", interval.mean}, {"half", interval.half}}; }

Json toJson(const NamedErrorReport& named) {
    Json out{{"scene", named.name},
             {"efficiency", named.report.efficiency},
             {"efficiency_cpu", named.report.cpuEfficiency}};
    if (named.report.law)
        out["slope"] = {{"value", named.report.law->slope}, {"half", named.report.law->slopeHalf}};
    for (const ErrorPoint& p : named.report.points)
        out["points"].push_back({{"spp", p.spp},
                                 {"seconds", toJson(p.seconds)},
                                 {"cpu_seconds", toJson(p.cpuSeconds)},
                                 {"rel_mse", toJson(p.relMse)},
                                 {"mape", toJson(p.mape)},
                                 {"percentile_99", toJson(p.percentile99)},
                                 {"outlier_share", toJson(p.outlierShare)}});
    return out;
}

std::vector<std::string> rowOf(const NamedErrorReport& named) {
    const ErrorPoint& last = named.report.points.back();
    const auto percent = [](const Interval& i) { return format("%.3g", 100 * i.mean); };
    return {named.name,
            format("%d", last.spp),
            format("%.3f", last.seconds.mean),
            format("%.3f", last.cpuSeconds.mean),
            last.relMse.mean > 0 ? format("%.2e ± %.0f %%", last.relMse.mean,
                                          100 * last.relMse.half / last.relMse.mean)
                                 : "0",
            percent(last.mape),
            percent(last.percentile99),
            percent(last.outlierShare),
            named.report.law
                ? format("%.2f ± %.2f", named.report.law->slope, named.report.law->slopeHalf)
                : "-",
            named.report.efficiency > 0 ? format("%.3g", named.report.efficiency) : "-"};
}

class ErrorBench {
  public:
    explicit ErrorBench(const ErrorOptions& options) : options_(options) {}

    int run() {
        for (const std::string& file :
             {options_.json, options_.csv, options_.plot, options_.markdown})
            if (!canWrite(file)) return kCannotWrite;
        std::printf(
            "%zu scenes, %d pixels wide, %d to %d samples a pixel, %d seeds each; references of %d "
            "samples by another estimator, kept in %s.\n\n",
            options_.files.size(), options_.width, 1 << options_.report.firstPower,
            1 << options_.report.lastPower, options_.report.seeds,
            options_.report.referenceFactor << options_.report.lastPower, options_.cache.c_str());
        Json json = Json::array();
        std::string csv;
        Table table({"scene", "spp", "s", "processor s", "relMSE", "MAPE %", "99th %", "outliers %",
                     "slope", "efficiency 1/s"});
        for (const std::string& file : options_.files) {
            std::fprintf(stderr, "%s ...\n", file.c_str());
            Result<NamedErrorReport> measured = measure(options_, file);
            if (!measured) return complain(measured.error(), kBadScene);
            const NamedErrorReport& named = measured.value();
            json.push_back(toJson(named));
            table.add(rowOf(named));
            csv += csvOf(named, csv.empty());
            reports_.push_back(named);
        }
        std::printf("%s", table.markdown().c_str());
        const bool written =
            writeJson(options_.json, json) && writeText(options_.csv, csv) &&
            writeText(options_.markdown, table.markdown()) &&
            writeText(options_.plot, errorReportSvg(reports_, "Error over time", false));
        return written ? kOk : kCannotWrite;
    }

  private:
    /// The report's lines with the scene's name in front; the head only once.
    static std::string csvOf(const NamedErrorReport& named, bool head) {
        std::string out;
        std::istringstream lines(errorReportCsv(named.report));
        std::string line;
        std::getline(lines, line);
        if (head) out += "scene," + line + '\n';
        while (std::getline(lines, line)) out += named.name + ',' + line + '\n';
        return out;
    }

    const ErrorOptions& options_;
    std::vector<NamedErrorReport> reports_;
};

}  // namespace

Command errorCommand(CLI::App& root) {
    auto options = std::make_shared<ErrorOptions>();
    CLI::App* app = root.add_subcommand(
        "error", "Time against error on scenes, and the slope at which it falls (minutes a scene)");
    addSceneFiles(*app, options->files, "scenes/demo and scenes/verify",
                  {"scenes/demo", "scenes/verify"});
    app->add_option("--width", options->width, "Pixels across; the shape stays")
        ->check(CLI::Range(4, 8192))
        ->capture_default_str();
    app->add_option("--first", options->report.firstPower,
                    "Fewest samples a pixel, as a power of two")
        ->check(CLI::Range(0, 16))
        ->capture_default_str();
    app->add_option("--last", options->report.lastPower, "Most samples a pixel, as a power of two")
        ->check(CLI::Range(1, 16))
        ->capture_default_str();
    app->add_option("--seeds", options->report.seeds, "Renders of each, each with its own seed")
        ->check(CLI::Range(2, 1000))
        ->capture_default_str();
    app->add_option("--threads", options->report.threads, "Threads; 0 is one a processor")
        ->check(CLI::Range(0, 1024))
        ->capture_default_str();
    app->add_option("--reference", options->report.referenceFactor,
                    "Samples of the reference, in multiples of the most")
        ->check(CLI::Range(1, 100000))
        ->capture_default_str();
    app->add_option("--cache", options->cache, "Folder where references are kept")
        ->capture_default_str();
    app->add_option("--csv", options->csv, "Write every point to this file");
    app->add_option("--plot", options->plot, "Write the curves to this SVG file");
    app->add_option("--markdown", options->markdown, "Write the table to this file");
    app->add_option("--json", options->json, "Write the figures to this file as JSON");
    return {app, [options] { return ErrorBench(*options).run(); }};
}

}  // namespace glint::bench
