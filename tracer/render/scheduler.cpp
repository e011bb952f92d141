#include "tracer/render/scheduler.h"

#include <algorithm>

namespace glint {

namespace {

/// One worker's share of a pass; padded so that workers do not write to the same cache line.
struct alignas(64) WorkerCounts {
    RenderCounts counts;
    bool cancelled = false;
};

void addSample(FilmPixel& pixel, const Rgb& value, int x, int y, RenderCounts& counts) {
    if (isFinite(value)) return pixel.add(value);
    ++counts.nonfinite;
    if (!counts.firstNonfinite) counts.firstNonfinite = SamplePlace{x, y, static_cast<int>(pixel.samples)};
    pixel.add(Rgb(0.0f));
}

void merge(RenderCounts& into, const RenderCounts& from) {
    into.rays.primary += from.rays.primary;
    into.rays.shadow += from.rays.shadow;
    into.rays.scatter += from.rays.scatter;
    into.work += from.work;
    into.nonfinite += from.nonfinite;
    if (!into.firstNonfinite) into.firstNonfinite = from.firstNonfinite;
}

}  // namespace

bool Scheduler::renderPass(const RenderScene& scene, Film& film, LayerFilm* layers, const PixelRect& rect, int stride,
                           std::uint32_t samples, const CancelToken& cancel, RenderCounts& counts) {
    const KernelFunction kernel = chooseKernel(scene, wanted_ | (layers ? static_cast<Features>(Feature::Layers) : 0)).run;
    // A tile of a coarse pass covers more pixels, so that it holds as many samples as any other.
    const int size = kTile * std::min(stride, 16);
    const int columns = (rect.width + size - 1) / size, rows = (rect.height + size - 1) / size;
    std::vector<WorkerCounts> workers(static_cast<std::size_t>(pool_.threads()));

    const auto renderTile = [&](int worker, int tile) {
        WorkerCounts& own = workers[static_cast<std::size_t>(worker)];
        LayerSample layerSample;
        KernelState state{scene, cancel, {}, false, &layerSample};
        const int x0 = rect.x + tile % columns * size, y0 = rect.y + tile / columns * size;
        const int x1 = std::min(x0 + size, rect.x + rect.width), y1 = std::min(y0 + size, rect.y + rect.height);
        const auto firstMultiple = [stride](int v) { return (v + stride - 1) / stride * stride; };
        for (int y = firstMultiple(y0); y < y1; y += stride)
            for (int x = firstMultiple(x0); x < x1; x += stride) {
                FilmPixel& pixel = film.at(x, y);
                while (pixel.samples < samples) {
                    if (layers) layerSample = {};
                    const Rgb value = kernel(state, x, y, pixel.samples);
                    if (state.cancelled) {
                        own.cancelled = true;
                        merge(own.counts, {state.rays, state.work, 0, {}});
                        return;
                    }
                    if (layers) layers->add(x, y, isFinite(value) ? layerSample : LayerSample{});
                    addSample(pixel, value, x, y, own.counts);
                }
            }
        merge(own.counts, {state.rays, state.work, 0, {}});
    };
    pool_.run(columns * rows, renderTile);

    bool complete = true;
    for (const WorkerCounts& worker : workers) {
        merge(counts, worker.counts);
        complete = complete && !worker.cancelled;
    }
    return complete;
}

}  // namespace glint
