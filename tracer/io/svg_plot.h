// Plots in double logarithmic scale as SVG text: for the error report and the benches. No files, no
// fonts, no library.
#pragma once

#include <string>
#include <vector>

namespace glint {

/// A point with positive coordinates and the half width of its 95 % interval in y (0: none).
struct PlotPoint {
    double x = 0, y = 0, half = 0;
};
struct PlotCurve {
    std::string name;
    std::vector<PlotPoint> points;  ///< in the order of the line
    bool dashed = false;            ///< and of the colour of the curve before
};
struct LogPlot {
    std::string title, xLabel, yLabel;
    std::vector<PlotCurve> curves;
    bool onDark = false;  ///< light ink, for a dark page; the background is transparent either way
};

/// The plot with decades as grid, a legend, and error bars, 760 x 480. Without any point it says
/// so.
[[nodiscard]] std::string svgOf(const LogPlot& plot);

}  // namespace glint
