#include "tracer/render/session.h"

#include <pthread.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "tracer/base/channel.h"
#include "tracer/render/living_picture.h"
#include "tracer/render/skips.h"

namespace glint {

namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

struct SceneMessage {
    Scene scene;
    std::filesystem::path assetFolder;
    std::uint64_t revision = 0;
    Clock::time_point sent;
};
struct Message {
    std::optional<SceneMessage> scene;
    std::optional<ViewSettings> view;
    bool filesChanged = false;
};

/// The first pass after an edit is sized to take so long ...
constexpr double kFirstPassSeconds = 0.004;
/// ... but only so long if no new picture was shown for kMotionSeconds: it is then not cancelled,
/// so that a drag always shows motion.
constexpr double kProtectedSeconds = 0.001, kMotionSeconds = 0.03;
/// A pass at full resolution takes about this long at most, so that the picture is seen to sharpen.
constexpr double kPassSeconds = 0.1;

}  // namespace

struct Session::Impl {
    Impl(int threads, std::function<void()> onFrameCallback)
        : onFrame(std::move(onFrameCallback)), pool(threads), painter(pool), picture(pool) {
        coordinator = std::jthread([this] { run(); });
    }
    ~Impl() {
        quit.store(true, std::memory_order_relaxed);
        wakeUp();
        coordinator.join();
    }

    // ---- Any thread ----

    std::uint64_t send(std::optional<SceneMessage> sceneMessage,
                       std::optional<ViewSettings> newView, bool filesChange = false) {
        const std::uint64_t number =
            sceneMessage ? revision.fetch_add(1, std::memory_order_relaxed) + 1 : 0;
        if (sceneMessage) sceneMessage->revision = number;
        inbox.push({std::move(sceneMessage), std::move(newView), filesChange});
        wakeUp();
        return number;
    }
    /// Release: whoever sees the new epoch also sees what was sent or set before. Partner: run().
    void wakeUp() {
        epoch.fetch_add(1, std::memory_order_release);
        epoch.notify_one();
    }

    // ---- Coordinator ----

    void run() {
        pthread_setname_np(pthread_self(), "glint-render");
        giveWay();
        flushDenormals();
        while (true) {
            // Read before the inbox is emptied: a spare turn is possible, a missed message is not.
            const std::uint64_t seen = epoch.load(std::memory_order_acquire);
            if (quit.load(std::memory_order_relaxed)) return;
            readMessages();
            if (!step({&epoch, seen})) epoch.wait(seen, std::memory_order_acquire);
        }
    }

    void readMessages() {
        for (Message& message : inbox.takeAll()) {
            if (message.view) readView(*message.view);
            if (message.filesChanged) {
                picture.forgetSamples();
                stale = true;
            }
            if (!message.scene) continue;
            document = std::move(*message.scene);
            latency = {.stopped = secondsSince(document.sent)};
            stale = true;
        }
    }

    void readView(const ViewSettings& next) {
        stale = stale || next.width != view.width || next.height != view.height;
        undisplayed = undisplayed || !(next == view);
        view = next;
        pool.limit(view.threads > 0 ? view.threads : pool.threads());
        if (!stale && picture.exists()) stale = !picture.setRegion(regionInPicture());
    }

    [[nodiscard]] std::optional<PixelRect> regionInPicture() const {
        if (!view.region) return std::nullopt;
        const PixelRect& r = *view.region;
        const int x0 = std::clamp(r.x, 0, view.width), y0 = std::clamp(r.y, 0, view.height);
        return PixelRect{x0, y0, std::clamp(r.x + r.width, x0, view.width) - x0,
                         std::clamp(r.y + r.height, y0, view.height) - y0};
    }

    /// One turn of work, given up when `cancel` says so; false: nothing to do until a message
    /// comes.
    bool step(const CancelToken& cancel) {
        if (document.revision == 0 || view.width <= 0 || view.height <= 0) return false;
        // A paused picture stays as it is, edits and sizes notwithstanding.
        if (stale && !(view.paused && picture.exists())) {
            stale = false;
            undisplayed = true;
            picture.takeUp(
                {document.scene, document.assetFolder, view.width, view.height, regionInPicture()});
        }
        if (!picture.exists()) return false;
        // What needs no new samples is shown before any are made.
        if (undisplayed && (picture.isShowable() || view.paused)) return show(cancel), true;
        if (picture.needsJudging()) {
            undisplayed = picture.judge(cancel) || undisplayed;
            return true;
        }
        if (picture.isConverged() || view.paused) return false;
        renderPass(cancel);
        return true;
    }

    void renderPass(const CancelToken& cancel) {
        const bool mustShow = !picture.isShowable() && secondsSince(lastShown) > kMotionSeconds;
        const CancelToken token = mustShow ? CancelToken{} : cancel;
        if (picture.render({mustShow ? kProtectedSeconds : kFirstPassSeconds, kPassSeconds},
                           token) == PassResult::Cancelled)
            return;  // The film may be about to go.
        // What is said to be done comes with its own error, not that of some samples ago.
        if (picture.isConverged() && picture.needsJudging() && !picture.judge(token)) return;
        show(token);
        picture.lookAhead(cancel);
    }

    // ---- Frames ----

    /// Paints the film on the workers and hands the frame out, unless news come meanwhile.
    void show(const CancelToken& cancel) {
        SessionFrame& frame = frames.back();
        const Picture& shown = picture.picture();
        if (!painter.paint(shown.scene, shown.film, picture.backdrop(),
                           std::max(shown.shownStride, 1), shown.errors.tiles, view.paint, cancel,
                           frame))
            return;
        undisplayed = frame.isRough;
        lastShown = Clock::now();
        noteLatency();
        describe(frame);
        frames.publish();
        if (onFrame) onFrame();
    }

    void describe(SessionFrame& frame) const {
        const Picture& shown = picture.picture();
        frame.revision = document.revision;
        frame.width = shown.film.width();
        frame.height = shown.film.height();
        frame.region = regionInPicture();
        frame.state = picture.isConverged() ? SessionState::Converged
                      : view.paused         ? SessionState::Paused
                                            : SessionState::Rendering;
        frame.spp = shown.spp;
        frame.sppTarget = document.scene.render.spp;
        frame.samples = picture.meanSamples();
        frame.seconds = shown.seconds;
        frame.remainingSeconds = picture.isConverged() ? 0 : picture.remainingSeconds();
        frame.error = shown.errors.picture;
        frame.raysPerSecond = picture.raysPerSecond();
        frame.rays = picture.rays();
        frame.restarts = picture.restarts();
        frame.retracedShare = picture.retracedShare();
        frame.latency = latency;
        frame.nonfiniteSamples = shown.counts.nonfinite;
        frame.kernel = kernelName(*shown.scene);
        frame.features = featureNames(*shown.scene);
        frame.skips = skipNames(*shown.scene);
        frame.warnings = shown.warnings;
        frame.scene = shown.scene;
    }

    void noteLatency() {
        const double now = secondsSince(document.sent);
        if (latency.firstPicture < 0) latency.firstPicture = now;
        if (latency.fullResolution < 0 && picture.picture().spp > 0) latency.fullResolution = now;
    }

    std::function<void()> onFrame;
    WorkerPool pool;
    FramePainter painter;
    Inbox<Message> inbox;
    TripleBuffer<SessionFrame> frames;
    std::atomic<std::uint64_t> epoch{
        1};  ///< moves with every message; partners: run() and the workers' CancelToken
    std::atomic<std::uint64_t> revision{0};
    std::atomic<bool> quit{false};  ///< set before the last move of the epoch, read after it

    // The coordinator's own.
    SceneMessage document;
    ViewSettings view;
    LivingPicture picture;
    bool stale = false;        ///< document or size are not yet those of `picture`
    bool undisplayed = false;  ///< view or picture changed since the last frame
    EditLatency latency;
    Clock::time_point lastShown;
    std::jthread coordinator;  ///< last: it uses all of the above
};

Session::Session(int threads, std::function<void()> onFrame)
    : impl_(std::make_unique<Impl>(threads, std::move(onFrame))) {}
Session::~Session() = default;

std::uint64_t Session::publish(Scene scene, std::filesystem::path assetFolder) {
    return impl_->send(SceneMessage{std::move(scene), std::move(assetFolder), 0, Clock::now()},
                       std::nullopt);
}

void Session::publish(const ViewSettings& view) { impl_->send(std::nullopt, view); }

std::uint64_t Session::publish(Scene scene, std::filesystem::path assetFolder,
                               const ViewSettings& view) {
    return impl_->send(SceneMessage{std::move(scene), std::move(assetFolder), 0, Clock::now()},
                       view);
}

void Session::readFilesAgain() { impl_->send(std::nullopt, std::nullopt, true); }

const SessionFrame* Session::take() { return impl_->frames.take(); }

}  // namespace glint
