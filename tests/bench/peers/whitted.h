// The part of `peers` for scenes of the classic integrator: time at the same anti-aliasing error,
// against POV-Ray.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tests/bench/output.h"
#include "tests/bench/peers/peer_scene.h"
#include "tests/bench/reference_cache.h"
#include "tracer/io/svg_plot.h"

namespace glint::bench {

struct PeersOptions {
    std::vector<std::string> files;
    int width = 160;
    int threads = 2;
    int runs = 5;
    double seconds = 1;
    bool exact = false;
    double referenceFactor = 100;
    std::string json, plot, pictures, cache = usualCacheFolder().string();
};

/// What was found on all scenes so far.
struct WhittedFigures {
    std::vector<std::string> names;
    std::vector<double> wall, cpu;  ///< POV-Ray's time over Glint's, a scene
    Json scenes = Json::array();
    std::vector<PlotCurve> curves;  ///< error over processor time

    /// Prints the means and adds everything to `json`.
    void summarize(Json& json) const;
};

/// Compares on one scene. Every way of POV-Ray to smooth edges that no other beats in both time and
/// error counts, and Glint's time at the same error is read off its own curve. Answers with an exit
/// code.
int compareWithPovray(const PeersOptions& options, const PeerScene& scene, WhittedFigures& figures);

}  // namespace glint::bench
