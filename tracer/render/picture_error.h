// How far a picture is from a reference that is itself uncertain. For the error report of bench and
// editor; the live error of a render, which has no reference, is in tile_error.h.
#pragma once

#include <vector>

#include "tracer/io/image_file.h"

namespace glint {

/// A picture to judge others by: the mean of independent renders, and how uncertain each of its
/// values is.
struct Reference {
    Image mean;
    std::vector<float> variance;  ///< of each value of `mean`, in the same order
};

/// Gathers renders of one scene with different seeds to a reference (Welford's sums, in double).
class ReferenceSum {
  public:
    /// Pictures must be of one size.
    void add(const Image& image);
    [[nodiscard]] int count() const { return count_; }
    /// Mean of the pictures and variance of that mean from their spread; the variance is 0 for
    /// fewer than two.
    [[nodiscard]] Reference reference() const;

  private:
    int width_ = 0, height_ = 0, count_ = 0;
    std::vector<double> mean_, squares_;
};

/// Errors of a picture over all values (pixels times channels). A value's relative error is |I - R|
/// / sqrt(R^2 + eps) with eps = 0.01 (mean of R)^2, so that black pixels do not decide.
struct PictureErrors {
    double relMse =
        0;  ///< mean of ((I - R)^2 - var R) / (R^2 + eps): the reference's own noise is taken off
    double mape = 0;          ///< mean relative error
    double percentile99 = 0;  ///< of the relative errors
    double outlierShare =
        0;  ///< of values whose relative error is above 50 times the median: fireflies
};
[[nodiscard]] PictureErrors pictureErrors(const Image& image, const Reference& reference);

/// How two converged pictures that should be one differ, their own noise taken off.
struct PictureDifference {
    double meanRatio = 1;  ///< mean of all values of `b` over that of `a`
    double rms = 0;       ///< root of relMSE between the two with both variances taken off; 0 where
                          ///< noise explains all of it
    double rmsNoise = 0;  ///< root of that variance: differences below it cannot be seen
};
[[nodiscard]] PictureDifference pictureDifference(const Reference& a, const Reference& b);

}  // namespace glint
