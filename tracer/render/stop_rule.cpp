#include "tracer/render/stop_rule.h"

#include <algorithm>
#include <cmath>

#include "tracer/render/adaptive.h"

namespace glint {

void ErrorTrend::add(double seconds, double error) {
    if (!(seconds > 0) || !(error > 0) || !(error < kInfinity)) return;
    seconds_ = seconds;
    error_ = error;
    const Point point{std::log(seconds), std::log(error)};
    const double least = std::log(1.25);
    if (points_.size() > 1 && point.logSeconds - points_[points_.size() - 2].logSeconds < least)
        points_.pop_back();
    points_.push_back(point);
    if (points_.size() > kPoints) points_.pop_front();
}

double ErrorTrend::slope() const {
    if (points_.size() < 3) return -0.5;
    double x = 0, y = 0;
    for (const Point& p : points_) x += p.logSeconds, y += p.logError;
    x /= static_cast<double>(points_.size());
    y /= static_cast<double>(points_.size());
    double xy = 0, xx = 0;
    for (const Point& p : points_) {
        xy += (p.logSeconds - x) * (p.logError - y);
        xx += (p.logSeconds - x) * (p.logSeconds - x);
    }
    return xx > 0 ? std::clamp(xy / xx, -1.5, -0.25) : -0.5;
}

double ErrorTrend::secondsUntil(double error) const {
    if (!(error_ > 0)) return kInfinity;
    if (error_ <= error) return 0;
    return seconds_ * (std::pow(error_ / error, -1 / slope()) - 1);
}

bool isDone(const RenderSettings& rules, const RenderProgressState& state) {
    return state.samples >= rules.spp ||
           (rules.timeSeconds > 0 && state.leastSamples > 0 &&
            state.seconds >= rules.timeSeconds) ||
           (rules.errorPercent > 0 &&
            state.leastSamples >= adaptiveRule(rules.integrator).believed &&
            100 * state.error <= rules.errorPercent);
}

double remainingSeconds(const RenderSettings& rules, const RenderProgressState& state,
                        const ErrorTrend& trend) {
    if (isDone(rules, state)) return 0;
    if (!(state.samples > 0) || !(state.seconds > 0))
        return rules.timeSeconds > 0 ? rules.timeSeconds : kInfinity;
    double left = state.seconds * (rules.spp / state.samples - 1);
    if (rules.timeSeconds > 0) left = std::min(left, rules.timeSeconds - state.seconds);
    if (rules.errorPercent > 0)
        left = std::min(left, trend.secondsUntil(0.01 * rules.errorPercent));
    return std::max(left, 0.0);
}

}  // namespace glint
