// Headless rendering: one compiled scene to one picture, on threads of its own. For glint-render,
// tests and benches; the editor's living render is session.h.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tracer/base/work.h"
#include "tracer/io/film_exr.h"
#include "tracer/io/image_file.h"
#include "tracer/scene/scene.h"

namespace glint {

struct RenderScene;

/// A rectangle of pixels; pixels outside it stay black.
struct PixelRect {
    int x = 0, y = 0, width = 0, height = 0;
    bool operator==(const PixelRect&) const = default;
};

/// Rays traced, by kind.
struct RayCounts {
    std::uint64_t primary = 0;  ///< one a sample, also where what it hits was known
    std::uint64_t shadow = 0, scatter = 0;
    [[nodiscard]] std::uint64_t total() const { return primary + shadow + scatter; }
    RayCounts& operator+=(const RayCounts& other) {
        primary += other.primary, shadow += other.shadow, scatter += other.scatter;
        return *this;
    }
};

/// The sample that shows a fault again: `glint-render SCENE --pixel x,y,sample`.
struct SamplePlace {
    int x = 0, y = 0, sample = 0;
};

struct RenderProgress {
    int spp = 0, sppTarget = 0;
    double seconds = 0;
    double remainingSeconds = 0;
    double fraction = 0;  ///< of the work, 0 to 1
    double error = 0;     ///< of the picture, see pictureError(); infinite at first
};

/// Which kernel traces a scene. All give the same bits; the others show what the smallest one
/// spares.
enum class KernelChoice {
    Smallest,  ///< that covers the scene
    Full,      ///< made for everything a scene can hold
    NoSkips    ///< does work that cannot count all the same
};

struct RenderRequest {
    int threads = 0;                ///< 0: as many as the machine has processors
    std::optional<PixelRect> crop;  ///< in film pixels
    const std::atomic<bool>* stop =
        nullptr;  ///< set it to end at the next path vertex; what is there is kept
    const std::atomic<bool>* pause =
        nullptr;          ///< while it is set no pass is begun; the time does not count
    bool layers = false;  ///< fill Rendering::layers; costs time and some 300 bytes a pixel
    KernelChoice kernel = KernelChoice::Smallest;
    bool alpha = false;   ///< fill Rendering::alpha
    bool filter = false;  ///< fill Rendering::filtered
    double memory = 0;    ///< bytes to use at most; 0: what the system has free
    std::function<void(const RenderProgress&)>
        progress;  ///< called a few times a second on the calling thread
};

struct Rendering {
    Image beauty;    ///< film size, mean of the samples
    Image filtered;  ///< if asked for: the picture denoised for a preview, see preview_filter.h
    std::vector<ExrChannel>
        layers;  ///< if asked for: the channels of a multi-layer EXR, see layers.h
    std::vector<float>
        alpha;    ///< if asked for: share of each pixel's samples that met an object, row-major
    int spp = 0;  ///< samples that every pixel has
    bool even =
        true;  ///< no pixel has more than that: the picture can be made again from its number
    int threads = 0;
    double seconds = 0;
    double error = 0;  ///< of the picture, see pictureError()
    RayCounts rays;
    WorkCounts work;
    std::string kernel;  ///< name of the one that was used
    std::uint64_t nonfiniteSamples = 0;
    std::optional<SamplePlace> firstNonfinite;
    bool interrupted = false;
};

/// Why this machine cannot render the picture: it needs more memory than is free. Asked before
/// rendering, for a system that runs out of memory ends programs without a word.
[[nodiscard]] std::optional<Error> memoryProblem(const RenderScene& scene,
                                                 const RenderRequest& request);

/// Renders until the scene's own stop rule (samples, time, error) is met. Bit-identical for every
/// number of threads. A film that does not fit into memory is rendered in bands of rows, one after
/// the other, where the rule is the number of samples alone.
[[nodiscard]] Rendering render(const std::shared_ptr<const RenderScene>& scene,
                               const RenderRequest& request);

/// The value of one sample of one pixel, as the render computes it.
[[nodiscard]] Rgb renderSample(const RenderScene& scene, const SamplePlace& place);

}  // namespace glint
