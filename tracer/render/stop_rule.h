// When a render ends, and how long that will take: the rules samples, time and error of
// RenderSettings, of which the first to be met counts.
#pragma once

#include <deque>

#include "tracer/scene/scene.h"

namespace glint {

/// How the error falls with time: a straight line through the last few points on logarithmic
/// scales.
class ErrorTrend {
  public:
    /// Points must come in order of time; those less than a quarter later than the last kept one
    /// replace it.
    void add(double seconds, double error);
    /// d log(error) / d log(seconds), kept between that of error that hardly falls and of the best
    /// point sets; -1/2, that of independent samples, before there are three points.
    [[nodiscard]] double slope() const;
    /// From the last point on until the error is down to `error`; infinite without any point.
    [[nodiscard]] double secondsUntil(double error) const;

  private:
    static constexpr std::size_t kPoints = 6;
    struct Point {
        double logSeconds, logError;
    };
    std::deque<Point> points_;
    double seconds_ = 0, error_ = 0;
};

/// How far a render is.
struct RenderProgressState {
    double seconds = 0;
    double samples = 0;        ///< mean number a pixel
    int leastSamples = 0;      ///< that every pixel has
    double error = kInfinity;  ///< of the picture, see tile_error.h
};

/// Tiles get different numbers of samples: where an error is asked for, so that a sample is spent
/// where it helps. By number or time all pixels get as many, so that the picture can be made again
/// from that number.
[[nodiscard]] inline bool samplesAdaptively(const RenderSettings& rules) {
    return rules.errorPercent > 0;
}

/// One of the rules is met. The time rule waits for the first sample of every pixel.
[[nodiscard]] bool isDone(const RenderSettings& rules, const RenderProgressState& state);

/// Until isDone(), at the present rate and trend; infinite while unknown.
[[nodiscard]] double remainingSeconds(const RenderSettings& rules, const RenderProgressState& state,
                                      const ErrorTrend& trend);

}  // namespace glint
