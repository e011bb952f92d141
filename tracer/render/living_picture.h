// LivingPicture: the picture behind a viewport, through edits and passes: it keeps of its samples
// what an edit does not touch, brings back what undo has seen before, and knows which pass comes
// next. One thread calls it; messages and frames are session.h's. Start at takeUp() and render().
#pragma once

#include "tracer/compile/compiler.h"
#include "tracer/render/backdrop.h"
#include "tracer/render/list_renewal.h"
#include "tracer/render/picture.h"

namespace glint {

class LivingPicture {
  public:
    /// `wanted`: what kernels must offer beside what scenes hold, see chooseKernel().
    explicit LivingPicture(WorkerPool& pool, Features wanted = 0)
        : pool_(pool), scheduler_(pool, wanted, &firstHits_) {}
    LivingPicture(const LivingPicture&) = delete;

    /// What is to be shown.
    struct Wish {
        Scene scene;
        std::filesystem::path assetFolder;
        int width = 0, height = 0;        ///< of the picture in pixels
        std::optional<PixelRect> region;  ///< only these get samples; within the picture
    };
    /// Makes the picture one of `wish`, with as many of its samples as hold. A scene that cannot be
    /// compiled leaves it as it is.
    void takeUp(Wish wish);
    /// No sample holds any more, nor any kept for undo: the next takeUp() starts from nothing.
    void forgetSamples();
    /// Only the region is another one. False: the picture cannot follow without takeUp(), because
    /// the pixels outside the old one may be of an older scene.
    bool setRegion(const std::optional<PixelRect>& region);

    [[nodiscard]] bool exists() const { return picture_.scene != nullptr; }
    /// A stop rule is met.
    [[nodiscard]] bool isConverged() const {
        return picture_.spp > 0 && isDone(rules(), progress());
    }
    /// Every pixel has something to show that needs no pass: the picture is complete, or the one of
    /// before stands in.
    [[nodiscard]] bool isShowable() const { return picture_.shownStride > 0 && !firstPassPending_; }

    /// What single passes do to the clock: the first one after an edit takes about `first`, one at
    /// full resolution at most `full`.
    struct PassTimes {
        double first, full;  ///< seconds
    };
    /// Renders the pass that comes next.
    PassResult render(const PassTimes& times, const CancelToken& cancel);

    /// Gets ready for an edit that keeps this picture for undo and begins a new one: memory from
    /// the system is slow. A little at a time.
    void lookAhead(const CancelToken& cancel);

    /// The errors are to be found again, because the film has changed by more than a little.
    [[nodiscard]] bool needsJudging() const;
    /// Finds them; false when cancelled.
    bool judge(const CancelToken& cancel);

    [[nodiscard]] const Picture& picture() const { return picture_; }
    [[nodiscard]] const Backdrop* backdrop() const { return backdrop_ ? &*backdrop_ : nullptr; }
    [[nodiscard]] double remainingSeconds() const;
    [[nodiscard]] double meanSamples() const { return progress().samples; }
    [[nodiscard]] double retracedShare() const { return retracedShare_; }
    [[nodiscard]] std::uint64_t restarts() const { return restarts_; }
    [[nodiscard]] std::uint64_t rays() const { return rays_; }
    [[nodiscard]] double raysPerSecond() const { return raysPerSecond_; }

  private:
    /// For pictures of scenes that undo may come back to, and for sums by light group (without
    /// which light edits restart). First hits, which are kept of the present picture alone, take 16
    /// bytes a pixel beside.
    static constexpr std::size_t kCacheBytes = std::size_t{512} << 20,
                                 kGroupBytes = std::size_t{256} << 20;
    static constexpr int kMaxStride = 64;

    [[nodiscard]] PixelRect workRect() const {
        return wish_.region.value_or(PixelRect{0, 0, wish_.width, wish_.height});
    }
    [[nodiscard]] const RenderSettings& rules() const { return wish_.scene.render; }
    [[nodiscard]] RenderProgressState progress() const;

    void keep(const LightMix& mix);
    bool retrace(const Scene& next, const EditPlan& plan);
    void restart(Scene next, bool assetsChanged = false);
    [[nodiscard]] Result<Compiled> compileNext(const Scene& next);
    void adopt(Compiled compiled);
    void prepareFilm(bool sameSize);
    void forgetProgress();
    [[nodiscard]] bool onlySizeDiffers(const Scene& next) const;

    [[nodiscard]] int strideFor(double seconds) const;
    [[nodiscard]] std::optional<SampleGoal> nextGoal(double seconds, const CancelToken& cancel);
    void passDone(const SampleGoal& goal);
    void measure(const RayCounts& before, double took);

    WorkerPool& pool_;
    FirstHits firstHits_;
    Scheduler scheduler_;
    ListRenewal renewal_;
    AssetCache assets_;
    Wish wish_;
    Picture picture_;
    PictureCache cache_{kCacheBytes};
    std::optional<Backdrop> backdrop_;
    bool samplesHold_ = true;        ///< see forgetSamples()
    bool restIsOld_ = false;         ///< the pixels outside `newRect_` are of an older scene
    PixelRect newRect_;              ///< what the last restart cleared
    bool firstPassPending_ = false;  ///< no pass of the edited scene is done yet
    double pendingPixels_ = 0;       ///< that passes bring samples to ...
    int pendingSpp_ = 0;             ///< ... until every pixel has so many
    double retracedShare_ = 0;
    std::uint64_t rays_ = 0, restarts_ = 0;
    double raysPerSecond_ = 0;
    double samplesPerSecond_ = 1e5;  ///< measured; the start is cautious
    double judgingTook_ = 0;         ///< seconds, the last time
};

}  // namespace glint
