#include "tracer/io/render_stats.h"

#include <cmath>

#include "tracer/io/atomic_file.h"
#include "tracer/io/json_text.h"

namespace glint {

Status saveStats(const RenderStats& stats, const std::filesystem::path& path) {
    Json out = Json::object();
    out["scene"] = stats.scene;
    out["integrator"] = stats.integrator;
    out["width"] = stats.width;
    out["height"] = stats.height;
    out["spp"] = stats.spp;
    out["threads"] = stats.threads;
    out["seed"] = stats.seed;
    out["setup_seconds"] = stats.setupSeconds;
    out["render_seconds"] = stats.renderSeconds;
    out["error_percent"] = std::isfinite(stats.errorPercent) ? Json(stats.errorPercent) : Json();
    out["rays"] = Json{{"primary", stats.primaryRays},
                       {"shadow", stats.shadowRays},
                       {"scatter", stats.scatterRays}};
    out["nonfinite_samples"] = stats.nonfiniteSamples;
    out["features"] = stats.features;
    out["kernel"] = stats.kernel;
    out["skips"] = stats.skips;
    Json work = Json::object();
    for (std::size_t i = 0; i < kWorkKinds; ++i)
        work[std::string(kWorkNames[i])] = stats.work.of[i];
    out["work"] = work;
    out["peak_memory_bytes"] = stats.peakMemoryBytes;
    out["interrupted"] = stats.interrupted;
    out["warnings"] = stats.warnings;
    return writeWhole(path, formatJson(out));
}

}  // namespace glint
