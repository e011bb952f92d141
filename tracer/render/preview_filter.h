// PreviewFilter: a denoised look at an unfinished picture, for display and as a layer of its own,
// never part of the film. Variance-guided edge-avoiding a-trous wavelets (Dammertz et al.,
// "Edge-Avoiding A-Trous Wavelet Transform", 2010; the variance as in Schied et al.,
// "Spatiotemporal Variance-Guided Filtering", 2017, sec. 4.2, without its temporal part): light
// divided by what surfaces send back of it is averaged over pixels that look at the same surface
// and differ by no more than their noise says, then multiplied again. The loops are in
// preview_filter_simd.cpp.
#pragma once

#include <vector>

#include "tracer/render/film.h"
#include "tracer/render/guides.h"

namespace glint {

/// A picture of floats with a margin, so that no look at a neighbour leaves it. Rows begin on whole
/// vectors.
class FilterPlane {
  public:
    static constexpr int kLanes = 8;    ///< pixels that are worked on at a time
    static constexpr int kMargin = 32;  ///< the farthest neighbour looked at, on every side

    void resize(int width, int height);
    [[nodiscard]] int pitch() const { return pitch_; }  ///< floats from a row to the next
    /// The first pixel of a row; rows -kMargin to height + kMargin - 1 are there.
    [[nodiscard]] float* row(int y) { return values_.data() + offset(y); }
    [[nodiscard]] const float* row(int y) const { return values_.data() + offset(y); }

  private:
    [[nodiscard]] std::ptrdiff_t offset(int y) const {
        return static_cast<std::ptrdiff_t>(y + kMargin) * pitch_ + kMargin;
    }
    int pitch_ = 0;
    std::vector<float> values_;
};

/// What the loops work on. The margin's normals are 0, which keeps every weight there at 0.
struct FilterPlanes {
    int width = 0, height = 0;
    FilterPlane light[2][3];  ///< radiance over albedo, before and after a step
    FilterPlane variance[2];  ///< of its luminance
    FilterPlane normal[3];
    FilterPlane nearness;  ///< 1 / length of the way: linear over a plane in the picture
    FilterPlane slope[2];  ///< its change a pixel along x and y
};

class PreviewFilter {
  public:
    static constexpr int kSteps = 5;  ///< the last one looks 2 * 2^(kSteps - 1) pixels far

    /// Fills `out` (height x width, row-major, linear) with the denoised means of `film`. Pixels
    /// without a sample take no part and stay black; all others need a guide. False when cancelled:
    /// `out` is then of no use.
    bool run(const Film& film, const GuideFilm& guides, WorkerPool& pool, const CancelToken& cancel,
             std::vector<Rgb>& out);

  private:
    void load(const Film& film, const GuideFilm& guides, int y);
    void remodulate(const GuideFilm& guides, int y);
    void store(int y, std::vector<Rgb>& out) const;

    FilterPlanes planes_;
};

/// One row of each stage, for the processor's instruction set. Rows do not depend on each other.
struct FilterLoops {
    /// variance[0] holds what single pixels say of their variance (below 0: nothing), variance[1]
    /// receives its mean over the like pixels near by; where they say nothing, the variance among
    /// those pixels. light[1] receives light[0] without outliers: noise that stands out of all like
    /// neighbours. Also fills `slope`.
    void (*prepare)(FilterPlanes& planes, int y);
    /// One a-trous step from light[from], variance[from] to the other ones, looking at every
    /// distance-th neighbour.
    void (*step)(FilterPlanes& planes, int from, int distance, int y);
};
[[nodiscard]] FilterLoops filterLoops();

}  // namespace glint
