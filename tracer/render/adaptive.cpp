#include "tracer/render/adaptive.h"

#include <algorithm>
#include <numeric>

namespace glint {

namespace {

struct TileState {
    double variance = 0;        ///< of one sample's luminance, told by half A
    std::uint32_t samples = 0;  ///< that every pixel has
    int pixels = 0;             ///< within the rectangle
    double smoothed = 0;        ///< mean variance with the neighbours
};

/// Sums of half A over the pixels that a tile shares with the rectangle.
TileState stateOf(const Film& film, const PixelRect& rect, int column, int row) {
    TileState out;
    double squares = 0, freedom = 0;
    std::uint32_t least = ~0u;
    for (int y = std::max(rect.y, row * kErrorTile); y < std::min(rect.y + rect.height, (row + 1) * kErrorTile); ++y)
        for (int x = std::max(rect.x, column * kErrorTile); x < std::min(rect.x + rect.width, (column + 1) * kErrorTile); ++x) {
            const HalfMoments half = film.momentsA(x, y);
            least = std::min(least, film.samples(x, y));
            ++out.pixels;
            if (half.samples < 2) continue;
            squares += std::max(0.0, half.squares - half.sum * half.sum / half.samples);
            freedom += half.samples - 1;
        }
    out.samples = out.pixels ? least : 0;
    out.variance = freedom > 0 ? squares / freedom : 0;
    return out;
}

void smooth(std::vector<TileState>& tiles, int columns, int rows) {
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            double sum = 0;
            int count = 0;
            for (int r = std::max(0, row - 1); r <= std::min(rows - 1, row + 1); ++r)
                for (int c = std::max(0, column - 1); c <= std::min(columns - 1, column + 1); ++c)
                    if (const TileState& tile = tiles[static_cast<std::size_t>(r * columns + c)]; tile.pixels > 0) {
                        sum += tile.variance;
                        ++count;
                    }
            tiles[static_cast<std::size_t>(row * columns + column)].smoothed = count ? sum / count : 0;
        }
}

}  // namespace

std::vector<std::uint32_t> AdaptivePlan::next(const Film& film, const PixelRect& rect, std::uint32_t spp) {
    const int columns = (film.width() + kErrorTile - 1) / kErrorTile, rows = (film.height() + kErrorTile - 1) / kErrorTile;
    std::vector<TileState> tiles;
    tiles.reserve(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) tiles.push_back(stateOf(film, rect, column, row));

    std::vector<std::uint32_t> goals, order;
    std::uint32_t least = ~0u, most = 0;
    double total = 0, pixels = 0;
    for (const TileState& tile : tiles) {
        goals.push_back(tile.samples);
        if (tile.pixels == 0) continue;
        order.push_back(static_cast<std::uint32_t>(goals.size() - 1));
        least = std::min(least, tile.samples);
        most = std::max(most, tile.samples);
        total += static_cast<double>(tile.samples) * tile.pixels;
        pixels += tile.pixels;
    }
    if (order.empty()) return goals;
    if (least < kUniform) {
        for (const std::uint32_t i : order) goals[i] = std::max(goals[i], std::min({kUniform, spp, least == 0 ? 1 : 2 * least}));
        return goals;
    }
    smooth(tiles, columns, rows);
    const auto gain = [&](std::uint32_t i) { return tiles[i].smoothed / (static_cast<double>(tiles[i].samples) * tiles[i].samples); };
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return gain(a) > gain(b); });
    const double budget = std::min(total / 4, spp * pixels - total);
    double cost = 0;
    for (const std::uint32_t i : order) {
        const TileState& tile = tiles[i];
        const bool behind = tile.samples < most / kSpread;
        const bool mayLead = tile.samples < static_cast<std::uint64_t>(least) * kSpread;
        if (!behind && (cost >= budget || !mayLead)) continue;
        goals[i] = 2 * tile.samples;
        cost += static_cast<double>(tile.samples) * tile.pixels;
    }
    // Where all that would gain is as far ahead as it may be, the rest catches up.
    if (cost == 0)
        for (const std::uint32_t i : order)
            if (tiles[i].samples == least) goals[i] = 2 * least;
    return goals;
}

}  // namespace glint
