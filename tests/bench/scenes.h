// glint-bench scenes: how fast scenes render and how soon they are clean.
#pragma once

#include <string>
#include <vector>

namespace glint::bench {

struct SceneBenchOptions {
    std::vector<std::string> files;
    int spp = 16;
    int threads = 0;
    int runs = 5;
};

/// Renders the scenes in turn at 320 x 180 and prints a table: compile time, time, rays a second, error of the picture (see
/// pictureError in tracer/render/film.h) and efficiency 1 / (error^2 * time). With `jsonFile`, writes it there. Answers with
/// the exit code.
int runScenes(const SceneBenchOptions& options, const std::string& jsonFile);

}  // namespace glint::bench
