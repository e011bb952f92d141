#include "tracer/math/statistics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace glint {

namespace {

/// 97.5 % quantile of Student's t.
double studentQuantile(std::size_t freedom) {
    constexpr std::array kTable = {12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365,
                                   2.306,  2.262, 2.228, 2.201, 2.179, 2.160, 2.145,
                                   2.131,  2.120, 2.110, 2.101, 2.093, 2.086};
    if (freedom == 0) return std::numeric_limits<double>::infinity();
    if (freedom <= kTable.size()) return kTable[freedom - 1];
    return 1.96 + 2.4 / static_cast<double>(freedom);
}

}  // namespace

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

double geometricMean(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += std::log(value);
    return std::exp(sum / static_cast<double>(values.size()));
}

Interval meanInterval(const std::vector<double>& values) {
    RunningMoments moments;
    for (const double value : values) moments.add(value);
    return {moments.mean(),
            studentQuantile(values.size() - 1) * std::sqrt(moments.varianceOfMean())};
}

Ratio pairedRatio(const std::vector<double>& a, const std::vector<double>& b) {
    std::vector<double> logs(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) logs[i] = std::log(a[i] / b[i]);
    if (a.size() == 1) return {std::exp(logs[0]), 0, std::numeric_limits<double>::infinity()};
    const Interval interval = meanInterval(logs);
    return {std::exp(interval.mean), std::exp(interval.mean - interval.half),
            std::exp(interval.mean + interval.half)};
}

double PowerLaw::at(double x) const { return std::exp(intercept + slope * std::log(x)); }

PowerLaw fitPowerLaw(const std::vector<double>& x, const std::vector<double>& y) {
    const auto n = static_cast<double>(x.size());
    double meanX = 0, meanY = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        meanX += std::log(x[i]) / n;
        meanY += std::log(y[i]) / n;
    }
    double xx = 0, xy = 0, yy = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double dx = std::log(x[i]) - meanX, dy = std::log(y[i]) - meanY;
        xx += dx * dx;
        xy += dx * dy;
        yy += dy * dy;
    }
    PowerLaw out;
    out.slope = xy / xx;
    out.intercept = meanY - out.slope * meanX;
    out.slopeHalf = std::numeric_limits<double>::infinity();
    if (x.size() > 2) {
        const double residual = std::max(0.0, yy - out.slope * xy) / (n - 2);
        out.slopeHalf = studentQuantile(x.size() - 2) * std::sqrt(residual / xx);
    }
    return out;
}

}  // namespace glint
