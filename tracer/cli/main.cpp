// glint-render: a scene file to a picture, without a window. Start at run().
#include <sys/resource.h>

#include <chrono>
#include <cstdio>
#include <optional>

#include "tracer/base/heap.h"
#include "tracer/cli/exit_code.h"
#include "tracer/cli/interrupt.h"
#include "tracer/cli/options.h"
#include "tracer/cli/progress.h"
#include "tracer/cli/verify.h"
#include "tracer/compile/compiler.h"
#include "tracer/io/atomic_file.h"
#include "tracer/io/render_stats.h"
#include "tracer/io/rendering_file.h"
#include "tracer/io/scene_json.h"
#include "tracer/render/path_record.h"
#include "tracer/render/render.h"
#include "tracer/render/skips.h"

namespace glint {

namespace {

void say(const std::string& text) { std::fprintf(stderr, "glint-render: %s\n", text.c_str()); }

double secondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::uint64_t peakMemoryBytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
}

RenderStats statsFor(const Options& options, const Scene& scene, const Compiled& compiled,
                     const Rendering& rendering) {
    RenderStats out;
    out.scene = options.scene.string();
    out.integrator =
        enumNames(scene.render.integrator)[static_cast<std::size_t>(scene.render.integrator)];
    out.width = scene.film.width;
    out.height = scene.film.height;
    out.spp = rendering.spp;
    out.threads = rendering.threads;
    out.seed = scene.render.seed;
    out.renderSeconds = rendering.seconds;
    out.errorPercent = 100 * rendering.error;
    out.primaryRays = rendering.rays.primary;
    out.shadowRays = rendering.rays.shadow;
    out.scatterRays = rendering.rays.scatter;
    out.nonfiniteSamples = rendering.nonfiniteSamples;
    out.features = featureNames(*compiled.scene);
    out.kernel = rendering.kernel;
    out.skips = skipNames(*compiled.scene);
    out.work = rendering.work;
    out.peakMemoryBytes = peakMemoryBytes();
    out.interrupted = rendering.interrupted;
    for (const CompileWarning& warning : compiled.warnings)
        out.warnings.push_back(warning.error.text());
    return out;
}

/// Prints the compiler's warnings; true if an asset is missing.
bool reportWarnings(const Compiled& compiled) {
    bool missing = false;
    for (const CompileWarning& warning : compiled.warnings) {
        const bool asset = warning.kind == CompileWarning::Kind::MissingAsset;
        say((asset ? "" : "warning: ") + warning.error.text());
        missing = missing || asset;
    }
    return missing;
}

void reportNonfinite(const Options& options, const Rendering& rendering) {
    if (rendering.nonfiniteSamples == 0) return;
    std::string text = "warning: " + std::to_string(rendering.nonfiniteSamples) +
                       " samples were not finite and do not count";
    if (const auto& place = rendering.firstNonfinite)
        text += "; the first: glint-render " + options.scene.string() + " --pixel " +
                std::to_string(place->x) + "," + std::to_string(place->y) + "," +
                std::to_string(place->sample);
    say(text);
}

/// The files that are to be written can be: better known before an hour of rendering than after it.
std::optional<Error> outputProblem(const Options& options) {
    for (const auto& path : {options.output, options.stats}) {
        if (path.empty()) continue;
        if (const Status writable = checkWritable(path); !writable) return writable.error();
    }
    return std::nullopt;
}

/// The tree of paths on the error stream, the value alone on the other, for programs.
ExitCode printPixel(const RenderScene& scene, const Scene& document, const SamplePlace& place,
                    bool quiet) {
    const PathRecord record = recordSample(scene, place);
    const Rgb value = record.value;
    if (!quiet) std::fputs(pathText(record, document).c_str(), stderr);
    std::printf("%.9g %.9g %.9g\n", static_cast<double>(value.x), static_cast<double>(value.y),
                static_cast<double>(value.z));
    return ExitCode::Done;
}

Rendering renderWithProgress(const Options& options, const Compiled& compiled,
                             const std::atomic<bool>& stop) {
    ProgressBar bar(options.quiet ? ProgressBar::Mode::Off : ProgressBar::Mode::Automatic);
    RenderRequest request = requestFor(options.picture);
    request.threads = options.threads;
    request.stop = &stop;
    request.progress = [&](const RenderProgress& progress) { bar.show(progress); };
    Rendering rendering = render(compiled.scene, request);
    bar.clear();
    return rendering;
}

/// Renders, writes the picture and the statistics, and says how it went.
ExitCode renderToFiles(const Options& options, const Scene& scene, const Compiled& compiled,
                       double setupSeconds, const std::atomic<bool>& stop) {
    const Rendering rendering = renderWithProgress(options, compiled, stop);
    if (rendering.interrupted && rendering.rays.primary == 0) {
        say("interrupted before the first sample; nothing was written");
        return ExitCode::Interrupted;
    }
    reportNonfinite(options, rendering);
    std::string features;
    for (const std::string& name : featureNames(*compiled.scene))
        features += (features.empty() ? "" : ", ") + name;
    Status saved = saveRendering(options.output, scene, rendering, options.picture, features);
    if (saved && !options.stats.empty()) {
        RenderStats stats = statsFor(options, scene, compiled, rendering);
        stats.setupSeconds = setupSeconds;
        saved = saveStats(stats, options.stats);
    }
    if (!saved) {
        say(saved.error().text());
        return ExitCode::Output;
    }
    const std::string samples = std::to_string(rendering.spp) + " samples a pixel";
    if (rendering.interrupted)
        say("interrupted; wrote " + options.output.string() + " with " + samples);
    else if (!options.quiet)
        say("wrote " + options.output.string() + ", " + samples + " in " +
            clockText(rendering.seconds));
    return rendering.interrupted ? ExitCode::Interrupted : ExitCode::Done;
}

ExitCode run(const Options& options) {
    if (options.schema) {
        std::fputs(sceneSchema().c_str(), stdout);
        return ExitCode::Done;
    }
    const std::atomic<bool>& stop = watchInterrupts();
    if (!options.verify.empty()) return verifyPicture(options, stop);
    const auto start = std::chrono::steady_clock::now();
    const auto fail = [](const Error& error, ExitCode code) {
        say(error.text());
        return code;
    };
    auto loaded = loadScene(options.scene);
    if (!loaded) return fail(loaded.error(), ExitCode::Scene);
    const auto scene = withOptions(std::move(loaded).value(), options);
    if (!scene) return fail(scene.error(), ExitCode::Usage);
    if (const auto problem = outputProblem(options)) return fail(*problem, ExitCode::Output);

    AssetCache assets;
    const auto compiled =
        compile(sceneFor(scene.value(), options.picture), options.scene.parent_path(), assets);
    if (!compiled) return fail(compiled.error(), ExitCode::Scene);
    if (reportWarnings(compiled.value())) return ExitCode::Scene;
    if (options.pixel)
        return printPixel(*compiled.value().scene, scene.value(), *options.pixel, options.quiet);
    if (const auto problem = memoryProblem(*compiled.value().scene, requestFor(options.picture)))
        return fail(*problem, ExitCode::Scene);
    return renderToFiles(options, scene.value(), compiled.value(), secondsSince(start), stop);
}

}  // namespace

}  // namespace glint

int main(int argc, char** argv) {
    glint::keepFreedMemory();
    try {
        const auto parsed = glint::parseOptions(argc, argv);
        if (const int* code = std::get_if<int>(&parsed)) return *code;
        return static_cast<int>(glint::run(std::get<glint::Options>(parsed)));
    } catch (const std::exception& problem) {
        // Memory is all that can run out here; every other error is a Result.
        glint::say(std::string("cannot go on: ") + problem.what());
        return static_cast<int>(glint::ExitCode::Scene);
    }
}
