#include "tracer/render/outlines.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <unordered_map>

#include "tracer/render/tile_view.h"

namespace glint {

namespace {

/// Rays of a pixel at most in the first call of refine().
constexpr int kMostProbes = 64;
/// Of an edge that lies anywhere between the middles of two neighbours: how much of the other's
/// light one takes, and its error then over the step. With the share a of the other, the squared
/// error is the mean of those of an edge within the pixel, evenly in [-a, 1/2 - a], and of one
/// within the other, a^2: least at a = 1/8.
constexpr float kEdgeShare = 0.125f, kEdgeError = 0.16f;
/// What the curvature told by neighbours is wrong by.
constexpr float kCurvatureError = 0.5f;

}  // namespace

struct alignas(64) Outlines::Worker {
    Worker(const RenderScene& scene, const CancelToken& cancel)
        : state{.scene = scene, .cancel = cancel} {}

    /// A probe on a side of a pixel, which two pixels ask for.
    struct Shared {
        Probe probe;
        std::uint64_t materials;
    };

    KernelState state;
    FewShapes seen;
    std::uint64_t materials = 0;                       ///< of the pixel
    std::uint32_t probes = 0;                          ///< of the pixel, also their numbers
    std::unordered_map<std::uint64_t, Shared> shared;  ///< of the tile, by place
    std::vector<Entry> entries;
};

/// One call of look() or refine().
struct Outlines::Run {
    Run(const RenderScene& scene, WorkerPool& threads, const CancelToken& token)
        : pool(threads),
          cancel(token),
          workers(static_cast<std::size_t>(threads.threads()), Worker(scene, token)) {}

    void addTo(RenderCounts& counts) const {
        for (const Worker& worker : workers) counts.add(worker.state.rays, worker.state.work);
    }

    WorkerPool& pool;
    const CancelToken& cancel;
    std::vector<Worker> workers;
};

bool Outlines::suit(const RenderScene& scene) {
    const auto& lights = scene.lights.lights;
    for (std::size_t i = 0; i < lights.size(); ++i)
        if (i != scene.lights.environmentLight && !lights[i].isDelta()) return false;
    return scene.settings.integrator == Integrator::Classic && scene.film.filter == Filter::Box &&
           scene.film.filterRadius == 0.5 && !scene.camera.hasLens();
}

Outlines::Outlines(const RenderScene& scene, Features wanted, const PixelRect& rect, double error)
    : scene_(scene),
      trace_(chooseKernel(scene, wanted).trace),
      culls_(!has(wanted, Feature::NoSkips)),
      wantedError_(error),
      rect_(rect),
      tiles_{rect.x / Film::kTile, rect.y / Film::kTile, 0, 0},
      pixels_(static_cast<std::size_t>(rect.width) * static_cast<std::size_t>(rect.height)) {
    tiles_.width = (rect.x + rect.width + Film::kTile - 1) / Film::kTile - tiles_.x;
    tiles_.height = (rect.y + rect.height + Film::kTile - 1) / Film::kTile - tiles_.y;
    expected_.resize(static_cast<std::size_t>(tiles_.width) *
                     static_cast<std::size_t>(tiles_.height));
}

bool Outlines::look(Film& film, WorkerPool& pool, const CancelToken& cancel, RenderCounts& counts) {
    Run run(scene_, pool, cancel);
    const bool complete =
        eachWanted(run, true, [&](Worker& worker, int x, int y) { lookAt(worker, x, y); }) &&
        eachWanted(run, false, [&](Worker&, int x, int y) { putMiddle(film, x, y); });
    run.addTo(counts);
    sumUp();
    return complete;
}

bool Outlines::refine(Film& film, WorkerPool& pool, const CancelToken& cancel,
                      RenderCounts& counts) {
    Run run(scene_, pool, cancel);
    const double tolerance = this->tolerance();
    for (Pixel& pixel : pixels_)
        pixel.isWanted = !pixel.isHard && (pixel.error > tolerance || pixel.middle.doubt < 0);
    ++calls_;
    bool complete = true;
    do
        complete = eachWanted(run, true, [&](Worker& worker, int x, int y) {
            refine(film, worker, x, y, tolerance);
        });
    while (complete && follow(run));
    run.addTo(counts);
    sumUp();
    return complete;
}

/// Visits the pixels that are wanted, each tile of the film by one worker, which is made ready for
/// it if it `traces`.
template <class Visit>
bool Outlines::eachWanted(Run& run, bool traces, const Visit& visit) {
    std::atomic<bool> complete{true};  // Only a flag, read when all workers have ended: relaxed.
    run.pool.run(tiles_.width * tiles_.height, [&](int index, int piece) {
        Worker& worker = run.workers[static_cast<std::size_t>(index)];
        const int column = tiles_.x + piece % tiles_.width, row = tiles_.y + piece / tiles_.width;
        const int x0 = std::max(rect_.x, column * Film::kTile),
                  x1 = std::min(rect_.x + rect_.width, (column + 1) * Film::kTile);
        const int y0 = std::max(rect_.y, row * Film::kTile),
                  y1 = std::min(rect_.y + rect_.height, (row + 1) * Film::kTile);
        bool isReady = !traces;
        for (int y = y0; y < y1; ++y)
            for (int x = x0; x < x1; ++x) {
                if (!at(x, y).isWanted) continue;
                if (run.cancel.cancelled()) return complete.store(false, std::memory_order_relaxed);
                if (!std::exchange(isReady, true)) {
                    worker.shared.clear();
                    worker.state.expected = &expected_[static_cast<std::size_t>(piece)];
                    worker.state.seen =
                        culls_ ? shapesSeen(scene_, x0, y0, x1, y1, worker.seen) : nullptr;
                }
                visit(worker, x, y);
            }
    });
    return complete.load(std::memory_order_relaxed);
}

// ---- One ray a pixel ----

/// One ray through a place of the pixel.
Probe Outlines::probe(Worker& worker, int x, int y, const DVec2& u) const {
    const Sampler sampler = samplerFor(scene_, x, y, worker.probes++);
    const Rgb value = trace_(worker.state, scene_.camera.ray(x + u.x, y + u.y), sampler);
    worker.materials |= worker.state.materials;
    if (isFinite(value) && std::isfinite(worker.state.doubt))
        return {value, worker.state.trail, std::sqrt(worker.state.doubt)};
    return {isFinite(value) ? value : Rgb(0.0f), worker.state.trail, -1};
}

void Outlines::lookAt(Worker& worker, int x, int y) {
    Pixel& pixel = at(x, y);
    worker.probes = 0;
    worker.materials = 0;
    pixel.middle = probe(worker, x, y, DVec2(0.5));
    pixel.materials = worker.materials;
}

/// What the middles of the pixel and its neighbours tell of it.
void Outlines::putMiddle(Film& film, int x, int y) {
    Pixel& pixel = at(x, y);
    const Pixel* const here = &pixel;
    const Probe& own = pixel.middle;
    pixel.step = 0;
    bool isSmooth = true;
    const std::ptrdiff_t left = x > rect_.x ? -1 : 0, right = x + 1 < rect_.x + rect_.width ? 1 : 0;
    const std::ptrdiff_t above = y > rect_.y ? -rect_.width : 0,
                         below = y + 1 < rect_.y + rect_.height ? rect_.width : 0;
    const auto compare = [&](std::ptrdiff_t place) {
        const Probe& other = here[place].middle;
        if (other.trail == own.trail && !(other.doubt < 0)) return;
        pixel.step = std::max(pixel.step, lightOf(other.value - own.value));
        isSmooth = false;
    };
    for (const std::ptrdiff_t row : {above, std::ptrdiff_t{0}, below})
        compare(row + left), compare(row), compare(row + right);
    const Rgb beyond = beyondMiddle(x, y);
    const float unsure = isSmooth ? kCurvatureError * lightOf(beyond) : kEdgeError * pixel.step,
                doubt = std::max(own.doubt, 0.0f);
    pixel.error = std::sqrt(unsure * unsure + doubt * doubt);
    film.put(x, y, glm::max(own.value + beyond, 0.0f), pixel.error, 1, pixel.materials);
}

/// What the mean over the pixel is more than the middle, as far as neighbours tell: a 24th of the
/// second differences where all is smooth, a share of what is beyond an edge.
Rgb Outlines::beyondMiddle(int x, int y) const {
    Rgb out(0.0f);
    const Pixel* pixel = &at(x, y);
    const Probe& own = pixel->middle;
    const bool hasColumns = x > rect_.x && x + 1 < rect_.x + rect_.width,
               hasRows = y > rect_.y && y + 1 < rect_.y + rect_.height;
    for (const std::ptrdiff_t stride : {hasColumns ? 1 : 0, hasRows ? rect_.width : 0}) {
        if (stride == 0) continue;
        const Probe &before = pixel[-stride].middle, &after = pixel[stride].middle;
        const bool isBefore = before.trail == own.trail, isAfter = after.trail == own.trail;
        if (isBefore && isAfter)
            out += (before.value + after.value - 2.0f * own.value) * (1.0f / 24);
        else
            out += (isBefore ? 0.0f : kEdgeShare) * (before.value - own.value) +
                   (isAfter ? 0.0f : kEdgeShare) * (after.value - own.value);
    }
    return out;
}

// ---- More rays ----

/// The most that a pixel may err by, so that half the square of the picture's error remains.
double Outlines::tolerance() const {
    // Errors by their size in fourths of octaves.
    struct Bin {
        double squares = 0, count = 0;
    };
    constexpr int kBins = 256;
    std::array<Bin, kBins> bins;
    double light = 0, squares = 0;
    for (const Pixel& pixel : pixels_) {
        light += static_cast<double>(luminance(pixel.middle.value));
        if (!(pixel.error > 0) || pixel.isHard) continue;
        const int i = std::clamp(
            static_cast<int>(std::floor(4 * std::log2(pixel.error))) + kBins / 2, 0, kBins - 1);
        const double square = static_cast<double>(pixel.error) * static_cast<double>(pixel.error);
        bins[static_cast<std::size_t>(i)].squares += square;
        bins[static_cast<std::size_t>(i)].count += 1;
        squares += square;
    }
    const double allowed = 0.5 * wantedError_ * wantedError_ * light * light /
                           static_cast<double>(pixels_.size());  // sum of squares
    // From the largest down: all above the tolerance are brought to it.
    double above = 0;
    for (int i = kBins - 1; i >= 0; --i) {
        const Bin& bin = bins[static_cast<std::size_t>(i)];
        const double least = std::exp2((i - kBins / 2) / 4.0);
        squares -= bin.squares;
        above += bin.count;
        if (squares + above * least * least <= allowed)
            return std::sqrt((allowed - squares) / std::max(1.0, above));
    }
    return 0;
}

/// As probe(), asked once where two pixels meet.
Probe Outlines::sharedProbe(Worker& worker, int x, int y, const DVec2& u) const {
    if (u.x != 0 && u.x != 1 && u.y != 0 && u.y != 1) return probe(worker, x, y, u);
    const auto place = [](int pixel, double v) {
        return static_cast<std::uint64_t>(std::ldexp(pixel % Film::kTile + v, 26));
    };
    const std::uint64_t key = place(x, u.x) << 32 | place(y, u.y);
    if (const auto known = worker.shared.find(key); known != worker.shared.end()) {
        worker.materials |= known->second.materials;
        return known->second.probe;
    }
    const std::uint64_t before = std::exchange(worker.materials, 0);
    const Probe out = probe(worker, x, y, u);
    worker.shared.emplace(key, Worker::Shared{out, worker.materials});
    worker.materials |= before;
    return out;
}

void Outlines::refine(Film& film, Worker& worker, int x, int y, double tolerance) {
    Pixel& pixel = at(x, y);
    worker.probes = 1;
    worker.materials = pixel.materials;
    OutlineMean mean;
    const std::function<Probe(const DVec2&)> ask = [&](const DVec2& u) {
        return sharedProbe(worker, x, y, u);
    };
    const bool told = pixel.middle.doubt >= 0 &&
                      OutlineCell(ask).integrate(pixel.middle, tolerance, pixel.split,
                                                 kMostProbes << (calls_ - 1), pixel.step, mean);
    if (worker.state.cancelled) return;
    pixel.isHard = !told || (isDone() && mean.error > tolerance);
    if (pixel.isHard) return film.clear({x, y, 1, 1});
    pixel.error = static_cast<float>(mean.error);
    film.put(x, y, glm::max(toFloat(mean.value), 0.0f), pixel.error, worker.probes,
             worker.materials);
    constexpr std::array<std::array<int, 2>, 4> kSides{{{0, -1}, {1, 0}, {0, 1}, {-1, 0}}};
    for (std::size_t i = 0; i < 4; ++i) {
        const OutlineMean::Crossed& crossed = mean.crossed[i];
        if (crossed.depth < 0) continue;
        pixel.crossed[i] = true;
        if (std::ldexp(static_cast<double>(kEdgeError) * crossed.step, -crossed.depth) > tolerance)
            worker.entries.push_back(
                {x + kSides[i][0], y + kSides[i][1], (i + 2) & 3, crossed.depth});
    }
}

/// Wants the pixels into which an outline goes that was not known of there; false if there are
/// none.
bool Outlines::follow(Run& run) {
    constexpr int kMostSplit = 2;
    for (Pixel& pixel : pixels_) pixel.isWanted = false;
    bool any = false;
    for (Worker& worker : run.workers) {
        for (const Entry& entry : worker.entries) {
            if (!holds(entry.x, entry.y)) continue;
            Pixel& pixel = at(entry.x, entry.y);
            const auto split = static_cast<std::int8_t>(std::min(entry.split, kMostSplit));
            if (pixel.isHard || pixel.crossed[entry.side] ||
                (pixel.isEntered && split <= pixel.split))
                continue;
            pixel.split = std::max(pixel.split, split);
            pixel.isEntered = pixel.isWanted = any = true;
        }
        worker.entries.clear();
    }
    return any;
}

void Outlines::sumUp() {
    double squares = 0, light = 0;
    for (const Pixel& pixel : pixels_) {
        light += static_cast<double>(luminance(pixel.middle.value));
        if (!pixel.isHard)
            squares += static_cast<double>(pixel.error) * static_cast<double>(pixel.error);
    }
    const auto count = static_cast<double>(pixels_.size());
    error_ = light > 0 ? std::sqrt(squares / count) / (light / count) : 0;
}

}  // namespace glint
