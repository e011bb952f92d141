// Scheduler: renders passes over a film in tiles of 16 x 16, on a worker pool. Knows nothing of stop rules or display.
#pragma once

#include <optional>
#include <vector>

#include "tracer/render/layers.h"
#include "tracer/render/tile_error.h"

namespace glint {

/// What was done so far on one film.
struct RenderCounts {
    RayCounts rays;
    WorkCounts work;
    std::uint64_t nonfinite = 0;  ///< samples that were not finite: counted as black
    std::optional<SamplePlace> firstNonfinite;
};

/// What a pass is to bring the pixels to.
struct SampleGoal {
    std::uint32_t samples = 1;  ///< that every pixel is to have, unless `tiles` says it by tile
    const std::vector<std::uint32_t>* tiles = nullptr;  ///< the same for each tile of 8 x 8 pixels of the film, row-major
    std::uint32_t most = ~0u;   ///< new samples that a pixel gets in this pass
};

enum class PassResult { Done, Partial, Cancelled };  ///< Partial: `most` left pixels short of the goal

class Scheduler {
  public:
    /// `wanted`: what kernels must offer beside what the scene holds, see chooseKernel().
    explicit Scheduler(WorkerPool& pool, Features wanted = 0) : pool_(pool), wanted_(wanted) {}

    /// Brings every pixel of `rect` whose x and y are multiples of `stride` to the goal. When cancelled, finished samples stay,
    /// and the same call later goes on where it ended. `layers` may be null.
    PassResult renderPass(const RenderScene& scene, Film& film, LayerFilm* layers, const PixelRect& rect, int stride,
                          const SampleGoal& goal, const CancelToken& cancel, RenderCounts& counts);

  private:
    WorkerPool& pool_;
    Features wanted_;
};

}  // namespace glint
