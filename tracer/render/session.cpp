#include "tracer/render/session.h"

#include <pthread.h>

#include <algorithm>
#include <chrono>
#include <thread>
#include <variant>

#include "tracer/base/channel.h"
#include "tracer/compile/compiler.h"
#include "tracer/render/scheduler.h"
#include "tracer/render/skips.h"

namespace glint {

namespace {

using Clock = std::chrono::steady_clock;

struct SceneMessage {
    Scene scene;
    std::filesystem::path assetFolder;
    std::uint64_t revision = 0;
};
using Message = std::variant<SceneMessage, ViewSettings>;

/// The first pass after an edit is never cancelled, so that a drag always shows motion; it is sized to take this long.
constexpr double kFirstPassSeconds = 0.005;
/// A pass at full resolution takes about this long at most, so that the picture is seen to sharpen.
constexpr double kPassSeconds = 0.1;
constexpr int kMaxStride = 64;

}  // namespace

struct Session::Impl {
    Impl(int threads, std::function<void()> onFrameCallback) : onFrame(std::move(onFrameCallback)), pool(threads), scheduler(pool), painter(pool) {
        coordinator = std::jthread([this] { run(); });
    }
    ~Impl() {
        quit.store(true, std::memory_order_relaxed);
        wakeUp();
        coordinator.join();
    }

    // ---- Any thread ----

    void send(Message message) {
        inbox.push(std::move(message));
        wakeUp();
    }
    /// Release: whoever sees the new epoch also sees what was sent or set before. Partner: run().
    void wakeUp() {
        epoch.fetch_add(1, std::memory_order_release);
        epoch.notify_one();
    }

    // ---- Coordinator ----

    void run() {
        pthread_setname_np(pthread_self(), "glint-render");
        flushDenormals();
        while (true) {
            // Read before the inbox is emptied: a spare turn is possible, a missed message is not.
            const std::uint64_t seen = epoch.load(std::memory_order_acquire);
            if (quit.load(std::memory_order_relaxed)) return;
            readMessages();
            if (!step(seen)) epoch.wait(seen, std::memory_order_acquire);
        }
    }

    void readMessages() {
        for (Message& message : inbox.takeAll()) {
            if (auto* newScene = std::get_if<SceneMessage>(&message)) {
                document = std::move(*newScene);
                stale = true;
            } else {
                const ViewSettings& next = std::get<ViewSettings>(message);
                readView(next);
            }
        }
    }

    void readView(const ViewSettings& next) {
        const PixelRect before = workRect();
        stale = stale || next.width != view.width || next.height != view.height;
        undisplayed = undisplayed || !(next == view);
        view = next;
        pool.limit(view.threads > 0 ? view.threads : pool.threads());
        if (stale || workRect() == before) return;
        // What lies outside the old region may show an older scene.
        stale = restIsOld;
        recount();
    }

    /// The pixels that get samples.
    [[nodiscard]] PixelRect workRect() const {
        if (!view.region) return {0, 0, view.width, view.height};
        const PixelRect& r = *view.region;
        const int x0 = std::clamp(r.x, 0, view.width), y0 = std::clamp(r.y, 0, view.height);
        return {x0, y0, std::clamp(r.x + r.width, x0, view.width) - x0, std::clamp(r.y + r.height, y0, view.height) - y0};
    }

    /// How far the pixels to work on are, when it is others than before.
    void recount() {
        const PixelRect rect = workRect();
        if (film.width() != view.width || film.height() != view.height) return;
        std::uint32_t least = ~0u;
        for (int y = rect.y; y < rect.y + rect.height; ++y)
            for (int x = rect.x; x < rect.x + rect.width; ++x) least = std::min(least, film.at(x, y).samples);
        if (rect.width <= 0 || rect.height <= 0) least = 0;
        spp = static_cast<int>(least);
        if (spp > 0) stride = shownStride = 1;
        error = pictureError(film, rect);
    }

    /// One turn of work; false: nothing to do until a message comes.
    bool step(std::uint64_t seen) {
        if (document.revision == 0 || view.width <= 0 || view.height <= 0) return false;
        // A paused picture stays as it is, edits and sizes notwithstanding.
        if (stale && !(view.paused && scene)) restart();
        if (!scene) return false;
        if (isConverged() || view.paused) {
            if (undisplayed) show(view.paused && !isConverged() ? SessionState::Paused : SessionState::Converged, {&epoch, seen});
            return false;
        }
        renderPass(seen);
        return true;
    }

    void restart() {
        stale = false;
        document.scene.film.width = view.width;
        document.scene.film.height = view.height;
        auto compiled = compile(document.scene, document.assetFolder, assets, scene);
        warnings.clear();
        if (!compiled.ok()) {
            warnings.push_back(compiled.error());
            undisplayed = true;
            return;
        }
        Compiled result = std::move(compiled).value();
        for (const CompileWarning& warning : result.warnings) warnings.push_back(warning.error);
        scene = std::move(result.scene);
        const bool sameSize = film.width() == view.width && film.height() == view.height;
        restIsOld = sameSize && view.region;
        if (sameSize)
            film.clear(workRect());
        else
            film = Film(view.width, view.height);
        counts = {};
        seconds = 0;
        spp = 0;
        error = kInfinity;
        firstPass = true;
        stride = firstStride();
    }

    /// The finest grid of pixels that the first pass can trace in its time, from the rate measured so far.
    [[nodiscard]] int firstStride() const {
        const double affordable = kFirstPassSeconds * samplesPerSecond;
        const PixelRect rect = workRect();
        int s = 1;
        while (s < kMaxStride && static_cast<double>(rect.width) * rect.height / (s * s) > affordable) s *= 2;
        return s;
    }

    [[nodiscard]] bool isConverged() const {
        const double limit = document.scene.render.timeSeconds;
        return spp >= document.scene.render.spp || (spp > 0 && limit > 0 && seconds >= limit) ||
               meetsErrorRule(error, spp, document.scene.render.errorPercent);
    }

    void renderPass(std::uint64_t seen) {
        const CancelToken cancel = firstPass ? CancelToken{} : CancelToken{&epoch, seen};
        const int target = spp == 0 ? 1 : std::min(document.scene.render.spp, spp + samplesInPass());
        const std::uint64_t before = counts.rays.primary, raysBefore = counts.rays.total();
        const auto start = Clock::now();
        const bool complete = scheduler.renderPass(*scene, film, nullptr, workRect(), stride,
                                                   static_cast<std::uint32_t>(target), cancel, counts);
        const double took = std::chrono::duration<double>(Clock::now() - start).count();
        seconds += took;
        measure(static_cast<double>(counts.rays.primary - before), static_cast<double>(counts.rays.total() - raysBefore), took);
        firstPass = false;
        if (complete) {
            if (stride > 1)
                stride /= 2, shownStride = stride * 2;
            else
                spp = target, shownStride = 1, error = pictureError(film, workRect());
        }
        // A cancelled pass is only shown for the sake of new view settings: its film may be about to go.
        if (complete || undisplayed) show(isConverged() ? SessionState::Converged : SessionState::Rendering, cancel);
    }

    /// Passes double until they take kPassSeconds.
    [[nodiscard]] int samplesInPass() const {
        const double affordable = kPassSeconds * samplesPerSecond / std::max(1.0, static_cast<double>(workRect().width) * workRect().height);
        return std::clamp(static_cast<int>(affordable), 1, std::max(1, spp));
    }

    void measure(double samples, double rays, double took) {
        if (samples < 64 || took <= 0) return;
        samplesPerSecond = samples / took;
        raysPerSecond = rays / took;
    }

    /// Until the first of the stop rules is met: samples and time at the present rate, the error as it falls with the root of
    /// the samples.
    [[nodiscard]] double remainingSeconds() const {
        const RenderSettings& rules = document.scene.render;
        if (isConverged()) return 0;
        if (spp == 0 || seconds <= 0) return kInfinity;
        double left = seconds * (static_cast<double>(rules.spp) / spp - 1);
        if (rules.timeSeconds > 0) left = std::min(left, rules.timeSeconds - seconds);
        if (rules.errorPercent > 0 && error < kInfinity) left = std::min(left, seconds * (std::pow(100 * error / rules.errorPercent, 2) - 1));
        return std::max(left, 0.0);
    }

    /// Paints the film on the workers and hands the frame out, unless news come meanwhile.
    void show(SessionState state, const CancelToken& cancel) {
        SessionFrame& frame = frames.back();
        if (!painter.paint(scene, film, std::max(shownStride, 1), view.paint, cancel, frame)) return;
        undisplayed = false;
        frame.revision = document.revision;
        frame.width = film.width();
        frame.height = film.height();
        frame.region = view.region ? std::optional(workRect()) : std::nullopt;
        frame.state = state;
        frame.spp = spp;
        frame.sppTarget = document.scene.render.spp;
        frame.seconds = seconds;
        frame.remainingSeconds = remainingSeconds();
        frame.error = error;
        frame.raysPerSecond = raysPerSecond;
        frame.nonfiniteSamples = counts.nonfinite;
        frame.kernel = kernelName(*scene);
        frame.features = featureNames(*scene);
        frame.skips = skipNames(*scene);
        frame.warnings = warnings;
        frame.scene = scene;
        frames.publish();
        if (onFrame) onFrame();
    }

    std::function<void()> onFrame;
    WorkerPool pool;
    Scheduler scheduler;
    FramePainter painter;
    Inbox<Message> inbox;
    TripleBuffer<SessionFrame> frames;
    std::atomic<std::uint64_t> epoch{1};  ///< moves with every message; partners: run() and the workers' CancelToken
    std::atomic<std::uint64_t> revision{0};
    std::atomic<bool> quit{false};        ///< set before the last move of the epoch, read after it

    // The coordinator's own.
    SceneMessage document;
    ViewSettings view;
    AssetCache assets;
    std::shared_ptr<const RenderScene> scene;
    Film film;
    RenderCounts counts;
    std::vector<Error> warnings;
    bool stale = false;        ///< document or size changed since the last compile
    bool undisplayed = false;  ///< the view changed since the last frame
    bool restIsOld = false;    ///< the pixels outside the region are of an older scene
    bool firstPass = true;
    int stride = 1;            ///< grid of the pass to come; above 1 while the first sample refines
    int shownStride = 1;       ///< grid on which every pixel has a sample
    int spp = 0;
    double seconds = 0, raysPerSecond = 0, error = kInfinity;
    double samplesPerSecond = 1e5;  ///< measured; the start is cautious
    std::jthread coordinator;       ///< last: it uses all of the above
};

Session::Session(int threads, std::function<void()> onFrame) : impl_(std::make_unique<Impl>(threads, std::move(onFrame))) {}
Session::~Session() = default;

std::uint64_t Session::publish(Scene scene, std::filesystem::path assetFolder) {
    const std::uint64_t revision = impl_->revision.fetch_add(1, std::memory_order_relaxed) + 1;
    impl_->send(SceneMessage{std::move(scene), std::move(assetFolder), revision});
    return revision;
}

void Session::publish(const ViewSettings& view) { impl_->send(view); }

const SessionFrame* Session::take() { return impl_->frames.take(); }

}  // namespace glint
