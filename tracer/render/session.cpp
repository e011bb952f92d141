#include "tracer/render/session.h"

#include <pthread.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "tracer/base/channel.h"
#include "tracer/compile/compiler.h"
#include "tracer/render/adaptive.h"
#include "tracer/render/picture.h"
#include "tracer/render/skips.h"

namespace glint {

namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

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

/// The first pass after an edit is sized to take this long.
constexpr double kFirstPassSeconds = 0.004;
/// It is not cancelled if no new picture was shown for so long, so that a drag always shows motion.
constexpr double kMotionSeconds = 0.03;
/// A pass at full resolution takes about this long at most, so that the picture is seen to sharpen.
constexpr double kPassSeconds = 0.1;
constexpr int kMaxStride = 64;
/// For pictures of scenes that undo may come back to, and for sums by light group (without which light edits restart).
constexpr std::size_t kCacheBytes = std::size_t{512} << 20, kGroupBytes = std::size_t{256} << 20;

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

    std::uint64_t send(std::optional<SceneMessage> sceneMessage, std::optional<ViewSettings> newView, bool filesChange = false) {
        const std::uint64_t number = sceneMessage ? revision.fetch_add(1, std::memory_order_relaxed) + 1 : 0;
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
            if (message.view) readView(*message.view);
            if (message.filesChanged) {
                filesChanged = stale = true;
                cache = PictureCache(kCacheBytes);
            }
            if (!message.scene) continue;
            document = std::move(*message.scene);
            latency = {.stopped = secondsSince(document.sent)};
            stale = true;
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
    [[nodiscard]] static double areaOf(const PixelRect& rect) { return static_cast<double>(rect.width) * rect.height; }

    /// How far the pixels to work on are, when it is others than before.
    void recount() {
        if (picture.film.width() != view.width || picture.film.height() != view.height) return;
        picture.goals.clear();
        judge();
        if (picture.spp > 0) picture.stride = picture.shownStride = 1;
    }

    /// One turn of work; false: nothing to do until a message comes.
    bool step(std::uint64_t seen) {
        if (document.revision == 0 || view.width <= 0 || view.height <= 0) return false;
        // A paused picture stays as it is, edits and sizes notwithstanding.
        if (stale && !(view.paused && picture.scene)) takeUpEdit();
        if (!picture.scene) return false;
        if (isConverged() || view.paused) {
            if (undisplayed) show(view.paused && !isConverged() ? SessionState::Paused : SessionState::Converged, {&epoch, seen});
            return false;
        }
        renderPass(seen);
        return true;
    }

    // ---- Edits ----

    /// Makes `picture` one of the document at the view's size, with as many of its samples as hold.
    void takeUpEdit() {
        stale = false;
        undisplayed = true;
        Scene next = document.scene;
        next.film.width = view.width;
        next.film.height = view.height;
        if (std::exchange(filesChanged, false)) return restart(std::move(next));
        EditPlan plan = planFor(picture, next, document.assetFolder);
        // With a region only its pixels follow an edit, and those outside may be of an older scene: all or nothing in it.
        const bool whole = !view.region && !restIsOld;
        if (!whole && (plan.kind == EditPlan::Kind::Retrace || !(plan.mix == picture.film.mix()))) plan = {};
        if (restIsOld && !(workRect() == newRect)) plan = {};
        if (plan.kind == EditPlan::Kind::Keep) return keep(plan.mix);
        if (!whole) return restart(std::move(next));
        cache.store(picture);
        if (auto kept = cache.take(next, document.assetFolder)) {
            picture = std::move(*kept);
            backdrop.reset();
            return keep(picture.film.mix());
        }
        if (plan.kind == EditPlan::Kind::Retrace && retrace(next, plan)) return;
        restart(std::move(next));
    }

    void keep(const LightMix& mix) {
        if (!(mix == picture.film.mix())) {
            picture.film.setMix(mix);
            if (backdrop) backdrop->film.setMix(mix);
        }
        retracedShare = 0;
        judge();
        protectedPass = false;
    }

    /// Throws away the samples that rest on changed materials; false if the edit changed more than values.
    bool retrace(const Scene& next, const EditPlan& plan) {
        const int before = picture.spp;
        const bool goesOn = backdrop && backdrop->retraced;
        if (before == 0 && !goesOn) return false;  // There is no picture yet to keep anything of.
        Scene traced = withLightsOf(picture.traced, next);
        auto compiled = compile(traced, document.assetFolder, assets, picture.scene);
        if (!compiled.ok() || !sameStructure(*picture.scene, *compiled.value().scene)) return false;
        picture.traced = std::move(traced);
        adopt(std::move(compiled).value());
        // What the last edit threw away and no pass has brought back yet is still to be shown from then.
        if (before == 0) backdrop->retraced |= plan.materials;
        else backdrop = Backdrop{picture.film, plan.materials};
        picture.film.setMix(plan.mix);
        backdrop->film.setMix(plan.mix);
        if (samplesAdaptively(document.scene.render) && before > 0) picture.goals = goalsOf(picture.film);
        std::vector<std::size_t> rows(static_cast<std::size_t>(picture.film.rows()));
        // On this thread and the workers; copies of tiles are made here, those of samples never.
        pool.run(picture.film.rows(), [&](int, int row) { rows[static_cast<std::size_t>(row)] = picture.film.forget(plan.materials, row); });
        std::size_t forgotten = 0;
        for (const std::size_t count : rows) forgotten += count;
        retracedShare = static_cast<double>(forgotten) / areaOf({0, 0, view.width, view.height});
        if (forgotten == 0) return true;
        picture.spp = 0;
        picture.seconds = 0;
        picture.trend = {};
        pendingPixels = static_cast<double>(forgotten) + (before == 0 ? pendingPixels : 0.0);
        pendingSpp = std::max(pendingSpp, before);
        picture.stride = firstStride();
        picture.shownStride = std::max(picture.shownStride, 1);
        protectedPass = true;
        return true;
    }

    /// The samples that the tiles have now.
    static std::vector<std::uint32_t> goalsOf(const Film& film) {
        std::vector<std::uint32_t> goals;
        for (int y = 0; y < film.height(); y += kErrorTile)
            for (int x = 0; x < film.width(); x += kErrorTile) goals.push_back(film.samples(x, y));
        return goals;
    }

    void restart(Scene next) {
        auto compiled = compile(next, document.assetFolder, assets, picture.scene);
        if (!compiled.ok()) {
            picture.warnings = {compiled.error()};
            return;
        }
        const bool sameSize = picture.film.width() == view.width && picture.film.height() == view.height;
        const bool resized = picture.scene && !sameSize && picture.shownStride == 1 && onlySizeDiffers(next);
        if (resized) backdrop = Backdrop{picture.film, 0, pixelStep(next, picture.traced)};
        else if (sameSize || !backdrop || backdrop->retraced) backdrop.reset();
        adopt(std::move(compiled).value());
        const std::size_t groups = areaOf({0, 0, view.width, view.height}) * 24.0 * static_cast<double>(picture.scene->lightGroups) <= static_cast<double>(kGroupBytes) ? picture.scene->lightGroups : 1;
        restIsOld = sameSize && view.region;
        newRect = workRect();
        if (sameSize && (restIsOld || picture.film.groups() == groups)) picture.film.clear(workRect());
        else picture.film = Film(view.width, view.height, groups);
        picture.film.setMix({});
        picture.traced = std::move(next);
        picture.assetFolder = document.assetFolder;
        picture.groups = LightGroups(picture.traced);
        picture.counts.nonfinite = 0;
        picture.counts.firstNonfinite.reset();
        picture.seconds = 0;
        picture.spp = 0;
        picture.errors = {};
        picture.trend = {};
        picture.goals.clear();
        pendingPixels = areaOf(workRect());
        pendingSpp = 0;
        picture.stride = firstStride();
        picture.shownStride = backdrop ? 1 : 0;
        protectedPass = true;
        retracedShare = 1;
        ++restarts;
    }

    void adopt(Compiled compiled) {
        picture.warnings.clear();
        for (const CompileWarning& warning : compiled.warnings) picture.warnings.push_back(warning.error);
        picture.scene = std::move(compiled.scene);
    }

    /// The scene would keep its samples if the window had its old size.
    [[nodiscard]] bool onlySizeDiffers(const Scene& next) const {
        if (!sameViewpoint(picture.traced.viewCamera(), next.viewCamera())) return false;
        Scene sized = next;
        sized.film = picture.traced.film;
        sized.camera = picture.traced.viewCamera();
        sized.activeCamera = {};
        return planFor(picture, sized, document.assetFolder).kind == EditPlan::Kind::Keep;
    }

    /// Pixels of `old` for one of `next` in the middle of the picture.
    static double pixelStep(const Scene& next, const Scene& old) {
        const auto size = [](const Scene& scene) {
            const Camera& camera = scene.viewCamera();
            const double height = camera.projection == Projection::Perspective ? std::tan(degreesToRadians(camera.verticalFovDegrees) / 2) : camera.orthoHeight;
            return height / scene.film.height;
        };
        return size(next) / size(old);
    }

    // ---- Passes ----

    /// The finest grid of pixels that the first pass can trace in its time, from the rate measured so far.
    [[nodiscard]] int firstStride() const {
        const double affordable = kFirstPassSeconds * samplesPerSecond;
        int s = 1;
        while (s < kMaxStride && pendingPixels / (s * s) > affordable) s *= 2;
        return s;
    }

    [[nodiscard]] RenderProgressState progress() const {
        return {picture.seconds, picture.errors.meanSamples, picture.spp, picture.errors.picture};
    }
    [[nodiscard]] bool isConverged() const { return picture.spp > 0 && isDone(document.scene.render, progress()); }

    /// Errors and counts of the film as it is.
    void judge() {
        findErrors(picture.film, workRect(), pool, picture.errors);
        picture.spp = picture.errors.leastSamples;
    }

    [[nodiscard]] SampleGoal nextGoal() {
        const RenderSettings& rules = document.scene.render;
        if (picture.spp == 0) return {};
        const auto most = static_cast<std::uint32_t>(samplesInPass());
        if (samplesAdaptively(rules)) {
            if (picture.goals.empty()) picture.goals = AdaptivePlan::next(picture.film, workRect(), static_cast<std::uint32_t>(rules.spp));
            return {.tiles = &picture.goals, .most = most};
        }
        return {.samples = std::min(static_cast<std::uint32_t>(rules.spp), static_cast<std::uint32_t>(picture.spp) + most)};
    }

    void renderPass(std::uint64_t seen) {
        const bool protects = protectedPass && secondsSince(lastShown) > kMotionSeconds;
        const CancelToken cancel{&epoch, seen};
        // What needs no new samples is shown before any are made.
        if (undisplayed && !protectedPass && picture.shownStride > 0) show(SessionState::Rendering, cancel);
        const SampleGoal goal = nextGoal();
        const RayCounts before = picture.counts.rays;
        const auto start = Clock::now();
        const PassResult result = scheduler.renderPass(*picture.scene, picture.film, nullptr, workRect(), picture.stride, goal,
                                                       protects ? CancelToken{} : cancel, picture.counts);
        const double took = secondsSince(start);
        picture.seconds += took;
        rays += picture.counts.rays.total() - before.total();
        measure(static_cast<double>(picture.counts.rays.primary - before.primary), static_cast<double>(picture.counts.rays.total() - before.total()), took);
        if (result == PassResult::Done) passDone();
        // After a cancelled one the film may be about to go.
        if (result != PassResult::Cancelled) show(isConverged() ? SessionState::Converged : SessionState::Rendering, protects ? CancelToken{} : cancel);
        if (result == PassResult::Done) protectedPass = false;
    }

    void passDone() {
        if (picture.stride > 1) {
            picture.shownStride = picture.stride;
            picture.stride /= 2;
            return;
        }
        picture.shownStride = 1;
        picture.goals.clear();
        judge();
        picture.trend.add(picture.seconds, picture.errors.picture);
        if (picture.spp >= pendingSpp) pendingPixels = areaOf(workRect());
        // A backdrop has served when no pixel rests on it any more.
        if (backdrop && (backdrop->retraced || picture.spp >= static_cast<int>(backdrop->film.samples(backdrop->film.width() / 2, backdrop->film.height() / 2)) || isConverged()))
            backdrop.reset();
    }

    /// Passes double until they take kPassSeconds.
    [[nodiscard]] int samplesInPass() const {
        const double affordable = kPassSeconds * samplesPerSecond / std::max(1.0, pendingPixels);
        return std::clamp(static_cast<int>(std::min(affordable, 1e6)), 1, std::max(1, picture.spp));
    }

    void measure(double samples, double raysTraced, double took) {
        if (samples < 64 || took <= 0) return;
        samplesPerSecond = samples / took;
        raysPerSecond = raysTraced / took;
    }

    // ---- Frames ----

    /// Paints the film on the workers and hands the frame out, unless news come meanwhile.
    void show(SessionState state, const CancelToken& cancel) {
        SessionFrame& frame = frames.back();
        if (!painter.paint(picture.scene, picture.film, backdrop ? &*backdrop : nullptr, std::max(picture.shownStride, 1), picture.errors.tiles, view.paint, cancel, frame))
            return;
        undisplayed = false;
        lastShown = Clock::now();
        noteLatency();
        frame.revision = document.revision;
        frame.width = picture.film.width();
        frame.height = picture.film.height();
        frame.region = view.region ? std::optional(workRect()) : std::nullopt;
        frame.state = state;
        frame.spp = picture.spp;
        frame.sppTarget = document.scene.render.spp;
        frame.samples = picture.errors.meanSamples;
        frame.seconds = picture.seconds;
        frame.remainingSeconds = state == SessionState::Converged ? 0 : picture.spp == 0 ? kInfinity : remainingSeconds(document.scene.render, progress(), picture.trend);
        frame.error = picture.errors.picture;
        frame.raysPerSecond = raysPerSecond;
        frame.rays = rays;
        frame.restarts = restarts;
        frame.retracedShare = retracedShare;
        frame.latency = latency;
        frame.nonfiniteSamples = picture.counts.nonfinite;
        frame.kernel = kernelName(*picture.scene);
        frame.features = featureNames(*picture.scene);
        frame.skips = skipNames(*picture.scene);
        frame.warnings = picture.warnings;
        frame.scene = picture.scene;
        frames.publish();
        if (onFrame) onFrame();
    }

    void noteLatency() {
        const double now = secondsSince(document.sent);
        if (latency.firstPicture < 0) latency.firstPicture = now;
        if (latency.fullResolution < 0 && picture.spp > 0) latency.fullResolution = now;
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
    Picture picture;
    PictureCache cache{kCacheBytes};
    std::optional<Backdrop> backdrop;
    bool stale = false;          ///< document or size are not yet those of `picture`
    bool filesChanged = false;   ///< since `picture` was compiled
    bool undisplayed = false;    ///< view or picture changed since the last frame
    bool restIsOld = false;      ///< the pixels outside `newRect` are of an older scene
    PixelRect newRect;           ///< what the last restart cleared
    bool protectedPass = false;  ///< no pass of the edited scene is done yet
    double pendingPixels = 0;    ///< that passes bring samples to ...
    int pendingSpp = 0;          ///< ... until every pixel has so many
    EditLatency latency;
    double retracedShare = 0;
    std::uint64_t rays = 0, restarts = 0;
    double raysPerSecond = 0;
    double samplesPerSecond = 1e5;  ///< measured; the start is cautious
    Clock::time_point lastShown;
    std::jthread coordinator;       ///< last: it uses all of the above
};

Session::Session(int threads, std::function<void()> onFrame) : impl_(std::make_unique<Impl>(threads, std::move(onFrame))) {}
Session::~Session() = default;

std::uint64_t Session::publish(Scene scene, std::filesystem::path assetFolder) {
    return impl_->send(SceneMessage{std::move(scene), std::move(assetFolder), 0, Clock::now()}, std::nullopt);
}

void Session::publish(const ViewSettings& view) { impl_->send(std::nullopt, view); }

std::uint64_t Session::publish(Scene scene, std::filesystem::path assetFolder, const ViewSettings& view) {
    return impl_->send(SceneMessage{std::move(scene), std::move(assetFolder), 0, Clock::now()}, view);
}

void Session::readFilesAgain() { impl_->send(std::nullopt, std::nullopt, true); }

const SessionFrame* Session::take() { return impl_->frames.take(); }

}  // namespace glint
