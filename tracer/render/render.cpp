#include "tracer/render/render.h"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <limits>
#include <thread>

#include "tracer/render/adaptive.h"
#include "tracer/render/bands.h"
#include "tracer/render/outlines.h"
#include "tracer/render/preview_filter.h"
#include "tracer/render/scheduler.h"
#include "tracer/render/stop_rule.h"
#include "tracer/render/tile_error.h"

namespace glint {

namespace {

using Clock = std::chrono::steady_clock;

/// Bytes that the system can give without swapping; nothing where it does not say.
std::optional<double> freeMemory() {
    std::ifstream file("/proc/meminfo");
    std::string name, unit;
    for (double kibibytes = 0; file >> name >> kibibytes; std::getline(file, unit))
        if (name == "MemAvailable:") return 1024 * kibibytes;
    return std::nullopt;
}

double bytesFor(const RenderRequest& request) {
    return request.memory > 0 ? request.memory : freeMemory().value_or(kInfinity);
}

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Runs the passes of one render on the calling thread and reports.
class HeadlessRender {
  public:
    HeadlessRender(const std::shared_ptr<const RenderScene>& scene, const RenderRequest& request)
        : shared_(scene),
          scene_(*scene),
          request_(request),
          pool_(request.threads > 0
                    ? request.threads
                    : std::max(1, static_cast<int>(std::thread::hardware_concurrency()))),
          film_(scene->film.width, scene->film.height) {
        if (request.layers || request.alpha)
            layers_.emplace(
                scene->film.width, scene->film.height,
                request.layers ? LayerFilm::Content::All : LayerFilm::Content::Coverage);
    }

    /// Puts what is rendered into `picture`, which has the film's size; the rendering's own beauty
    /// stays empty.
    Rendering run(Image& picture) {
        flushDenormals();
        Scheduler scheduler(pool_, wantedFeatures());
        // A request to stop and the end of the time are an epoch that moves; a thread of its own
        // watches for them.
        std::jthread watcher;
        if (request_.stop || scene_.settings.timeSeconds > 0)
            watcher = std::jthread([this](const std::stop_token& end) { watch(end); });
        rect_ = request_.crop.value_or(PixelRect{0, 0, scene_.film.width, scene_.film.height});
        if (samplesAdaptively(scene_.settings) && !layers_ && Outlines::suit(scene_))
            outlines_.emplace(scene_, wantedFeatures(), rect_, 0.01 * scene_.settings.errorPercent);
        bool complete = true, stopped = false;
        while (complete && !isDone(scene_.settings, state()) && anotherSampleFits()) {
            if ((stopped = !waitWhilePaused())) break;
            complete = pass(scheduler);
            report();
        }
        film_.paint(rect_, pool_, picture);
        return finish(stopped || (!complete && !timeIsUp()));
    }

  private:
    /// Seconds spent on the picture, pauses left out.
    [[nodiscard]] double elapsed() const {
        return secondsSince(start_) - paused_.load(std::memory_order_relaxed);
    }
    [[nodiscard]] bool timeIsUp() const {
        return scene_.settings.timeSeconds > 0 && elapsed() >= scene_.settings.timeSeconds;
    }
    [[nodiscard]] bool stopAsked() const {
        return request_.stop && request_.stop->load(std::memory_order_relaxed);
    }

    /// One more sample a pixel would end in time: a pass that is cut short leaves pixels uneven.
    [[nodiscard]] bool anotherSampleFits() const {
        const int done = errors_.leastSamples;
        return scene_.settings.timeSeconds <= 0 || done == 0 ||
               samplesAdaptively(scene_.settings) ||
               elapsed() * (done + 1) / done <= scene_.settings.timeSeconds;
    }

    /// False if the caller wants an end rather than the next pass.
    [[nodiscard]] bool waitWhilePaused() {
        while (request_.pause && request_.pause->load(std::memory_order_relaxed) && !stopAsked()) {
            const Clock::time_point from = Clock::now();
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
            paused_.fetch_add(secondsSince(from), std::memory_order_relaxed);
        }
        return !stopAsked();
    }

    [[nodiscard]] Features wantedFeatures() const {
        switch (request_.kernel) {
            case KernelChoice::Smallest:
                break;
            case KernelChoice::Full:
                return kAllFeatures;
            case KernelChoice::NoSkips:
                return static_cast<Features>(Feature::NoSkips);
        }
        return 0;
    }

    /// Raises the epoch when the caller asks to stop or the time is up.
    void watch(const std::stop_token& end) {
        while (!end.stop_requested()) {
            if (stopAsked() ||
                (timeIsUp() && everyPixelHasASample_.load(std::memory_order_relaxed)))
                epoch_.store(1, std::memory_order_relaxed);
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
    }

    /// Most of the error is of what is told by outlines.
    [[nodiscard]] bool needsOutlines() const {
        return outlines_ && !outlines_->isDone() && goals_.empty() &&
               errors_.leastSamples >= adaptiveRule(Integrator::Classic).believed &&
               0.8 * errors_.picture < outlines_->error();
    }

    /// One pass; false when cancelled. Uniform ones bring all pixels to one number of samples,
    /// adaptive ones are parts of a stage.
    bool pass(Scheduler& scheduler) {
        const int done = errors_.leastSamples, most = samplesInPass();
        const CancelToken cancel{&epoch_, 0};
        if (outlines_ && counts_.rays.primary == 0)
            return told(outlines_->look(film_, pool_, cancel, counts_));
        if (needsOutlines()) return told(outlines_->refine(film_, pool_, cancel, counts_));
        SampleGoal goal;
        if (samplesAdaptively(scene_.settings)) {
            if (goals_.empty())
                nextGoals(film_, rect_, static_cast<std::uint32_t>(scene_.settings.spp),
                          adaptiveRule(scene_.settings.integrator), pool_, {}, goals_);
            goal = {.cells = &goals_, .most = static_cast<std::uint32_t>(most)};
        } else {
            goal.samples = static_cast<std::uint32_t>(std::min(scene_.settings.spp, done + most));
        }
        const PassResult result = scheduler.renderPass(scene_, film_, layers_ ? &*layers_ : nullptr,
                                                       rect_, 1, goal, cancel, counts_);
        everyPixelHasASample_.store(done > 0 || result != PassResult::Cancelled,
                                    std::memory_order_relaxed);
        if (result == PassResult::Partial) return true;
        if (result == PassResult::Done) goals_ = {};
        return told(result == PassResult::Done);
    }

    /// The rule by error is asked when a stage is whole, so that it does not depend on timing.
    bool told(bool complete) {
        findErrors(film_, rect_, pool_, {}, errors_);
        if (errors_.leastSamples > 0) everyPixelHasASample_.store(true, std::memory_order_relaxed);
        trend_.add(elapsed(), errors_.picture);
        return complete;
    }

    [[nodiscard]] RenderProgressState state() const {
        return {elapsed(), errors_.meanSamples, errors_.leastSamples, errors_.picture};
    }

    /// Passes grow from one sample, so that there is something to show early, to about half a
    /// second of work.
    [[nodiscard]] int samplesInPass() const {
        const double pixels = static_cast<double>(rect_.width) * rect_.height;
        if (counts_.rays.primary == 0 || !(pixels > 0)) return 1;
        const double perSample = elapsed() * pixels / static_cast<double>(counts_.rays.primary);
        double budget = 0.5;
        if (scene_.settings.timeSeconds > 0)
            budget =
                std::min(budget, std::max(0.0, (scene_.settings.timeSeconds - elapsed()) * 0.5));
        // A stage of adaptive sampling is itself but a part of what was done before it.
        const int most = samplesAdaptively(scene_.settings) ? std::numeric_limits<int>::max()
                                                            : errors_.leastSamples;
        return std::clamp(static_cast<int>(std::min(1e6, budget / perSample)), 1,
                          std::max(1, most));
    }

    void report() const {
        if (!request_.progress) return;
        const double seconds = elapsed(), left = remainingSeconds(scene_.settings, state(), trend_);
        const double fraction = left < kInfinity && seconds > 0 ? seconds / (seconds + left) : 0;
        request_.progress({errors_.leastSamples, scene_.settings.spp, seconds,
                           left < kInfinity ? left : 0, fraction, errors_.picture});
    }

    Rendering finish(bool interrupted) {
        Rendering out;
        if (request_.filter) out.filtered = filtered();
        if (request_.alpha) out.alpha = layers_->coverage();
        if (request_.layers) {
            appendFilm(film_, out.layers);
            layers_->appendTo(out.layers, scene_.settings.integrator == Integrator::Path);
        }
        out.spp = errors_.leastSamples;
        out.even = errors_.meanSamples == errors_.leastSamples;
        out.threads = pool_.threads();
        out.seconds = elapsed();
        out.error = errors_.picture;
        out.rays = counts_.rays;
        out.work = counts_.work;
        out.kernel =
            chooseKernel(scene_,
                         wantedFeatures() | (layers_ ? static_cast<Features>(Feature::Layers) : 0))
                .name;
        out.nonfiniteSamples = counts_.nonfinite;
        out.firstNonfinite = counts_.firstNonfinite;
        out.interrupted = interrupted;
        return out;
    }

    /// The film denoised; only of the part that is rendered, where every pixel has a sample.
    [[nodiscard]] Image filtered() {
        Image out{film_.width(), film_.height(), {}};
        out.rgb.resize(3 * static_cast<std::size_t>(out.width) *
                       static_cast<std::size_t>(out.height));
        if (errors_.leastSamples == 0) return out;
        GuideFilm guides;
        guides.refine(shared_, out.width, out.height, 1, GuideFilm::kSamples, {}, pool_);
        std::vector<Rgb> pixels;
        PreviewFilter().run(film_, guides, pool_, {}, pixels);
        for (std::size_t i = 0; i < pixels.size(); ++i)
            for (int c = 0; c < 3; ++c) out.rgb[3 * i + static_cast<std::size_t>(c)] = pixels[i][c];
        return out;
    }

    std::shared_ptr<const RenderScene> shared_;
    const RenderScene& scene_;
    const RenderRequest& request_;
    Clock::time_point start_ = Clock::now();
    WorkerPool pool_;
    Film film_;
    std::optional<LayerFilm> layers_;
    RenderCounts counts_;
    PixelRect rect_;  ///< what is rendered
    FilmErrors errors_;
    ErrorTrend trend_;
    std::optional<Outlines> outlines_;  ///< where they suit the picture
    CellGoals goals_;                   ///< of the adaptive stage under way; empty: there is none
    std::atomic<double> paused_{0};     ///< seconds; counted by run(), read by watch(), relaxed
    std::atomic<std::uint64_t> epoch_{
        0};  ///< moved by watch(); partner: the workers' CancelToken, relaxed
    std::atomic<bool> everyPixelHasASample_{false};  ///< partner: watch(), relaxed
};

}  // namespace

std::optional<Error> memoryProblem(const RenderScene& scene, const RenderRequest& request) {
    const Result<int> rows = rowsAtOnce(scene, request, bytesFor(request));
    return rows ? std::nullopt : std::optional(rows.error());
}

Rendering render(const std::shared_ptr<const RenderScene>& scene, const RenderRequest& request) {
    const auto renderPart = [&](const RenderRequest& part, Image& picture) {
        return HeadlessRender(scene, part).run(picture);
    };
    const int height = request.crop ? request.crop->height : scene->film.height;
    // What does not fit is memoryProblem()'s to refuse; who has not asked gets what the system
    // makes of it.
    const Result<int> rows = rowsAtOnce(*scene, request, bytesFor(request));
    if (rows && rows.value() < height)
        return renderInBands(*scene, request, rows.value(), renderPart);
    Image picture{scene->film.width, scene->film.height, {}};
    picture.rgb.resize(3 * static_cast<std::size_t>(picture.width) *
                       static_cast<std::size_t>(picture.height));
    Rendering out = renderPart(request, picture);
    out.beauty = std::move(picture);
    return out;
}

Rgb renderSample(const RenderScene& scene, const SamplePlace& place) {
    KernelState state{scene, {}, {}, false};
    return chooseKernel(scene).run(state, place.x, place.y,
                                   static_cast<std::uint32_t>(place.sample));
}

}  // namespace glint
