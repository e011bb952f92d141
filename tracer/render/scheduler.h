// Scheduler: renders passes over a film in tiles of 16 x 16, on a worker pool. Knows nothing of
// stop rules or display.
#pragma once

#include <optional>

#include "tracer/render/film.h"
#include "tracer/render/first_hits.h"
#include "tracer/render/layers.h"
#include "tracer/render/sample_goal.h"
#include "tracer/render/worker_pool.h"

namespace glint {

/// What was done so far on one film.
struct RenderCounts {
    RayCounts rays;
    WorkCounts work;
    std::uint64_t nonfinite = 0;  ///< samples that were not finite: counted as black
    std::optional<SamplePlace> firstNonfinite;

    /// What one worker has done.
    void add(const RayCounts& ofRays, const WorkCounts& ofWork) {
        rays += ofRays;
        work += ofWork;
    }
};

enum class PassResult {
    Done,
    Partial,
    Cancelled
};  ///< Partial: `most` left pixels short of the goal

class Scheduler {
  public:
    /// `wanted`: what kernels must offer beside what the scene holds, see chooseKernel().
    /// `firstHits`: if not null, what first samples hit is kept there and taken from there.
    explicit Scheduler(WorkerPool& pool, Features wanted = 0, FirstHits* firstHits = nullptr)
        : pool_(pool), wanted_(wanted), firstHits_(firstHits) {}

    /// Brings every pixel of `rect` whose x and y are multiples of `stride` to the goal. When
    /// cancelled, finished samples stay, and the same call later goes on where it ended. `layers`
    /// may be null.
    PassResult renderPass(const RenderScene& scene, Film& film, LayerFilm* layers,
                          const PixelRect& rect, int stride, const SampleGoal& goal,
                          const CancelToken& cancel, RenderCounts& counts);

  private:
    WorkerPool& pool_;
    Features wanted_;
    FirstHits* firstHits_;
};

}  // namespace glint
