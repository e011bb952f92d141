#include "tests/bench/startup.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "tests/bench/clock.h"
#include "tests/bench/output.h"
#include "tests/bench/process.h"
#include "tests/bench/scene_list.h"
#include "tracer/math/statistics.h"

namespace glint::bench {

namespace {

namespace fs = std::filesystem;

struct StartupOptions {
    std::vector<std::string> files;
    int runs = 15;
    std::string json;
};

/// Processor seconds of all children that have ended.
double childSeconds() {
    rusage usage{};
    getrusage(RUSAGE_CHILDREN, &usage);
    const auto seconds = [](const timeval& t) { return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec); };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// Renders each scene at 64 x 64 with one sample to an EXR, the whole process each time, and prints medians.
int runStartup(const StartupOptions& options) {
    if (!canWrite(options.json)) return kCannotWrite;
    const fs::path program = fs::read_symlink("/proc/self/exe").parent_path() / "glint-render";
    const fs::path picture = fs::temp_directory_path() / format("glint-startup-%d.exr", static_cast<int>(getpid()));
    Table table({"scene", "ms", "processor ms", "slowest ms"});
    Json json = Json::array();
    int code = kOk;
    for (const std::string& file : options.files) {
        std::vector<double> wall, processor;
        for (int run = 0; run < options.runs && code == kOk; ++run) {
            const Stopwatch watch;
            const double before = childSeconds();
            const Result<Finished> finished = runProgram({program.string(), file, "--size", "64x64", "--spp", "1", "-o", picture.string()});
            if (!finished || finished.value().exitCode != 0) {
                code = complain(finished ? Error{.message = finished.value().output} : finished.error(), kFailed);
                break;
            }
            wall.push_back(1e3 * watch.wallSeconds());
            processor.push_back(1e3 * (childSeconds() - before));
        }
        if (code != kOk) break;
        const std::string name = fs::path(file).stem().string();
        table.add({name, format("%.1f", median(wall)), format("%.1f", median(processor)), format("%.1f", *std::max_element(wall.begin(), wall.end()))});
        json.push_back({{"scene", name}, {"milliseconds", wall}, {"processor_milliseconds", processor}});
    }
    std::error_code ignored;
    fs::remove(picture, ignored);
    if (code != kOk) return code;
    std::printf("%s", table.markdown().c_str());
    return writeJson(options.json, json) ? kOk : kCannotWrite;
}

}  // namespace

Command startupCommand(CLI::App& root) {
    auto options = std::make_shared<StartupOptions>();
    CLI::App* app = root.add_subcommand("startup", "glint-render from its start to the end, 64 x 64 pixels with one sample to EXR (seconds)");
    addSceneFiles(*app, options->files, "tests/bench/scenes/path", {"tests/bench/scenes/path"});
    app->add_option("--runs", options->runs, "Runs of each; the median counts")->check(CLI::Range(1, 1000))->capture_default_str();
    app->add_option("--json", options->json, "Write the figures to this file as JSON");
    return {app, [options] { return runStartup(*options); }};
}

}  // namespace glint::bench
