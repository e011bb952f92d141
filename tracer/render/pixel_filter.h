// Reconstruction filters by importance sampling: a sample's place in its pixel is drawn from the
// filter, so that every sample counts the same and no sample writes to another pixel (Ernst et al.,
// "Filter importance sampling", 2006).
#pragma once

#include "tracer/scene/scene.h"

namespace glint {

/// Offset from the pixel's centre along one axis, in units of the filter's radius: u in [0, 1) to
/// [-1, 1]. Box and tent are exact; Blackman-Harris is taken as constant within each of 4096 strips
/// of equal weight.
[[nodiscard]] double sampleFilter(Filter filter, double u);

}  // namespace glint
