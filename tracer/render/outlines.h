// Outlines: pictures of `classic` are smooth but for outlines of shapes, of shadows and of what
// mirrors and glass show. One ray through the middle of a pixel and what those of its neighbours
// met tell which pixels an outline may cross; only these get more rays, and few, see
// outline_cell.h. All others take the one, with the curvature that their neighbours tell of. An
// outline that leaves a pixel is followed into the next.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "tracer/base/large_vector.h"
#include "tracer/render/kernel.h"
#include "tracer/render/outline_cell.h"
#include "tracer/render/scheduler.h"

namespace glint {

class Outlines {
  public:
    /// Most that it takes for a pixel.
    static constexpr double kBytesAPixel = 49;

    /// Classic, without a lens and without lights that have a size: the value of a ray rests on no
    /// random number, but for dim branches. And with the pixel itself as filter: others bend
    /// outlines in the square that samples are drawn from, where they are dearer to find than to
    /// sample.
    [[nodiscard]] static bool suit(const RenderScene& scene);

    /// For a picture of half the squared `error`, over its mean luminance, at most, see refine().
    /// `rect` within the film; the scene must suit() and stay. `wanted` as in chooseKernel().
    Outlines(const RenderScene& scene, Features wanted, const PixelRect& rect, double error);

    /// Puts all pixels into the film, each by its one ray. Both: false when cancelled; then some
    /// pixels are put and some not.
    bool look(Film& film, WorkerPool& pool, const CancelToken& cancel, RenderCounts& counts);
    /// After look(): refines pixels that err by more than their share. A further call takes twice
    /// as many rays at most for each. Pixels that err by more than their share after the last one,
    /// or that few rays cannot tell at all, lose their samples.
    bool refine(Film& film, WorkerPool& pool, const CancelToken& cancel, RenderCounts& counts);
    /// refine() was called for the last time.
    [[nodiscard]] bool isDone() const { return calls_ == kMostCalls; }
    /// Of all pixels that have their light from here, over the mean luminance of the picture, as
    /// estimated.
    [[nodiscard]] double error() const { return error_; }

  private:
    static constexpr int kMostCalls = 4;
    struct Pixel {
        Probe middle;
        float error = 0;  ///< of what the film has [luminance]
        float step = 0;   ///< largest to a neighbour of another trail [luminance]
        std::uint64_t materials = 0;
        std::array<bool, 4> crossed{};  ///< the sides across which an outline is known to go
        std::int8_t split = 0;          ///< its square is to be split so often at least, because a
                                        ///< neighbour's outline enters it
        bool isEntered = false;         ///< by a neighbour's outline
        bool isWanted = true;           ///< by the next wave
        bool isHard = false;            ///< few rays do not tell it
    };
    /// An outline goes into a pixel through a side.
    struct Entry {
        int x, y;
        std::size_t side;
        int split;
    };
    struct Worker;
    struct Run;

    [[nodiscard]] const Pixel& at(int x, int y) const {
        return pixels_[static_cast<std::size_t>(y - rect_.y) *
                           static_cast<std::size_t>(rect_.width) +
                       static_cast<std::size_t>(x - rect_.x)];
    }
    [[nodiscard]] Pixel& at(int x, int y) {
        return const_cast<Pixel&>(std::as_const(*this).at(x, y));
    }
    [[nodiscard]] bool holds(int x, int y) const {
        return x >= rect_.x && y >= rect_.y && x < rect_.x + rect_.width &&
               y < rect_.y + rect_.height;
    }
    template <class Visit>
    bool eachWanted(Run& run, bool traces, const Visit& visit);

    [[nodiscard]] Probe probe(Worker& worker, int x, int y, const DVec2& u) const;
    [[nodiscard]] Probe sharedProbe(Worker& worker, int x, int y, const DVec2& u) const;
    void lookAt(Worker& worker, int x, int y);
    void putMiddle(Film& film, int x, int y);
    [[nodiscard]] Rgb beyondMiddle(int x, int y) const;
    [[nodiscard]] double tolerance() const;
    void refine(Film& film, Worker& worker, int x, int y, double tolerance);
    bool follow(Run& run);
    void sumUp();

    const RenderScene& scene_;
    RayFunction trace_;
    bool culls_;
    double wantedError_;
    PixelRect rect_;
    PixelRect tiles_;  ///< that it touches, in tiles
    int calls_ = 0;
    double error_ = 0;  ///< see error()
    LargeVector<Pixel> pixels_;
    std::vector<ExpectedLight> expected_;  ///< by tile: known to it alone, whatever the threads
};

}  // namespace glint
