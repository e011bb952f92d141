// The command line of glint-render.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "tracer/base/result.h"
#include "tracer/io/rendering_file.h"
#include "tracer/render/render.h"

namespace glint {

struct Options {
    std::filesystem::path scene;
    std::filesystem::path output;
    std::filesystem::path stats;  ///< empty: none
    std::optional<std::pair<int, int>> size;
    std::optional<int> spp;
    std::optional<double> timeSeconds;
    std::optional<double> errorPercent;
    std::optional<Integrator> integrator;
    std::optional<int> seed;
    int threads = 0;  ///< 0: as many as there are processors
    PictureOptions picture;
    std::filesystem::path verify;  ///< a picture to render again and compare; empty: none
    std::optional<SamplePlace> pixel;
    std::vector<std::pair<std::string, std::string>> settings;  ///< JSON pointer, value
    std::optional<double> exposureEv;
    bool quiet = false;
    bool schema = false;
};

/// The program's options, or the exit code where it is to end at once: after --help and --version,
/// or with a message on stderr about what is wrong.
[[nodiscard]] std::variant<Options, int> parseOptions(int argc, char** argv);

/// The scene as the options want it. Errors are about options.
[[nodiscard]] Result<Scene> withOptions(Scene scene, const Options& options);

}  // namespace glint
