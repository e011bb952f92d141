#include "tracer/render/error_report.h"

#include <chrono>
#include <cstdio>
#include <ctime>
#include <thread>

#include "tracer/io/svg_plot.h"
#include "tracer/render/classic.h"
#include "tracer/render/path.h"
#include "tracer/render/render.h"
#include "tracer/render/worker_pool.h"

namespace glint {

namespace {

struct PlainEffort : UsualEffort {
    static constexpr int kMostSplits = 0;
    static constexpr float kDim = 0.05f, kDimBranch = 0.05f;
};

/// References are means of this many independent renders, from whose spread their own uncertainty
/// is known.
constexpr int kReferenceRenders = 8;
constexpr int kReferenceSeed = 1'000'000;

template <class Tracer>
Rgb sampleBy(KernelState& state, int x, int y, std::uint32_t sample) {
    const Sampler sampler = samplerFor(state.scene, x, y, sample);
    return Tracer(state, sampler)
        .radiance(cameraRay<kAllFeatures>(state.scene, sampler, x, y, state.work));
}

std::shared_ptr<const RenderScene> withRender(const RenderScene& scene, int spp, int seed) {
    auto out = std::make_shared<RenderScene>(scene);
    out->settings.spp = spp;
    out->settings.seed = seed;
    out->settings.timeSeconds = out->settings.errorPercent = 0;
    return out;
}

int threadsOf(const ErrorReportSettings& settings) {
    return settings.threads > 0
               ? settings.threads
               : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

bool isStopped(const ErrorReportWatch& watch) {
    return watch.stop && watch.stop->load(std::memory_order_relaxed);
}
void report(const ErrorReportWatch& watch, double fraction) {
    if (watch.progress) watch.progress(fraction);
}

/// Means of `spp` samples of the other estimator, row by row; not finite ones count as black. Empty
/// if stopped.
Image renderReference(const RenderScene& scene, int spp, WorkerPool& pool,
                      const ErrorReportWatch& watch) {
    const KernelFunction kernel =
        scene.settings.integrator == Integrator::Classic
            ? sampleBy<ClassicTracer<kAllFeatures>>
            : sampleBy<PathTracer<kAllFeatures, PowerHeuristic, PlainEffort>>;
    const int width = scene.film.width, height = scene.film.height;
    Image out{
        width, height,
        std::vector<float>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3)};
    pool.run(height, [&](int, int y) {
        KernelState state{scene, {}, {}, false};
        for (int x = 0; x < width && !isStopped(watch); ++x) {
            DVec3 sum(0.0);
            for (int sample = 0; sample < spp; ++sample)
                if (const Rgb value = kernel(state, x, y, static_cast<std::uint32_t>(sample));
                    isFinite(value))
                    sum += toDouble(value);
            const std::size_t place =
                3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                     static_cast<std::size_t>(x));
            for (int c = 0; c < 3; ++c)
                out.rgb[place + static_cast<std::size_t>(c)] = static_cast<float>(sum[c] / spp);
        }
    });
    if (isStopped(watch)) out.rgb.clear();
    return out;
}

double processSeconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Gathers the renders of one number of samples.
struct PointSamples {
    std::vector<double> seconds, cpuSeconds, relMse, mape, percentile99, outlierShare;

    void add(const Rendering& rendering, double cpu, const PictureErrors& errors) {
        seconds.push_back(rendering.seconds);
        cpuSeconds.push_back(cpu);
        relMse.push_back(errors.relMse);
        mape.push_back(errors.mape);
        percentile99.push_back(errors.percentile99);
        outlierShare.push_back(errors.outlierShare);
    }
    [[nodiscard]] ErrorPoint point(int spp) const {
        return {spp,
                meanInterval(seconds),
                meanInterval(cpuSeconds),
                meanInterval(relMse),
                meanInterval(mape),
                meanInterval(percentile99),
                meanInterval(outlierShare)};
    }
};

void conclude(ErrorReport& report) {
    std::vector<double> spp, relMse;
    for (const ErrorPoint& point : report.points) {
        // What the reference's own noise hides says nothing about the law.
        if (!(point.relMse.mean > 0) ||
            (point.relMse.half > point.relMse.mean && point.relMse.half < kInfinity))
            continue;
        spp.push_back(point.spp);
        relMse.push_back(point.relMse.mean);
    }
    if (spp.size() >= 2) report.law = fitPowerLaw(spp, relMse);
    const ErrorPoint& last = report.points.back();
    if (!(last.relMse.mean > 0)) return;
    report.efficiency = 1 / (last.relMse.mean * last.seconds.mean);
    report.cpuEfficiency = 1 / (last.relMse.mean * last.cpuSeconds.mean);
}

}  // namespace

std::optional<Reference> makeReference(const std::shared_ptr<const RenderScene>& scene,
                                       const ErrorReportSettings& settings,
                                       const ErrorReportWatch& watch) {
    flushDenormals();
    WorkerPool pool(threadsOf(settings));
    const int spp =
        std::max(1, (1 << settings.lastPower) * settings.referenceFactor / kReferenceRenders);
    ReferenceSum sum;
    for (int i = 0; i < kReferenceRenders; ++i) {
        const Image image =
            renderReference(*withRender(*scene, spp, kReferenceSeed + i), spp, pool, watch);
        if (image.rgb.empty()) return std::nullopt;
        sum.add(image);
        report(watch, (i + 1.0) / kReferenceRenders);
    }
    return sum.reference();
}

std::optional<ErrorReport> measureErrors(const std::shared_ptr<const RenderScene>& scene,
                                         const Reference& reference,
                                         const ErrorReportSettings& settings,
                                         const ErrorReportWatch& watch) {
    const int powers = settings.lastPower - settings.firstPower + 1;
    std::vector<PointSamples> samples(static_cast<std::size_t>(powers));
    double done = 0;
    const double all = settings.seeds * std::ldexp(1.0, settings.lastPower + 1);
    // Seeds outside, so that a change of the machine's speed falls on all numbers of samples.
    for (int seed = 1; seed <= settings.seeds; ++seed)
        for (int k = 0; k < powers; ++k) {
            const int spp = 1 << (settings.firstPower + k);
            const double cpu = processSeconds();
            const Rendering rendering = render(withRender(*scene, spp, seed),
                                               {.threads = settings.threads, .stop = watch.stop});
            if (isStopped(watch)) return std::nullopt;
            samples[static_cast<std::size_t>(k)].add(rendering, processSeconds() - cpu,
                                                     pictureErrors(rendering.beauty, reference));
            report(watch, (done += spp) / all);
        }
    ErrorReport out;
    for (int k = 0; k < powers; ++k)
        out.points.push_back(
            samples[static_cast<std::size_t>(k)].point(1 << (settings.firstPower + k)));
    conclude(out);
    return out;
}

std::string errorReportCsv(const ErrorReport& report) {
    std::string out =
        "spp,seconds,seconds_half,cpu_seconds,rel_mse,rel_mse_half,mape,mape_half,percentile_99,"
        "percentile_99_half,outlier_share,outlier_share_half\n";
    for (const ErrorPoint& p : report.points) {
        char line[512];
        std::snprintf(line, sizeof line,
                      "%d,%.6g,%.3g,%.6g,%.6g,%.3g,%.6g,%.3g,%.6g,%.3g,%.6g,%.3g\n", p.spp,
                      p.seconds.mean, p.seconds.half, p.cpuSeconds.mean, p.relMse.mean,
                      p.relMse.half, p.mape.mean, p.mape.half, p.percentile99.mean,
                      p.percentile99.half, p.outlierShare.mean, p.outlierShare.half);
        out += line;
    }
    return out;
}

std::string errorReportSvg(const std::vector<NamedErrorReport>& reports, const std::string& title,
                           bool onDark) {
    LogPlot plot{title, "time of one render [s]", "relMSE", {}, onDark};
    for (const NamedErrorReport& named : reports) {
        PlotCurve curve{named.name, {}};
        for (const ErrorPoint& p : named.report.points)
            if (p.relMse.mean > 0)
                curve.points.push_back({p.seconds.mean, p.relMse.mean, p.relMse.half});
        plot.curves.push_back(std::move(curve));
    }
    return svgOf(plot);
}

}  // namespace glint
