// The error report: how the error of a scene's picture falls with samples and time, against a
// reference that other seeds and another estimator made. Both `glint-bench error` and the editor's
// dialog are made of this. Start at makeReference() and measureErrors().
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tracer/compile/render_scene.h"
#include "tracer/math/statistics.h"
#include "tracer/render/picture_error.h"

namespace glint {

/// What is measured: renders at 1, 2, 4 ... 2^lastPower samples a pixel, each with `seeds` seeds.
struct ErrorReportSettings {
    int firstPower = 0, lastPower = 8;
    int seeds = 8;
    int threads = 0;           ///< 0: one a processor
    int referenceFactor = 64;  ///< samples of the reference in multiples of 2^lastPower
};

/// How a long measurement is watched. Called on the measuring thread.
struct ErrorReportWatch {
    const std::atomic<bool>* stop = nullptr;             ///< set it to give up
    std::function<void(double fraction)> progress = {};  ///< from 0 to 1, of one call
};

/// One number of samples: mean and 95 % half width over the seeds.
struct ErrorPoint {
    int spp = 0;
    Interval seconds, cpuSeconds;  ///< of one render: passed, and of all processors
    Interval relMse, mape, percentile99, outlierShare;  ///< as in picture_error.h
};

struct ErrorReport {
    std::vector<ErrorPoint> points;
    /// relMSE over samples: a slope of -1 is plain Monte Carlo, steeper is better, flatter is bias.
    /// Nothing for a picture without noise.
    std::optional<PowerLaw> law;
    /// 1 / (relMSE * time) at the most samples, by passed and by processor time [1/s]; 0 for a
    /// picture without noise.
    double efficiency = 0, cpuEfficiency = 0;
};

/// The mean picture of another estimator with other seeds than measureErrors() takes: power
/// heuristic instead of balance, no splitting, late roulette (scenes with the classic integrator:
/// the same algorithm). Nothing if stopped.
[[nodiscard]] std::optional<Reference> makeReference(
    const std::shared_ptr<const RenderScene>& scene, const ErrorReportSettings& settings,
    const ErrorReportWatch& watch = {});

/// Renders the scene in all ways that `settings` name and compares. Nothing if stopped.
[[nodiscard]] std::optional<ErrorReport> measureErrors(
    const std::shared_ptr<const RenderScene>& scene, const Reference& reference,
    const ErrorReportSettings& settings, const ErrorReportWatch& watch = {});

/// One line a point after a head; numbers with a decimal point.
[[nodiscard]] std::string errorReportCsv(const ErrorReport& report);

/// Error over time in double logarithmic scale as an SVG picture, with 95 % bars; several named
/// reports on one sheet.
struct NamedErrorReport {
    std::string name;
    ErrorReport report;
};
[[nodiscard]] std::string errorReportSvg(const std::vector<NamedErrorReport>& reports,
                                         const std::string& title, bool onDark);

}  // namespace glint
