#include "tracer/render/scheduler.h"

#include <algorithm>
#include <utility>

#include "tracer/render/tile_view.h"

namespace glint {

namespace {

/// One worker's share of a pass; padded so that workers do not write to the same cache line.
struct alignas(64) WorkerCounts {
    RenderCounts counts;
    FewShapes seen;  ///< of the piece that it is at
    bool cancelled = false, partial = false;
};

void merge(RenderCounts& into, const RenderCounts& from) {
    into.add(from.rays, from.work);
    into.nonfinite += from.nonfinite;
    if (!into.firstNonfinite) into.firstNonfinite = from.firstNonfinite;
}

/// One pass, as all workers see it.
class Pass {
  public:
    Pass(const RenderScene& scene, Features wanted, Film& film, LayerFilm* layers,
         FirstHits* firstHits, const PixelRect& rect, int stride, const SampleGoal& goal,
         const CancelToken& cancel)
        : scene_(scene),
          film_(film),
          layers_(layers),
          firstHits_(firstHits),
          rect_(rect),
          stride_(stride),
          goal_(goal),
          cancel_(cancel),
          kernel_(
              chooseKernel(scene, wanted | (layers ? static_cast<Features>(Feature::Layers) : 0))
                  .run),
          culls_(!has(wanted, Feature::NoSkips)),
          // A piece of a coarse pass covers more pixels, so that it holds as many samples as any
          // other. Pieces are made of whole tiles of the film, which have one writer at a time.
          size_(Film::kTile * std::min(stride, 16)),
          firstColumn_(rect.x / size_),
          firstRow_(rect.y / size_),
          columns_((rect.x + rect.width + size_ - 1) / size_ - firstColumn_),
          rows_((rect.y + rect.height + size_ - 1) / size_ - firstRow_) {}

    [[nodiscard]] int pieces() const { return std::max(columns_, 0) * std::max(rows_, 0); }

    void render(int piece, WorkerCounts& own) {
        LayerSample layerSample;
        GroupLight groups{};
        KernelState state{.scene = scene_,
                          .cancel = cancel_,
                          .layers = &layerSample,
                          .groups = film_.groups() > 1 ? &groups : nullptr};
        const int left = (firstColumn_ + piece % columns_) * size_,
                  top = (firstRow_ + piece / columns_) * size_;
        const int x1 = std::min(left + size_, rect_.x + rect_.width),
                  y1 = std::min(top + size_, rect_.y + rect_.height);
        const int x0 = onGrid(std::max(left, rect_.x)), y0 = onGrid(std::max(top, rect_.y));
        bool culled = false;
        for (int y = y0; y < y1 && !own.cancelled; y += stride_)
            for (int x = x0; x < x1 && !own.cancelled; x += stride_) {
                if (film_.samples(x, y) >= goalOf(x, y)) continue;
                if (!std::exchange(culled, true))
                    state.seen = culls_ ? shapesSeen(scene_, x0, y0, x1, y1, own.seen) : nullptr;
                renderPixel(state, x, y, own);
            }
        own.counts.add(state.rays, state.work);
    }

  private:
    [[nodiscard]] int onGrid(int v) const { return (v + stride_ - 1) / stride_ * stride_; }
    [[nodiscard]] std::uint32_t goalOf(int x, int y) const {
        return goal_.cells ? goal_.cells->at(x, y) : goal_.samples;
    }

    Rgb trace(KernelState& state, int x, int y, std::uint32_t sample) {
        if (!firstHits_ || sample > 0) return kernel_(state, x, y, sample);
        std::optional<ShapeHit> hit = firstHits_->find(x, y);
        const bool known = hit.has_value();
        state.cameraHit = &hit;
        const Rgb value = kernel_(state, x, y, sample);
        state.cameraHit = nullptr;
        if (hit && !known) firstHits_->keep(x, y, *hit);
        return value;
    }

    void renderPixel(KernelState& state, int x, int y, WorkerCounts& own) {
        const std::uint32_t goal = goalOf(x, y), begin = film_.samples(x, y);
        for (std::uint32_t sample = begin; sample < goal; ++sample) {
            if (sample - begin >= goal_.most) {
                own.partial = true;
                return;
            }
            if (layers_) *state.layers = {};
            Rgb value = trace(state, x, y, sample);
            if (state.cancelled) {
                own.cancelled = true;
                return;
            }
            if (!isFinite(value)) {
                ++own.counts.nonfinite;
                if (!own.counts.firstNonfinite)
                    own.counts.firstNonfinite = SamplePlace{x, y, static_cast<int>(sample)};
                value = Rgb(0.0f);
                *state.layers = {};
                if (state.groups) *state.groups = {};
            }
            if (layers_) layers_->add(x, y, *state.layers);
            film_.add(x, y, value, state.groups ? *state.groups : GroupLight{}, state.materials);
        }
    }

    const RenderScene& scene_;
    Film& film_;
    LayerFilm* layers_;
    FirstHits* firstHits_;
    const PixelRect& rect_;
    int stride_;
    const SampleGoal& goal_;
    const CancelToken& cancel_;
    KernelFunction kernel_;
    bool culls_;
    int size_, firstColumn_, firstRow_, columns_, rows_;
};

}  // namespace

PassResult Scheduler::renderPass(const RenderScene& scene, Film& film, LayerFilm* layers,
                                 const PixelRect& rect, int stride, const SampleGoal& goal,
                                 const CancelToken& cancel, RenderCounts& counts) {
    if (firstHits_) firstHits_->takeUp(scene);
    Pass pass(scene, wanted_, film, layers, firstHits_, rect, stride, goal, cancel);
    std::vector<WorkerCounts> workers(static_cast<std::size_t>(pool_.threads()));
    pool_.run(pass.pieces(), [&](int worker, int piece) {
        WorkerCounts& own = workers[static_cast<std::size_t>(worker)];
        if (!own.cancelled) pass.render(piece, own);
    });
    bool cancelled = false, partial = false;
    for (const WorkerCounts& worker : workers) {
        merge(counts, worker.counts);
        cancelled = cancelled || worker.cancelled;
        partial = partial || worker.partial;
    }
    return cancelled ? PassResult::Cancelled : partial ? PassResult::Partial : PassResult::Done;
}

}  // namespace glint
