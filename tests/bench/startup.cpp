#include "tests/bench/startup.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
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
    const auto seconds = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// How long a program takes from its start on, and what it costs, run by run [ms].
struct Starts {
    std::vector<double> wall, processor;
};

/// Once through the whole of glint-render: 64 x 64 pixels with one sample to an EXR.
Status renderOnce(const fs::path& program, const std::string& file, const fs::path& picture,
                  Starts& starts) {
    const Stopwatch watch;
    const double before = childSeconds();
    const Result<Finished> finished = runProgram(
        {program.string(), file, "--size", "64x64", "--spp", "1", "-o", picture.string()});
    if (!finished) return finished.error();
    if (finished.value().exitCode != 0) return Error{.message = finished.value().output};
    starts.wall.push_back(1e3 * watch.wallSeconds());
    starts.processor.push_back(1e3 * (childSeconds() - before));
    return Done{};
}

/// The editor with its window until the first picture has been drawn; `platform`: Qt's plugin.
Status openOnce(const fs::path& program, const std::string& platform, const std::string& file,
                Starts& starts) {
    const Stopwatch watch;
    const double before = childSeconds();
    Result<Process> started = Process::start(
        {"env", "QT_QPA_PLATFORM=" + platform, program.string(), "--first-picture", file});
    if (!started) return started.error();
    Process process = std::move(started).value();
    std::string line, said;
    while (process.readLine(line) && line != "first picture") said += line + '\n';
    if (line != "first picture")
        return Error{.message = "the editor ended before its first picture: " + said};
    starts.wall.push_back(1e3 * watch.wallSeconds());
    process.wait();
    starts.processor.push_back(1e3 * (childSeconds() - before));
    return Done{};
}

/// Each program on each scene, a new process every time; prints medians.
int runStartup(const StartupOptions& options) {
    if (!canWrite(options.json)) return kCannotWrite;
    const fs::path folder = fs::read_symlink("/proc/self/exe").parent_path();
    const fs::path picture =
        fs::temp_directory_path() / format("glint-startup-%d.exr", static_cast<int>(getpid()));
    std::vector<std::string> programs{"glint-render"};
    if (fs::exists(folder / "glint")) {
        programs.push_back("offscreen");
        if (std::getenv("DISPLAY")) programs.push_back("xcb");
    }
    Table table({"program", "scene", "ms", "processor ms", "slowest ms"});
    Json json = Json::array();
    Status status = Done{};
    for (const std::string& program : programs) {
        const bool renders = program == "glint-render";
        const std::string shown = renders ? program : "glint, " + program;
        for (const std::string& file : options.files) {
            Starts starts;
            for (int run = 0; run < options.runs && status; ++run)
                status = renders ? renderOnce(folder / program, file, picture, starts)
                                 : openOnce(folder / "glint", program, file, starts);
            if (!status) break;
            const std::string name = fs::path(file).stem().string();
            table.add({shown, name, format("%.1f", median(starts.wall)),
                       format("%.1f", median(starts.processor)),
                       format("%.1f", *std::max_element(starts.wall.begin(), starts.wall.end()))});
            json.push_back({{"program", shown},
                            {"scene", name},
                            {"milliseconds", starts.wall},
                            {"processor_milliseconds", starts.processor}});
        }
    }
    std::error_code ignored;
    fs::remove(picture, ignored);
    if (!status) return complain(status.error(), kFailed);
    std::printf("%s", table.markdown().c_str());
    return writeJson(options.json, json) ? kOk : kCannotWrite;
}

}  // namespace

Command startupCommand(CLI::App& root) {
    auto options = std::make_shared<StartupOptions>();
    CLI::App* app =
        root.add_subcommand("startup",
                            "glint-render from its start to the end of 64 x 64 pixels with one "
                            "sample; the editor to its first picture (a minute)");
    addSceneFiles(*app, options->files, "tests/bench/scenes/path", {"tests/bench/scenes/path"});
    app->add_option("--runs", options->runs, "Runs of each; the median counts")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    app->add_option("--json", options->json, "Write the figures to this file as JSON");
    return {app, [options] { return runStartup(*options); }};
}

}  // namespace glint::bench
