#include "tracer/render/adaptive.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

namespace glint {

namespace {

struct CellState {
    double variance = 0;        ///< of one sample's luminance, told by half A
    double freedom = 0;         ///< degrees of freedom of that
    double mean = 0;            ///< of half A
    std::uint32_t samples = 0;  ///< that every pixel has
    int pixels = 0;             ///< within the rectangle, whose light was not put
    bool tellsMean = false;     ///< it has some light
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
    int means = 0;
    for (int y = std::max(rect.y, row * cell); y < std::min(rect.y + rect.height, (row + 1) * cell);
         ++y)
        for (int x = std::max(rect.x, column * cell);
             x < std::min(rect.x + rect.width, (column + 1) * cell); ++x) {
            const HalfMoments half = film.momentsA(x, y);
            if (half.samples > 0) out.mean += half.sum / half.samples, ++means;
            if (film.isPut(x, y)) continue;
            least = std::min(least, film.samples(x, y));
            ++out.pixels;
            if (half.samples < 2) continue;
            squares += std::max(0.0, half.squares - half.sum * half.sum / half.samples);
            out.freedom += half.samples - 1;
        }
    out.samples = out.pixels ? least : 0;
    out.variance = out.freedom > 0 ? squares / out.freedom : 0;
    out.tellsMean = means > 0;
    if (means) out.mean /= means;
    return out;
}

/// What 3 x 3 cells, those that lie in the rectangle, tell of the one in their middle.
struct Neighbourhood {
    double variance = 0;  ///< the mean of theirs
    double contrast = 0;  ///< variance of their means
};
Neighbourhood neighbourhoodOf(const std::vector<CellState>& cells, int columns, std::size_t i) {
    const int rows = static_cast<int>(cells.size()) / columns, row = static_cast<int>(i) / columns,
              column = static_cast<int>(i) % columns;
    double variance = 0, sum = 0, squares = 0;
    int count = 0, means = 0;
    for (int r = std::max(0, row - 1); r <= std::min(rows - 1, row + 1); ++r)
        for (int c = std::max(0, column - 1); c <= std::min(columns - 1, column + 1); ++c)
            if (const CellState& cell =
                    cells[static_cast<std::size_t>(r) * static_cast<std::size_t>(columns) +
                          static_cast<std::size_t>(c)];
                cell.tellsMean) {
                const double difference = cell.mean - cells[i].mean;
                sum += difference;
                squares += difference * difference;
                ++means;
                if (cell.pixels == 0) continue;
                variance += cell.variance;
                ++count;
            }
    if (count == 0) return {};
    return {variance / count, std::max(0.0, squares / means - sum * sum / (means * means))};
}

/// A cell that may get samples: what they cost, and what each gains.
struct Offer {
    double gain, cost;
    std::uint32_t cell;
    [[nodiscard]] bool operator<(const Offer& other) const {
        return gain != other.gain ? gain > other.gain : cell < other.cell;
    }
};

/// Brings the best to the front, as many as it takes to spend `budget` or all, and answers how
/// many. Takes time in proportion to their number, not that of sorting them.
std::size_t takeBest(std::vector<Offer>& offers, double budget) {
    if (!(budget > 0)) return 0;
    std::size_t low = 0, high = offers.size();
    const auto at = [&](std::size_t i) { return offers.begin() + static_cast<std::ptrdiff_t>(i); };
    for (double spent = 0; low < high;) {
        const std::size_t middle = low + (high - low) / 2;
        std::nth_element(at(low), at(middle), at(high));
        double cost = 0;
        for (std::size_t i = low; i <= middle; ++i) cost += offers[i].cost;
        if (spent + cost < budget) {
            spent += cost;
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return std::min(low + 1, offers.size());
}

}  // namespace

CellGoals goalsReached(const Film& film, const AdaptiveRule& rule) {
    CellGoals out = cellsOf(film, rule);
    for (std::size_t i = 0; i < out.samples.size(); ++i)
        out.samples[i] = film.samples(static_cast<int>(i) % out.columns * rule.cell,
                                      static_cast<int>(i) / out.columns * rule.cell);
    return out;
}

bool nextGoals(const Film& film, const PixelRect& rect, std::uint32_t spp, const AdaptiveRule& rule,
               WorkerPool& pool, const CancelToken& cancel, CellGoals& out) {
    CellGoals goals = cellsOf(film, rule);
    const auto columns = static_cast<std::size_t>(goals.columns);
    std::vector<CellState> cells(goals.samples.size());
    std::atomic<bool> complete{true};  // Only a flag, read when all workers have ended: relaxed.
    const auto eachCell = [&](const auto& visit) {
        pool.run(static_cast<int>(cells.size() / columns), [&](int, int row) {
            if (cancel.cancelled()) return complete.store(false, std::memory_order_relaxed);
            for (std::size_t i = static_cast<std::size_t>(row) * columns, end = i + columns;
                 i < end; ++i)
                visit(i);
        });
        return complete.load(std::memory_order_relaxed);
    };
    if (!eachCell([&](std::size_t i) {
            cells[i] = stateOf(film, rect, rule.cell, static_cast<int>(i % columns),
                               static_cast<int>(i / columns));
        }))
        return false;
    std::vector<std::uint32_t> inRect;
    inRect.reserve(cells.size());
    std::uint32_t least = std::numeric_limits<std::uint32_t>::max(), most = 0;
    double total = 0, pixels = 0;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const CellState& cell = cells[i];
        goals.samples[i] = cell.samples;
        if (cell.pixels == 0) continue;
        inRect.push_back(static_cast<std::uint32_t>(i));
        least = std::min(least, cell.samples);
        most = std::max(most, cell.samples);
        total += static_cast<double>(cell.samples) * cell.pixels;
        pixels += cell.pixels;
    }
    out = std::move(goals);
    if (inRect.empty()) return true;
    if (least < rule.uniform) {
        for (const std::uint32_t i : inRect)
            out.samples[i] =
                std::max(out.samples[i], std::min({rule.uniform, spp, least == 0 ? 1 : 2 * least}));
        return true;
    }
    std::vector<double> gain(cells.size());
    const auto findGain = [&](std::size_t i) {
        if (cells[i].pixels == 0) return;
        const double own = cells[i].freedom / (cells[i].freedom + rule.trust);
        const Neighbourhood near = neighbourhoodOf(cells, static_cast<int>(columns), i);
        const double variance = own * cells[i].variance +
                                (1 - own) * std::max(near.variance, rule.contrast * near.contrast);
        gain[i] = variance / std::pow(cells[i].samples, 1 + rule.fall);
    };
    if (!eachCell(findGain)) return false;
    const auto isBehind = [&](std::uint32_t i) { return cells[i].samples < most / rule.spread; };
    const auto mayLead = [&](std::uint32_t i) {
        return cells[i].samples < static_cast<std::uint64_t>(least) * rule.spread;
    };
    std::vector<Offer> offers;
    offers.reserve(inRect.size());
    for (const std::uint32_t i : inRect)
        if (isBehind(i) || mayLead(i))
            offers.push_back({gain[i], static_cast<double>(cells[i].samples) * cells[i].pixels, i});
    const std::size_t taken = takeBest(offers, std::min(total / 4, spp * pixels - total));
    bool goesOn = false;
    for (std::size_t k = 0; k < offers.size(); ++k)
        if (const std::uint32_t i = offers[k].cell; k < taken || isBehind(i)) {
            out.samples[i] = 2 * cells[i].samples;
            goesOn = true;
        }
    // Where all that would gain is as far ahead as it may be, the rest catches up.
    if (!goesOn)
        for (const std::uint32_t i : inRect)
            if (cells[i].samples == least) out.samples[i] = 2 * least;
    return true;
}

}  // namespace glint
