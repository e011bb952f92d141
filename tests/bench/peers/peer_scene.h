// A scene made ready for other renderers, and what they have in common.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tracer/base/result.h"
#include "tracer/io/image_file.h"
#include "tracer/scene/scene.h"

namespace glint::bench {

/// What all renderers of a comparison get: their scene in the simplest terms, and how to render it.
struct PeerScene {
    std::string name;  ///< the file's, without its ending
    Scene scene;       ///< no groups, nothing hidden, every transform a matrix, one camera, a box
                       ///< filter, absolute paths; a computed sky is a picture
    int threads = 2;
    bool exact = false;  ///< peers are set up for the same picture, where that is dearer than the
                         ///< fastest similar one
    std::filesystem::path folder;  ///< for files of this scene
};

/// Loads `file` and simplifies it. Its film becomes `width` wide with the same shape; `folder` must
/// exist.
[[nodiscard]] Result<PeerScene> loadPeerScene(const std::filesystem::path& file, int width,
                                              int threads, const std::filesystem::path& folder);

/// A render and what it took, without starting, loading and building.
struct TimedPicture {
    Image image;
    double wallSeconds = 0;
    double cpuSeconds = 0;  ///< of all its threads
};

/// A renderer with one scene loaded.
class Renderer {
  public:
    virtual ~Renderer() = default;
    /// Independent pictures for different seeds.
    [[nodiscard]] virtual Result<TimedPicture> render(int spp, int seed) = 0;
    /// From the start of the program to the first sample [s].
    [[nodiscard]] virtual double setupSeconds() const = 0;
    /// Where its physics is not Glint's, in sentences.
    [[nodiscard]] virtual std::vector<std::string> notes() const { return {}; }
};

}  // namespace glint::bench
