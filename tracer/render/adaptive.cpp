#include "tracer/render/adaptive.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace glint {

namespace {

struct CellState {
    double variance = 0;        ///< of one sample's luminance, told by half A
    double freedom = 0;         ///< degrees of freedom of that
    std::uint32_t samples = 0;  ///< that every pixel has
    int pixels = 0;             ///< within the rectangle
};

CellGoals cellsOf(const Film& film, const AdaptiveRule& rule) {
    CellGoals out{rule.cell, (film.width() + rule.cell - 1) / rule.cell, {}};
    const int rows = (film.height() + rule.cell - 1) / rule.cell;
    out.samples.resize(static_cast<std::size_t>(out.columns) * static_cast<std::size_t>(rows));
    return out;
}

/// Sums of half A over the pixels that a cell shares with the rectangle.
CellState stateOf(const Film& film, const PixelRect& rect, int cell, int column, int row) {
    CellState out;
    double squares = 0;
    std::uint32_t least = std::numeric_limits<std::uint32_t>::max();
    for (int y = std::max(rect.y, row * cell); y < std::min(rect.y + rect.height, (row + 1) * cell); ++y)
        for (int x = std::max(rect.x, column * cell); x < std::min(rect.x + rect.width, (column + 1) * cell); ++x) {
            const HalfMoments half = film.momentsA(x, y);
            least = std::min(least, film.samples(x, y));
            ++out.pixels;
            if (half.samples < 2) continue;
            squares += std::max(0.0, half.squares - half.sum * half.sum / half.samples);
            out.freedom += half.samples - 1;
        }
    out.samples = out.pixels ? least : 0;
    out.variance = out.freedom > 0 ? squares / out.freedom : 0;
    return out;
}

/// The mean variance of 3 x 3 cells, of those that lie in the rectangle.
double smoothedVariance(const std::vector<CellState>& cells, int columns, std::size_t i) {
    const int rows = static_cast<int>(cells.size()) / columns, row = static_cast<int>(i) / columns, column = static_cast<int>(i) % columns;
    double sum = 0;
    int count = 0;
    for (int r = std::max(0, row - 1); r <= std::min(rows - 1, row + 1); ++r)
        for (int c = std::max(0, column - 1); c <= std::min(columns - 1, column + 1); ++c)
            if (const CellState& cell = cells[static_cast<std::size_t>(r) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(c)]; cell.pixels > 0) {
                sum += cell.variance;
                ++count;
            }
    return count ? sum / count : 0;
}

}  // namespace

CellGoals goalsReached(const Film& film, const AdaptiveRule& rule) {
    CellGoals out = cellsOf(film, rule);
    for (std::size_t i = 0; i < out.samples.size(); ++i)
        out.samples[i] = film.samples(static_cast<int>(i) % out.columns * rule.cell, static_cast<int>(i) / out.columns * rule.cell);
    return out;
}

CellGoals nextGoals(const Film& film, const PixelRect& rect, std::uint32_t spp, const AdaptiveRule& rule) {
    CellGoals goals = cellsOf(film, rule);
    std::vector<CellState> cells(goals.samples.size());
    std::vector<std::uint32_t> order;  // of the cells that lie in the rectangle
    std::uint32_t least = std::numeric_limits<std::uint32_t>::max(), most = 0;
    double total = 0, pixels = 0;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        CellState& cell = cells[i] = stateOf(film, rect, rule.cell, static_cast<int>(i) % goals.columns, static_cast<int>(i) / goals.columns);
        goals.samples[i] = cell.samples;
        if (cell.pixels == 0) continue;
        order.push_back(static_cast<std::uint32_t>(i));
        least = std::min(least, cell.samples);
        most = std::max(most, cell.samples);
        total += static_cast<double>(cell.samples) * cell.pixels;
        pixels += cell.pixels;
    }
    if (order.empty()) return goals;
    if (least < rule.uniform) {
        for (const std::uint32_t i : order) goals.samples[i] = std::max(goals.samples[i], std::min({rule.uniform, spp, least == 0 ? 1 : 2 * least}));
        return goals;
    }
    std::vector<double> gain(cells.size());
    for (const std::uint32_t i : order) {
        const double own = cells[i].freedom / (cells[i].freedom + rule.trust);
        const double variance = own * cells[i].variance + (1 - own) * smoothedVariance(cells, goals.columns, i);
        gain[i] = variance / std::pow(cells[i].samples, 1 + rule.fall);
    }
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return gain[a] > gain[b]; });
    const double budget = std::min(total / 4, spp * pixels - total);
    double cost = 0;
    for (const std::uint32_t i : order) {
        const CellState& cell = cells[i];
        const bool behind = cell.samples < most / rule.spread;
        const bool mayLead = cell.samples < static_cast<std::uint64_t>(least) * rule.spread;
        if (!behind && (cost >= budget || !mayLead)) continue;
        goals.samples[i] = 2 * cell.samples;
        cost += static_cast<double>(cell.samples) * cell.pixels;
    }
    // Where all that would gain is as far ahead as it may be, the rest catches up.
    if (cost == 0)
        for (const std::uint32_t i : order)
            if (cells[i].samples == least) goals.samples[i] = 2 * least;
    return goals;
}

}  // namespace glint
