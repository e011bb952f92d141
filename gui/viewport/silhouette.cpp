#include "gui/viewport/silhouette.h"

#include <algorithm>
#include <array>
#include <deque>

#include "tracer/render/pick.h"

namespace glint {

namespace {

constexpr int kCell = 8;

/// Fills the picture cell by cell, from what is known about the corners.
class Tracing {
  public:
    explicit Tracing(const SilhouetteRequest& request)
        : request_(request),
          columns_((request.width + kCell - 1) / kCell),
          rows_((request.height + kCell - 1) / kCell),
          shown_(static_cast<std::size_t>(request.width) *
                 static_cast<std::size_t>(request.height)),
          known_(shown_.size()),
          refined_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

    std::vector<Shown> run() {
        if (shown_.empty() || request_.selected.empty()) return std::move(shown_);
        for (int row = 0; row < rows_; ++row)
            for (int column = 0; column < columns_; ++column)
                if (!isAlike(column, row)) want(column, row);
        for (const QPoint& seed : request_.seeds) want(seed.x() / kCell, seed.y() / kCell);
        while (!wanted_.empty()) {
            const QPoint cell = wanted_.front();
            wanted_.pop_front();
            refine(cell.x(), cell.y());
        }
        fillRest();
        return std::move(shown_);
    }

  private:
    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(request_.width) +
               static_cast<std::size_t>(x);
    }

    Shown at(int x, int y) {
        const std::size_t i = index(x, y);
        if (!known_[i]) {
            known_[i] = true;
            shown_[i] = trace(x, y);
        }
        return shown_[i];
    }

    [[nodiscard]] Shown trace(int x, int y) const {
        const auto hit = pick(*request_.scene, request_.width, request_.height, x + 0.5, y + 0.5);
        if (!hit ||
            !std::binary_search(request_.selected.begin(), request_.selected.end(), hit->object))
            return Shown::Other;
        return hit->object == request_.active ? Shown::Active : Shown::Selected;
    }

    [[nodiscard]] int right(int column) const {
        return std::min((column + 1) * kCell, request_.width) - 1;
    }
    [[nodiscard]] int bottom(int row) const {
        return std::min((row + 1) * kCell, request_.height) - 1;
    }

    /// The first pixels of the cell and of its neighbours to the right and below show the same.
    bool isAlike(int column, int row) {
        const Shown first = at(column * kCell, row * kCell);
        for (const auto& [c, r] :
             {std::pair{column + 1, row}, {column, row + 1}, {column + 1, row + 1}})
            if (at(std::min(c * kCell, request_.width - 1),
                   std::min(r * kCell, request_.height - 1)) != first)
                return false;
        return true;
    }

    void want(int column, int row) {
        if (column < 0 || row < 0 || column >= columns_ || row >= rows_) return;
        const auto i = static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                       static_cast<std::size_t>(column);
        if (refined_[i]) return;
        refined_[i] = true;
        wanted_.push_back({column, row});
    }

    /// Traces every pixel of the cell, and goes on where a boundary leaves it.
    void refine(int column, int row) {
        const int x0 = column * kCell, y0 = row * kCell, x1 = right(column), y1 = bottom(row);
        for (int y = y0; y <= y1; ++y)
            for (int x = x0; x <= x1; ++x) at(x, y);
        const auto differs = [&](int xa, int ya, int xb, int yb) {
            // Along the edge: a change within it, or against the neighbour's first pixel.
            const Shown first = at(xa, ya);
            for (int y = ya; y <= yb; ++y)
                for (int x = xa; x <= xb; ++x)
                    if (at(x, y) != first) return true;
            return false;
        };
        const auto neighbour = [&](int c, int r, int xa, int ya, int xb, int yb) {
            if (c < 0 || r < 0 || c >= columns_ || r >= rows_) return;
            if (differs(xa, ya, xb, yb) || at(xa, ya) != at(c * kCell, r * kCell)) want(c, r);
        };
        neighbour(column - 1, row, x0, y0, x0, y1);
        neighbour(column + 1, row, x1, y0, x1, y1);
        neighbour(column, row - 1, x0, y0, x1, y0);
        neighbour(column, row + 1, x0, y1, x1, y1);
    }

    void fillRest() {
        for (int row = 0; row < rows_; ++row)
            for (int column = 0; column < columns_; ++column) {
                if (refined_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                             static_cast<std::size_t>(column)])
                    continue;
                const Shown first = at(column * kCell, row * kCell);
                for (int y = row * kCell; y <= bottom(row); ++y)
                    for (int x = column * kCell; x <= right(column); ++x)
                        if (!known_[index(x, y)]) shown_[index(x, y)] = first;
            }
    }

    const SilhouetteRequest& request_;
    int columns_, rows_;
    std::vector<Shown> shown_;
    std::vector<bool> known_, refined_;
    std::deque<QPoint> wanted_;
};

/// Offsets of all pixels within `radius`.
std::vector<QPoint> discOf(int radius) {
    std::vector<QPoint> out;
    for (int y = -radius; y <= radius; ++y)
        for (int x = -radius; x <= radius; ++x)
            if (x * x + y * y <= radius * (radius + 1)) out.push_back({x, y});
    return out;
}

}  // namespace

std::vector<Shown> silhouette(const SilhouetteRequest& request) { return Tracing(request).run(); }

QImage outlineImage(const std::vector<Shown>& shown, int width, int height, int thickness,
                    const QColor& selected, const QColor& active) {
    QImage image(width, height, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    const auto at = [&](int x, int y) {
        return shown[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                     static_cast<std::size_t>(x)];
    };
    const std::vector<QPoint> rim = discOf(thickness + 1), line = discOf(thickness);
    // Rim first, then the selected, then the active one: what counts more covers the rest.
    const auto paint = [&](const std::vector<QPoint>& disc, Shown least, QRgb color) {
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const Shown own = at(x, y);
                if (own < least) continue;
                const auto isOutside = [&](int nx, int ny) {
                    return nx >= 0 && ny >= 0 && nx < width && ny < height && at(nx, ny) < own;
                };
                if (!isOutside(x - 1, y) && !isOutside(x + 1, y) && !isOutside(x, y - 1) &&
                    !isOutside(x, y + 1))
                    continue;
                for (const QPoint& offset : disc)
                    if (const QPoint to(x + offset.x(), y + offset.y()); isOutside(to.x(), to.y()))
                        reinterpret_cast<QRgb*>(image.scanLine(to.y()))[to.x()] = color;
            }
    };
    paint(rim, Shown::Selected, qPremultiply(qRgba(0, 0, 0, 120)));
    paint(line, Shown::Selected, selected.rgba());
    paint(line, Shown::Active, active.rgba());
    return image;
}

}  // namespace glint
