// What a headless render reports about itself, as a JSON file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "tracer/base/result.h"
#include "tracer/base/work.h"

namespace glint {

struct RenderStats {
    std::string scene;  ///< path as given
    std::string integrator;
    int width = 0, height = 0;
    int spp = 0;  ///< samples that every pixel has
    int threads = 0;
    int seed = 0;
    double setupSeconds = 0;  ///< reading and compiling
    double renderSeconds = 0;
    double errorPercent =
        0;  ///< of the picture; infinite (null in the file) before the second sample
    std::uint64_t primaryRays = 0, shadowRays = 0, scatterRays = 0;
    std::uint64_t nonfiniteSamples = 0;
    std::vector<std::string> features;
    std::string kernel;
    std::vector<std::string> skips;
    WorkCounts work;
    std::uint64_t peakMemoryBytes = 0;
    bool interrupted = false;
    std::vector<std::string> warnings;
};

/// Writes {"scene": ..., "rays": {"primary": ..., "shadow": ..., "scatter": ...}, ...}; whole or
/// not at all.
[[nodiscard]] Status saveStats(const RenderStats& stats, const std::filesystem::path& path);

}  // namespace glint
