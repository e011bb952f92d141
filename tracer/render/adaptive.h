// Adaptive sampling: which tiles get samples next, so that the error of the picture falls fastest. Tiles are chosen by half A of
// the film alone, so that half B stays free of bias, and their counts are powers of two, so that the samples stay well spread.
#pragma once

#include "tracer/render/tile_error.h"

namespace glint {

/// Goals for the next stage of a render: samples for each tile of 8 x 8 pixels, row-major, as SampleGoal::tiles. A pure function
/// of the film, in which every tile that `rect` touches has reached its goal of the stage before (or has no samples); so the
/// course of a render does not depend on threads or timing.
///
/// Up to kUniform samples all tiles go together. Then each stage doubles the tiles where that lowers the squared error of the
/// picture most for its cost, in order of (variance of a sample) / samples^2, until a stage costs a quarter of all samples so
/// far; no tile falls behind the furthest by more than kSpread. Variances are means over 3 x 3 tiles: a rare event that one tile
/// has missed is likely to show next to it.
class AdaptivePlan {
  public:
    static constexpr std::uint32_t kUniform = 64, kSpread = 16;

    /// The goals that come after the state of `film`; together they take about `spp` samples a pixel at most.
    static std::vector<std::uint32_t> next(const Film& film, const PixelRect& rect, std::uint32_t spp);
};

}  // namespace glint
