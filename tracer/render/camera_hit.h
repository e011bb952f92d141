// What rays of paths hit: found, or known from an earlier first sample of the pixel, see
// first_hits.h.
#pragma once

#include "tracer/render/kernel.h"

namespace glint {

/// What a path's ray hits, after so many interactions. Camera rays are those that start on no
/// shape: a path that goes on through a hidden boundary starts there.
template <Features F>
[[nodiscard]] ShapeHit hitOf(KernelState& state, const Ray& ray, const MediaStack& media,
                             int depth) {
    const auto find = [&](const FewShapes* few) {
        return state.scene.lists->closest(ray, media, kInfinity, state.work, few);
    };
    if (depth > 0) return find(nullptr);
    if (!state.cameraHit || ray.fromShape != kNoShape) return find(state.seen);
    if (*state.cameraHit) {
        if constexpr (!has(F, Feature::NoSkips)) return **state.cameraHit;
        ++state.work[Work::KnownHits];
    }
    return state.cameraHit->emplace(find(state.seen));
}

}  // namespace glint
