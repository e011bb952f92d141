#include "tracer/render/tile_error.h"

#include <algorithm>

namespace glint {

namespace {

/// Of one pixel's luminance, from its halves: their difference has twice the spread of their mean.
double standardError(const FilmPixel& pixel) {
    const std::uint32_t countB = pixel.samples / 2, countA = pixel.samples - countB;
    const double shareB = 1.0 / countB, shareA = countA == countB ? shareB : 1.0 / countA;
    const DVec3 difference = shareA * pixel.sumA - shareB * pixel.sumB;
    return 0.5 * std::abs(luminance(Color{difference.x, difference.y, difference.z}));
}

ErrorSum sumOver(const Film& film, const PixelRect& rect) {
    ErrorSum out;
    for (int y = rect.y; y < rect.y + rect.height; ++y)
        for (int x = rect.x; x < rect.x + rect.width; ++x) out.add(film.at(x, y));
    return out;
}

/// The mean square over a tile's pixels and those of its neighbours.
double squareAround(const std::vector<ErrorSum>& tiles, int columns, int rows, int column,
                    int row) {
    double sum = 0;
    int count = 0;
    for (int r = std::max(0, row - 1); r <= std::min(rows - 1, row + 1); ++r)
        for (int c = std::max(0, column - 1); c <= std::min(columns - 1, column + 1); ++c) {
            const ErrorSum& tile = tiles[static_cast<std::size_t>(r * columns + c)];
            if (tile.pixels == 0) continue;
            sum += tile.squares / static_cast<double>(tile.pixels);
            ++count;
        }
    return sum / count;
}

/// The tile's bound, in luminance; below 0 if no pixel has two samples.
double boundOf(const std::vector<ErrorSum>& tiles, int columns, int rows, int column, int row) {
    constexpr double kShareOfNeighbours = 0.125;
    const ErrorSum& tile = tiles[static_cast<std::size_t>(row * columns + column)];
    if (tile.pixels == 0) return -1;
    const double square =
        std::max(tile.squares / static_cast<double>(tile.pixels),
                 kShareOfNeighbours * squareAround(tiles, columns, rows, column, row));
    return errorBoundFactor(tile.effectivePixels()) * std::sqrt(square);
}

}  // namespace

void ErrorSum::add(const FilmPixel& pixel) {
    if (pixel.samples < 2) return;
    const double error = standardError(pixel);
    squares += error * error;
    fourths += error * error * error * error;
    const DVec3 sum = pixel.sumA + pixel.sumB;
    light += luminance(Color{sum.x, sum.y, sum.z}) / pixel.samples;
    ++pixels;
}

void ErrorSum::add(const ErrorSum& other) {
    squares += other.squares;
    fourths += other.fourths;
    light += other.light;
    pixels += other.pixels;
}

double ErrorSum::relativeError() const {
    if (pixels == 0) return kInfinity;
    const auto n = static_cast<double>(pixels);
    return squares == 0 ? 0 : std::sqrt(squares / n) / (light / n);
}

double ErrorSum::effectivePixels() const {
    const auto n = static_cast<double>(pixels);
    return fourths > 0 ? std::clamp(3 * squares * squares / fourths, 1.0, n) : n;
}

double tileError(const Film& film, const PixelRect& tile) {
    const ErrorSum sum = sumOver(film, tile);
    return sum.pixels ? std::sqrt(sum.squares / static_cast<double>(sum.pixels)) : 0;
}

double errorBoundFactor(double pixels) {
    // z = ln(F) / 2 is symmetric and nearly normal with the variance sigma^2 / 2 (Fisher 1924), and
    // ln(sqrt F) = z.
    constexpr double x = 1.6448536269514722;  // 95 % point of the normal distribution
    const double sigma2 = 2.0 / std::max(pixels, 2.0);
    return std::exp(std::sqrt(sigma2 / 2) * (x + sigma2 * (x * x * x + 3 * x) / 24));
}

bool findErrors(const Film& film, const PixelRect& rect, WorkerPool& pool,
                const CancelToken& cancel, FilmErrors& out) {
    const int width = film.width(), height = film.height(),
              rows = (height + kErrorTile - 1) / kErrorTile;
    out.tiles.columns = (width + kErrorTile - 1) / kErrorTile;
    out.tiles.bounds.assign(
        static_cast<std::size_t>(out.tiles.columns) * static_cast<std::size_t>(rows), -1.0f);
    struct Row {
        ErrorSum inRect;
        double light = 0, samples = 0;
        std::int64_t pixels = 0;
        std::uint32_t least = ~0u;
    };
    std::vector<Row> sums(static_cast<std::size_t>(rows));
    std::vector<ErrorSum> tiles(out.tiles.bounds.size());
    std::atomic<bool> complete{true};  // Only a flag, read when all workers have ended: relaxed.
    pool.run(rows, [&](int, int row) {
        if (cancel.cancelled()) return complete.store(false, std::memory_order_relaxed);
        Row& own = sums[static_cast<std::size_t>(row)];
        for (int column = 0; column < out.tiles.columns; ++column) {
            ErrorSum& tile = tiles[static_cast<std::size_t>(row * out.tiles.columns + column)];
            for (int y = row * kErrorTile; y < std::min(height, (row + 1) * kErrorTile); ++y)
                for (int x = column * kErrorTile; x < std::min(width, (column + 1) * kErrorTile);
                     ++x) {
                    const FilmPixel pixel = film.at(x, y);
                    ErrorSum one;
                    one.add(pixel);
                    tile.add(one);
                    if (x < rect.x || x >= rect.x + rect.width || y < rect.y ||
                        y >= rect.y + rect.height)
                        continue;
                    own.inRect.add(one);
                    own.samples += pixel.samples;
                    own.least = std::min(own.least, pixel.samples);
                }
            own.light += tile.light;
            own.pixels += tile.pixels;
        }
    });
    if (!complete.load(std::memory_order_relaxed)) return false;
    Row all;
    for (const Row& row : sums) {
        all.inRect.add(row.inRect);
        all.light += row.light;
        all.pixels += row.pixels;
        all.samples += row.samples;
        all.least = std::min(all.least, row.least);
    }
    const double area = static_cast<double>(rect.width) * rect.height;
    out.meanSamples = area > 0 ? all.samples / area : 0;
    out.leastSamples = area > 0 ? static_cast<int>(all.least) : 0;
    out.picture = all.inRect.relativeError();
    const double mean = all.pixels ? all.light / static_cast<double>(all.pixels) : 0;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < out.tiles.columns; ++column) {
            const double bound = boundOf(tiles, out.tiles.columns, rows, column, row);
            out.tiles.bounds[static_cast<std::size_t>(row * out.tiles.columns + column)] =
                static_cast<float>(bound < 0   ? -1
                                   : mean > 0  ? bound / mean
                                   : bound > 0 ? 1
                                               : 0);
        }
    return true;
}

double pictureError(const Film& film, const PixelRect& rect) {
    return sumOver(film, rect).relativeError();
}

}  // namespace glint
