// Where a classic picture still needs samples. Without lamps that have a size, a lens or chance in the rays, a sample depends on
// nothing but its place in the pixel, and the picture is smooth but for edges: pixels that no edge crosses are done after a few
// samples. For pictures with noise see adaptive.h.
#pragma once

#include <vector>

#include "tracer/render/film.h"

namespace glint {

/// Samples of the scene differ only by their places in the pixel, and pixels do not reach beyond their neighbours.
[[nodiscard]] bool isPiecewiseSmooth(const RenderScene& scene);

/// The number of samples that each pixel of the film is to have next (height x width, row-major; a SampleGoal's `pixels`), all of
/// `rect` having reached the goals before, or none. All go together to kFewSamples; then those double that have kept up and lie
/// on an edge: where the halves of the film differ, or the means around are not in line, by more than a fiftieth of their
/// brightness. So do those with a sample that took a chance (1 in `chances`, a byte for each pixel of the film): that samples
/// agree says nothing there. A pure function of the film. No pixel gets more than `spp`; where nothing changes, the picture is
/// done.
inline constexpr std::uint32_t kFewSamples = 4;
[[nodiscard]] std::vector<std::uint32_t> edgeGoals(const Film& film, const PixelRect& rect, const std::vector<std::uint8_t>& chances, std::uint32_t spp);

}  // namespace glint
