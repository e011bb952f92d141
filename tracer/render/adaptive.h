// Adaptive sampling: which cells of a film get samples next, so that the error of the picture falls
// fastest. Cells are chosen by half A of the film alone, so that half B stays free of bias, and
// their counts are powers of two, so that the samples stay well spread.
#pragma once

#include <limits>

#include "tracer/render/film.h"
#include "tracer/render/sample_goal.h"
#include "tracer/render/worker_pool.h"
#include "tracer/scene/scene.h"

namespace glint {

/// How an integrator's pictures are sampled by their error.
struct AdaptiveRule {
    int cell;               ///< pixels a side that have one number of samples
    std::uint32_t uniform;  ///< samples up to which all cells go together
    std::uint32_t spread;   ///< no cell falls behind the furthest by more than this factor
    int believed;  ///< samples of every pixel from which on the error is believed: fewer may by
                   ///< chance agree, and miss what is rare
    double fall;   ///< a cell's squared error falls as samples^-fall
    double
        trust;  ///< degrees of freedom that the mean variance of 3 x 3 cells is worth against the
                ///< cell's own: a rare event that one cell has missed is likely to show next to it
    double contrast;  ///< the variance between 3 x 3 cells tells of that within one: by this factor
};

/// `path` is noisy all over, and the variance of a pixel is known only after many samples: tiles. A
/// picture of `classic` errs at its edges, which the samples of a pixel and its neighbours tell at
/// once: pixels. Stratified, n samples of an edge err by n^-3/4. Two samples of each pixel and the
/// contrast to its neighbours come to the same error with three quarters of the rays that four
/// samples take without it. Where few rays tell pixels by their outlines (outlines.h), only those
/// are left that these do not tell.
[[nodiscard]] constexpr AdaptiveRule adaptiveRule(Integrator integrator) {
    if (integrator == Integrator::Classic)
        return {.cell = 1,
                .uniform = 2,
                .spread = 128,
                .believed = 2,
                .fall = 1.5,
                .trust = 2,
                .contrast = 0.25};
    return {.cell = 8,
            .uniform = 64,
            .spread = 16,
            .believed = 16,
            .fall = 1,
            .trust = std::numeric_limits<double>::infinity(),
            .contrast = 0};
}

/// Most that nextGoals() takes for a cell [bytes].
inline constexpr double kBytesACell = 80;

/// Finds the goals for the next stage of a render; false when cancelled: `out` is then of no use.
/// Together they take about `spp` samples a pixel at most. A pure function of the film, in which
/// every cell that `rect` touches has reached its goal of the stage before (or has no samples); so
/// the course of a render does not depend on threads or timing.
///
/// Pixels whose light was put (Film::put) get none. Up to AdaptiveRule::uniform samples all cells
/// go together. Then each stage doubles the cells where that lowers the squared error of the
/// picture most for its cost, in order of (variance of a sample) / samples^(1 + fall), until a
/// stage costs a quarter of all samples so far.
bool nextGoals(const Film& film, const PixelRect& rect, std::uint32_t spp, const AdaptiveRule& rule,
               WorkerPool& pool, const CancelToken& cancel, CellGoals& out);

/// The samples that the cells of a film have.
[[nodiscard]] CellGoals goalsReached(const Film& film, const AdaptiveRule& rule);

}  // namespace glint
