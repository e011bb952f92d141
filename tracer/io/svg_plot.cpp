#include "tracer/io/svg_plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

namespace glint {

namespace {

constexpr double kWidth = 760, kHeight = 480, kLeft = 72, kRight = 20, kTop = 40, kBottom = 52;
/// Okabe and Ito's colours, which the colour-blind can tell apart.
constexpr std::array kColors = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                "#e69f00", "#56b4e9", "#7a7a7a", "#b58900"};

template <class... Values>
std::string text(const char* pattern, Values... values) {
    std::string out(static_cast<std::size_t>(std::snprintf(nullptr, 0, pattern, values...)), '\0');
    std::snprintf(out.data(), out.size() + 1, pattern, values...);
    return out;
}

std::string escaped(const std::string& plain) {
    std::string out;
    for (const char c : plain) {
        if (c == '&')
            out += "&amp;";
        else if (c == '<')
            out += "&lt;";
        else
            out += c;
    }
    return out;
}

/// One logarithmic axis: values to pixels.
struct Axis {
    double low = std::numeric_limits<double>::infinity(), high = 0, from = 0, to = 0;

    void include(double value) {
        if (!(value > 0)) return;
        low = std::min(low, value);
        high = std::max(high, value);
    }
    /// At least one decade, and air at both ends.
    void finish(double pixelFrom, double pixelTo) {
        const double middle = std::sqrt(low * high),
                     half = std::max(std::sqrt(high / low) * 1.15, 3.2);
        low = middle / half;
        high = middle * half;
        from = pixelFrom;
        to = pixelTo;
    }
    [[nodiscard]] double at(double value) const {
        const double share = std::log(std::clamp(value, low, high) / low) / std::log(high / low);
        return from + share * (to - from);
    }
    template <class Visit>
    void forEachDecade(Visit&& visit) const {
        const int decades = static_cast<int>(std::log10(high / low)),
                  step = std::max(1, decades / 8);
        for (int k = static_cast<int>(std::ceil(std::log10(low))); std::pow(10.0, k) <= high;
             k += step)
            visit(k);
    }
};

class Drawing {
  public:
    explicit Drawing(const LogPlot& plot)
        : plot_(plot),
          ink_(plot.onDark ? "#d8d8d8" : "#303030"),
          grid_(plot.onDark ? "#4a4a4a" : "#d8d8d8") {}

    std::string run() {
        out_ = text(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%g\" height=\"%g\" viewBox=\"0 0 %g "
            "%g\" font-family=\"sans-serif\" font-size=\"12\" fill=\"%s\">\n",
            kWidth, kHeight, kWidth, kHeight, ink_);
        write(kWidth / 2, 22, "middle", plot_.title, "font-size=\"14\"");
        for (const PlotCurve& curve : plot_.curves)
            for (const PlotPoint& p : curve.points) {
                x_.include(p.x);
                y_.include(p.y);
            }
        if (x_.high > 0 && y_.high > 0) {
            x_.finish(kLeft, kWidth - kRight);
            y_.finish(kHeight - kBottom, kTop);
            axes();
            eachCurve([this](const PlotCurve& curve, const char* color) { draw(curve, color); });
            legend();
        } else {
            write(kWidth / 2, kHeight / 2, "middle", "no noise to show", "");
        }
        return out_ + "</svg>\n";
    }

  private:
    void write(double x, double y, const char* anchor, const std::string& words,
               const std::string& more) {
        out_ += text("<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\" ", x, y, anchor) + more + ">" +
                escaped(words) + "</text>\n";
    }
    void line(double x0, double y0, double x1, double y1, const char* color) {
        out_ += text("<path d=\"M%.1f %.1fL%.1f %.1f\" stroke=\"%s\" fill=\"none\"/>\n", x0, y0, x1,
                     y1, color);
    }

    void axes() {
        x_.forEachDecade([&](int k) {
            const double x = x_.at(std::pow(10.0, k));
            line(x, kTop, x, kHeight - kBottom, grid_);
            write(x, kHeight - kBottom + 17, "middle", text("1e%d", k), "");
        });
        y_.forEachDecade([&](int k) {
            const double y = y_.at(std::pow(10.0, k));
            line(kLeft, y, kWidth - kRight, y, grid_);
            write(kLeft - 6, y + 4, "end", text("1e%d", k), "");
        });
        line(kLeft, kTop, kLeft, kHeight - kBottom, ink_);
        line(kLeft, kHeight - kBottom, kWidth - kRight, kHeight - kBottom, ink_);
        write((kLeft + kWidth - kRight) / 2, kHeight - 14, "middle", plot_.xLabel, "");
        const double y = (kTop + kHeight - kBottom) / 2;
        write(18, y, "middle", plot_.yLabel, text("transform=\"rotate(-90 18 %.1f)\"", y));
    }

    template <class Visit>
    void eachCurve(const Visit& visit) const {
        std::size_t colors = 0;  // So many are in use.
        for (const PlotCurve& curve : plot_.curves) {
            if (!curve.dashed || colors == 0) ++colors;
            visit(curve, kColors[(colors - 1) % kColors.size()]);
        }
    }
    static const char* dashesOf(const PlotCurve& curve) {
        return curve.dashed ? " stroke-dasharray=\"5 3\"" : "";
    }

    void draw(const PlotCurve& curve, const char* color) {
        std::string path;
        for (const PlotPoint& p : curve.points) {
            const double x = x_.at(p.x), y = y_.at(p.y);
            path += text("%c%.1f %.1f", path.empty() ? 'M' : 'L', x, y);
            out_ += text("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"2.6\" fill=\"%s\"/>\n", x, y, color);
            if (p.half > 0 && std::isfinite(p.half)) {
                const double top = y_.at(p.y + p.half),
                             bottom = y_.at(std::max(p.y - p.half, y_.low));
                line(x, top, x, bottom, color);
                line(x - 3, top, x + 3, top, color);
                line(x - 3, bottom, x + 3, bottom, color);
            }
        }
        out_ += "<path d=\"" + path +
                text("\" stroke=\"%s\" stroke-width=\"1.6\" fill=\"none\"%s/>\n", color,
                     dashesOf(curve));
    }

    void legend() {
        double y = kTop + 14;
        eachCurve([&](const PlotCurve& curve, const char* color) {
            out_ += text("<path d=\"M%.1f %.1fh21\" stroke=\"%s\" stroke-width=\"2.4\"%s/>\n",
                         kWidth - kRight - 26, y - 4, color, dashesOf(curve));
            write(kWidth - kRight - 32, y, "end", curve.name, "");
            y += 16;
        });
    }

    const LogPlot& plot_;
    const char* ink_;
    const char* grid_;
    std::string out_;
    Axis x_, y_;
};

}  // namespace

std::string svgOf(const LogPlot& plot) { return Drawing(plot).run(); }

}  // namespace glint
