#include "tracer/render/living_picture.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "tracer/compile/view.h"
#include "tracer/render/adaptive.h"

namespace glint {

namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

double areaOf(const PixelRect& rect) { return static_cast<double>(rect.width) * rect.height; }

/// Pixels of a picture of `old` for one of `next` in the middle of the picture.
double pixelStep(const Scene& next, const Scene& old) {
    const auto size = [](const Scene& scene) {
        const Camera& camera = scene.viewCamera();
        const double height = camera.projection == Projection::Perspective
                                  ? std::tan(degreesToRadians(camera.verticalFovDegrees) / 2)
                                  : camera.orthoHeight;
        return height / scene.film.height;
    };
    return size(next) / size(old);
}

}  // namespace

// ---- Edits ----

void LivingPicture::takeUp(Wish wish) {
    wish_ = std::move(wish);
    Scene next = wish_.scene;
    next.film.width = wish_.width;
    next.film.height = wish_.height;
    if (!std::exchange(samplesHold_, true)) return restart(std::move(next), true);
    EditPlan plan = planFor(picture_, next, wish_.assetFolder);
    // With a region only its pixels follow an edit, and those outside may be of an older scene: all
    // or nothing in it.
    const bool whole = !wish_.region && !restIsOld_;
    if (!whole && (plan.kind == EditPlan::Kind::Retrace || !(plan.mix == picture_.film.mix())))
        plan = {};
    if (restIsOld_ && !(workRect() == newRect_)) plan = {};
    if (plan.kind == EditPlan::Kind::Keep) return keep(plan.mix);
    if (!whole) return restart(std::move(next));
    cache_.store(picture_);
    if (auto kept = cache_.take(next, wish_.assetFolder)) {
        picture_ = std::move(*kept);
        backdrop_.reset();
        firstPassPending_ = false;
        pendingPixels_ = areaOf(workRect());
        pendingSpp_ = 0;
        return keep(picture_.film.mix());
    }
    if (plan.kind == EditPlan::Kind::Retrace && retrace(next, plan)) return;
    restart(std::move(next));
}

void LivingPicture::forgetSamples() {
    samplesHold_ = false;
    cache_ = PictureCache(kCacheBytes);
}

void LivingPicture::keep(const LightMix& mix) {
    if (!(mix == picture_.film.mix())) {
        picture_.film.setMix(mix);
        // A film too large for sums by group has one alone, and cannot follow.
        if (backdrop_ && backdrop_->film.groups() != picture_.film.groups()) backdrop_.reset();
        if (backdrop_) backdrop_->film.setMix(mix);
    }
    retracedShare_ = 0;
}

bool LivingPicture::setRegion(const std::optional<PixelRect>& region) {
    const PixelRect before = workRect();
    wish_.region = region;
    if (workRect() == before) return true;
    if (restIsOld_) return false;
    picture_.goals = {};
    judge({});
    if (picture_.spp > 0) picture_.stride = picture_.shownStride = 1;
    return true;
}

/// Throws away the samples that rest on changed materials; false if the edit changed more than
/// values.
bool LivingPicture::retrace(const Scene& next, const EditPlan& plan) {
    const int before = picture_.spp;
    if (before == 0 && !picture_.film.remembers())
        return false;  // There is no picture yet to keep anything of.
    Scene traced = withLightsOf(picture_.traced, next);
    auto compiled = compile(traced, wish_.assetFolder, assets_, picture_.scene);
    if (!compiled.ok() || !sameStructure(*picture_.scene, *compiled.value().scene)) return false;
    picture_.traced = std::move(traced);
    adopt(std::move(compiled).value());
    backdrop_.reset();
    picture_.film.setMix(plan.mix);
    if (samplesAdaptively(rules()) && before > 0)
        picture_.goals = goalsReached(picture_.film, adaptiveRule(rules().integrator));
    const std::size_t forgotten = picture_.film.forget(plan.materials, pool_);
    retracedShare_ = static_cast<double>(forgotten) / areaOf(workRect());
    if (forgotten == 0) {
        if (before > 0) picture_.film.settle(true);
        return true;
    }
    forgetProgress();
    pendingPixels_ = static_cast<double>(forgotten) + (before == 0 ? pendingPixels_ : 0.0);
    pendingSpp_ = std::max(pendingSpp_, before);
    picture_.stride = 0;
    picture_.shownStride = std::max(picture_.shownStride, 1);
    return true;
}

void LivingPicture::restart(Scene next, bool assetsChanged) {
    auto compiled = assetsChanged ? compile(next, wish_.assetFolder, assets_, picture_.scene)
                                  : compileNext(next);
    if (!compiled.ok()) {
        picture_.warnings = {compiled.error()};
        return;
    }
    const bool sameSize =
        picture_.film.width() == wish_.width && picture_.film.height() == wish_.height;
    const bool resized = picture_.scene && !sameSize && onlySizeDiffers(next);
    if (resized && picture_.shownStride == 1)
        backdrop_ = Backdrop{picture_.film, pixelStep(next, picture_.traced)};
    else if (resized && backdrop_)
        backdrop_->scale *= pixelStep(next, picture_.traced);  // Resized again before it was shown.
    else
        backdrop_.reset();
    adopt(std::move(compiled).value());
    prepareFilm(sameSize);
    picture_.traced = std::move(next);
    picture_.assetFolder = wish_.assetFolder;
    picture_.groups = LightGroups(picture_.traced);
    picture_.counts.nonfinite = 0;
    picture_.counts.firstNonfinite.reset();
    picture_.errors = {};
    picture_.goals = {};
    forgetProgress();
    pendingPixels_ = areaOf(workRect());
    pendingSpp_ = 0;
    picture_.stride = 0;
    picture_.shownStride = backdrop_ ? 1 : 0;
    retracedShare_ = 1;
    ++restarts_;
}

/// Empties the pixels that are to be rendered anew.
void LivingPicture::prepareFilm(bool sameSize) {
    const double bytes = areaOf({0, 0, wish_.width, wish_.height}) * 24.0 *
                         static_cast<double>(picture_.scene->lightGroups);
    const std::size_t groups =
        bytes <= static_cast<double>(kGroupBytes) ? picture_.scene->lightGroups : 1;
    restIsOld_ = sameSize && wish_.region;
    newRect_ = workRect();
    if (sameSize && (restIsOld_ || picture_.film.groups() == groups))
        picture_.film.clear(workRect());
    else
        picture_.film = Film(wish_.width, wish_.height, groups);
    picture_.film.setMix({});
}

void LivingPicture::forgetProgress() {
    picture_.spp = 0;
    picture_.seconds = 0;
    picture_.trend = {};
    picture_.judged = {};
    firstPassPending_ = true;
}

/// The camera alone needs no compiling.
Result<Compiled> LivingPicture::compileNext(const Scene& next) {
    if (!picture_.scene || picture_.assetFolder != wish_.assetFolder ||
        !sameButView(picture_.traced, next))
        return compile(next, wish_.assetFolder, assets_, picture_.scene);
    auto seen = withView(*picture_.scene, next);
    if (!seen.ok()) return seen.error();
    return Compiled{std::move(seen).value(), picture_.compileWarnings, {}};
}

void LivingPicture::adopt(Compiled compiled) {
    picture_.warnings.clear();
    for (const CompileWarning& warning : compiled.warnings)
        picture_.warnings.push_back(warning.error);
    picture_.compileWarnings = std::move(compiled.warnings);
    picture_.scene = std::move(compiled.scene);
}

/// The scene would keep its samples if the window had its old size.
bool LivingPicture::onlySizeDiffers(const Scene& next) const {
    if (!sameViewpoint(picture_.traced.viewCamera(), next.viewCamera())) return false;
    Scene sized = next;
    sized.film = picture_.traced.film;
    sized.camera = picture_.traced.viewCamera();
    sized.activeCamera = {};
    return planFor(picture_, sized, wish_.assetFolder).kind == EditPlan::Kind::Keep;
}

// ---- Passes ----

/// The finest grid of pixels that a pass can trace in so much time, from the rate measured so far.
int LivingPicture::strideFor(double seconds) const {
    const double affordable = seconds * samplesPerSecond_;
    int s = 1;
    while (s < kMaxStride && pendingPixels_ / (s * s) > affordable) s *= 2;
    return s;
}

RenderProgressState LivingPicture::progress() const {
    const bool uneven = samplesAdaptively(rules()) && picture_.spp > 0;
    return {picture_.seconds, uneven ? picture_.errors.meanSamples : picture_.spp, picture_.spp,
            picture_.errors.picture};
}

double LivingPicture::remainingSeconds() const {
    return picture_.spp == 0 ? kInfinity
                             : glint::remainingSeconds(rules(), progress(), picture_.trend);
}

/// Passes at full resolution double until they take `seconds`. Nothing when cancelled.
std::optional<SampleGoal> LivingPicture::nextGoal(double seconds, const CancelToken& cancel) {
    if (picture_.spp == 0) return SampleGoal{};
    const double affordable = seconds * samplesPerSecond_ / std::max(1.0, pendingPixels_);
    const auto most = static_cast<std::uint32_t>(
        std::clamp(static_cast<int>(std::min(affordable, 1e6)), 1, std::max(1, picture_.spp)));
    const auto spp = static_cast<std::uint32_t>(rules().spp);
    if (!samplesAdaptively(rules()))
        return SampleGoal{.samples =
                              std::min(spp, static_cast<std::uint32_t>(picture_.spp) + most)};
    if (picture_.goals.empty() &&
        !nextGoals(picture_.film, workRect(), spp, adaptiveRule(rules().integrator), pool_, cancel,
                   picture_.goals)) {
        picture_.goals = {};
        return std::nullopt;
    }
    return SampleGoal{.cells = &picture_.goals, .most = most};
}

PassResult LivingPicture::render(const PassTimes& times, const CancelToken& cancel) {
    // A first pass that was cut short may have to be a coarser one.
    if (firstPassPending_ && picture_.spp == 0) picture_.stride = strideFor(times.first);
    const std::optional<SampleGoal> goal = nextGoal(times.full, cancel);
    if (!goal) return PassResult::Cancelled;
    if (auto renewed = renewal_.finish(*picture_.scene)) picture_.scene = std::move(renewed);
    const RayCounts before = picture_.counts.rays;
    const auto start = Clock::now();
    const PassResult result =
        scheduler_.renderPass(*picture_.scene, picture_.film, nullptr, workRect(), picture_.stride,
                              *goal, cancel, picture_.counts);
    const double took = secondsSince(start);
    picture_.seconds += took;
    measure(before, took);
    if (result == PassResult::Done) passDone(*goal);
    return result;
}

void LivingPicture::passDone(const SampleGoal& goal) {
    firstPassPending_ = false;
    if (picture_.stride > 1) {
        picture_.shownStride = picture_.stride;
        picture_.stride /= 2;
        return;
    }
    picture_.shownStride = 1;
    renewal_.begin(*picture_.scene);
    picture_.film.settle(
        !wish_.region);  // Outside a region there may be pixels without samples still.
    picture_.goals = {};
    if (goal.cells)
        judge({});
    else
        picture_.spp = static_cast<int>(goal.samples);
    if (picture_.spp >= pendingSpp_) pendingPixels_ = areaOf(workRect());
    // A backdrop has served when no pixel rests on it any more.
    if (backdrop_ && (isConverged() || picture_.spp >= static_cast<int>(backdrop_->film.samples(
                                                           backdrop_->film.width() / 2,
                                                           backdrop_->film.height() / 2))))
        backdrop_.reset();
}

void LivingPicture::lookAhead(const CancelToken& cancel) {
    if (picture_.film.bytes() > kCacheBytes / 2) return;
    constexpr int kSteps = 12;
    for (int i = 0; i < kSteps && !cancel.cancelled(); ++i) picture_.film.reserve();
}

void LivingPicture::measure(const RayCounts& before, double took) {
    const RayCounts& now = picture_.counts.rays;
    const auto samples = static_cast<double>(now.primary - before.primary),
               rays = static_cast<double>(now.total() - before.total());
    rays_ += now.total() - before.total();
    if (samples < 64 || took <= 0) return;
    samplesPerSecond_ = samples / took;
    raysPerSecond_ = rays / took;
}

// ---- Errors ----

// Finding them may cost one part in a hundred of the time, but for the first few samples, whose
// errors change fast.
bool LivingPicture::needsJudging() const {
    if (picture_.spp == 0) return false;
    const Picture::Judged& last = picture_.judged;
    if (!(last.rect == workRect()) || !(last.mix == picture_.film.mix())) return true;
    return last.spp < picture_.spp &&
           (picture_.spp >= 2 * last.spp || picture_.seconds - last.seconds > 100 * judgingTook_ ||
            isConverged());
}

bool LivingPicture::judge(const CancelToken& cancel) {
    const auto start = Clock::now();
    FilmErrors found;
    if (!findErrors(picture_.film, workRect(), pool_, cancel, found)) return false;
    picture_.errors = std::move(found);
    picture_.spp = picture_.errors.leastSamples;
    picture_.trend.add(picture_.seconds, picture_.errors.picture);
    picture_.judged = {workRect(), picture_.film.mix(), picture_.spp, picture_.seconds};
    judgingTook_ = secondsSince(start);
    return true;
}

}  // namespace glint
