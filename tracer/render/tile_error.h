// How noisy a film is, told from the difference of its halves, which are scrambled independently:
// per tile of 8 x 8 pixels with a 95 % bound, and as one figure for the picture.
#pragma once

#include <optional>

#include "tracer/render/film.h"
#include "tracer/render/worker_pool.h"

namespace glint {

inline constexpr int kErrorTile = 8;  ///< pixels a side

/// Root mean square over a tile's pixels of the standard error of their luminance: (A - B) / 2. 0
/// where no pixel has two samples.
[[nodiscard]] double tileError(const Film& film, const PixelRect& tile);

/// What a tile's true error (root mean square over its pixels of mean minus truth, in luminance)
/// stays below in 95 of 100 tiles is this factor times its estimated error. With n pixels whose
/// errors are near to normal and alike, the ratio of the two squares has the F distribution with n
/// and n degrees of freedom. The root of its 95 % point is taken by Fisher's z and one term of its
/// Cornish-Fisher series: within 1 % from n = 4 on, 4 % below. 1.23 for a whole tile.
[[nodiscard]] double errorBoundFactor(double pixels);

/// The picture's error: root mean square over its pixels of the standard error of their luminance,
/// over the mean luminance of the picture. Infinite where no pixel has two samples; 0 for a black
/// picture. With thousands of pixels its own error is small, so it needs no bound.
[[nodiscard]] double pictureError(const Film& film, const PixelRect& rect);

/// Parts of a picture's error that add up, so that it can be found by many workers.
struct ErrorSum {
    double squares = 0, fourths = 0, light = 0;  ///< of the standard errors; of the means
    std::int64_t pixels = 0;

    void add(const FilmPixel& pixel);
    void add(const ErrorSum& other);
    [[nodiscard]] double relativeError() const;  ///< pictureError()
    /// As many pixels with errors alike would tell as much: few where an edge or a caustic makes
    /// most of the error. From the fourth moment, which is 3 sigma^4 of a normal distribution
    /// (Satterthwaite 1946 matches the same two moments).
    [[nodiscard]] double effectivePixels() const;
};

/// Bounds of the errors of all tiles: tileError() times errorBoundFactor() of the effective pixels,
/// as a share of the mean luminance of the picture. What is rare may have been missed by all
/// samples of a tile and seen by those beside: a tile's square counts for no less than an eighth of
/// the mean of its 3 x 3 neighbours.
struct TileErrors {
    static constexpr int kTile = kErrorTile;
    int columns = 0;
    std::vector<float> bounds;  ///< row-major; below 0: not known yet

    /// The tile's bound at a pixel.
    [[nodiscard]] std::optional<float> at(int x, int y) const {
        const auto i = static_cast<std::size_t>(y / kTile) * static_cast<std::size_t>(columns) +
                       static_cast<std::size_t>(x / kTile);
        if (x < 0 || y < 0 || x / kTile >= columns || i >= bounds.size() || bounds[i] < 0)
            return std::nullopt;
        return bounds[i];
    }
};

/// The errors of a film, found on many threads.
struct FilmErrors {
    TileErrors tiles;
    double picture = kInfinity;  ///< pictureError() of the rectangle asked for
    double meanSamples = 0;      ///< a pixel of that rectangle
    int leastSamples = 0;        ///< that every pixel of it has
};
/// Bounds of all tiles, and the error of the pixels of `rect`. False when cancelled: `out` is then
/// of no use.
bool findErrors(const Film& film, const PixelRect& rect, WorkerPool& pool,
                const CancelToken& cancel, FilmErrors& out);

}  // namespace glint
