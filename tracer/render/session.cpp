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
    Impl(int threads, std::function<void()> onFrameCallback) : onFrame(std::move(onFrameCallback)), pool(threads), scheduler(pool) {
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
                stale = stale || next.width != view.width || next.height != view.height;
                undisplayed = undisplayed || !(next == view);
                view = next;
            }
        }
    }

    /// One turn of work; false: nothing to do until a message comes.
    bool step(std::uint64_t seen) {
        if (document.revision == 0 || view.width <= 0 || view.height <= 0) return false;
        if (stale) restart();
        if (!scene) return false;
        if (isConverged() || view.paused) {
            if (undisplayed) show(view.paused && !isConverged() ? SessionState::Paused : SessionState::Converged);
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
        if (film.width() == view.width && film.height() == view.height)
            film.clear();
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
        int s = 1;
        while (s < kMaxStride && static_cast<double>(view.width) * view.height / (s * s) > affordable) s *= 2;
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
        const bool complete = scheduler.renderPass(*scene, film, nullptr, {0, 0, view.width, view.height}, stride,
                                                   static_cast<std::uint32_t>(target), cancel, counts);
        const double took = std::chrono::duration<double>(Clock::now() - start).count();
        seconds += took;
        measure(static_cast<double>(counts.rays.primary - before), static_cast<double>(counts.rays.total() - raysBefore), took);
        firstPass = false;
        if (complete) {
            if (stride > 1)
                stride /= 2, shownStride = stride * 2;
            else
                spp = target, shownStride = 1, error = pictureError(film, {0, 0, view.width, view.height});
        }
        // A cancelled pass is only shown for the sake of new view settings: its film may be about to go.
        if (complete || undisplayed) show(isConverged() ? SessionState::Converged : SessionState::Rendering);
    }

    /// Passes double until they take kPassSeconds.
    [[nodiscard]] int samplesInPass() const {
        const double affordable = kPassSeconds * samplesPerSecond / (static_cast<double>(view.width) * view.height);
        return std::clamp(static_cast<int>(affordable), 1, std::max(1, spp));
    }

    void measure(double samples, double rays, double took) {
        if (samples < 64 || took <= 0) return;
        samplesPerSecond = samples / took;
        raysPerSecond = rays / took;
    }

    /// Converts the film on the workers and hands the frame out.
    void show(SessionState state) {
        undisplayed = false;
        SessionFrame& frame = frames.back();
        frame.revision = document.revision;
        frame.width = view.width;
        frame.height = view.height;
        frame.pixels.resize(static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height));
        const DisplayTransform transform(view.display);
        const int mask = ~(std::max(shownStride, 1) - 1);
        constexpr int kRows = 16;
        pool.run((view.height + kRows - 1) / kRows, [&](int, int band) {
            for (int y = band * kRows; y < std::min(view.height, (band + 1) * kRows); ++y)
                for (int x = 0; x < view.width; ++x) {
                    const FilmPixel* pixel = &film.at(x, y);
                    if (pixel->samples == 0) pixel = &film.at(x & mask, y & mask);
                    frame.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(view.width) + static_cast<std::size_t>(x)] =
                        transform.apply(pixel->mean());
                }
        });
        frame.state = state;
        frame.spp = spp;
        frame.sppTarget = document.scene.render.spp;
        frame.seconds = seconds;
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
