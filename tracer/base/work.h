// What is done beside tracing rays, counted by kind: the proof that what a scene lacks costs it
// nothing (render/skips.h).
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace glint {

enum class Work : std::size_t {
    NodeVisits,       ///< nodes of the hierarchy of shapes
    BallBlocks,       ///< blocks of eight balls filtered
    BoxBlocks,        ///< blocks of eight bounding boxes filtered
    BallTests,        ///< balls decided in double
    ShapeTests,       ///< other shapes decided in double
    MatrixTests,      ///< of these, by a 3 x 3 matrix
    SkyLookups,       ///< paths that left the scene and asked for its sky
    MapLookups,       ///< environment pictures read or sampled
    EmissionTests,    ///< hits asked whether they emit
    LightSamples,     ///< points or directions drawn on lights
    LightChoices,     ///< choices of one light among several
    MisWeights,       ///< contributions shared between two ways of sampling
    BlackShadowRays,  ///< shadow rays for light that would not have counted
    ShadowSteps,      ///< surfaces asked whether they let a shadow ray through
    MediaSteps,       ///< boundaries crossed into or out of a medium
    Exponentials,     ///< absorption over a distance
    RoughLobes,       ///< microfacet and Phong lobes evaluated or sampled
    DeltaLists,       ///< lists of perfect reflections and refractions made
    Roulettes,        ///< paths asked whether to go on
    LensSamples,      ///< points drawn on a lens
    Connections,      ///< ways over a perfect ball that were looked for
    Highlights,       ///< lights looked for in glossy surfaces
    KnownHits,        ///< camera rays traced although what they hit was known
};
inline constexpr std::size_t kWorkKinds = static_cast<std::size_t>(Work::KnownHits) + 1;
/// Names for people and statistics, in the order of Work.
inline constexpr std::array<std::string_view, kWorkKinds> kWorkNames = {
    "node_visits",   "ball_blocks", "box_blocks",        "ball_tests",     "shape_tests",
    "matrix_tests",  "sky_lookups", "map_lookups",       "emission_tests", "light_samples",
    "light_choices", "mis_weights", "black_shadow_rays", "shadow_steps",   "media_steps",
    "exponentials",  "rough_lobes", "delta_lists",       "roulettes",      "lens_samples",
    "connections",   "highlights",  "known_hits"};

struct WorkCounts {
    std::array<std::uint64_t, kWorkKinds> of{};

    [[nodiscard]] std::uint64_t& operator[](Work kind) {
        return of[static_cast<std::size_t>(kind)];
    }
    [[nodiscard]] std::uint64_t operator[](Work kind) const {
        return of[static_cast<std::size_t>(kind)];
    }
    WorkCounts& operator+=(const WorkCounts& other) {
        for (std::size_t i = 0; i < kWorkKinds; ++i) of[i] += other.of[i];
        return *this;
    }
};

}  // namespace glint
