// Guides: what the first surfaces under a picture's pixels are, by rays of their own that carry no
// light. The channels of the viewport and the preview filter (preview_filter.h) are made of them.
// They use the same camera rays as the samples of the picture and are never part of it.
#pragma once

#include <memory>
#include <vector>

#include "tracer/render/kernel.h"
#include "tracer/render/worker_pool.h"

namespace glint {

/// What one camera ray meets.
struct GuideSample {
    // The first surface.
    Rgb albedo{0.0f};     ///< share of even light that it sends back; black where nothing is
    Vec3 normal{0.0f};    ///< world space, outward, unit; 0 where nothing is
    Vec3 position{0.0f};  ///< world space, metres; 0 where nothing is
    float depth = 0;      ///< along the view axis, metres; infinite where nothing is
    std::uint32_t object = 0, material = 0;  ///< as in LayerSample: 1-based, 0 is nothing
    // The first surface with a smooth part, seen through mirrors and clear glass by their brightest
    // way.
    Rgb seenAlbedo{
        1.0f};  ///< tinted by what it is seen through; the tint alone where the sky is seen
    Vec3 seenNormal{0.0f};   ///< towards the ray; away from it for a lamp, which is so unlike the
                             ///< surface that it lies in; for the sky against the ray
    float seenNearness = 0;  ///< 1 / (length of the way there), per metre; 0 for the sky
};

/// Follows the camera ray of sample number `sample` of pixel (x, y). No shadow rays, no light.
[[nodiscard]] GuideSample traceGuide(const RenderScene& scene, int x, int y, std::uint32_t sample);

/// Means over the first samples of every pixel; ids are those of sample 0.
class GuideFilm {
  public:
    /// Samples that are traced; more would sharpen nothing but blur of depth and motion.
    static constexpr std::uint32_t kSamples = 4;

    struct Pixel {
        Rgb albedo{0.0f};
        Vec3 normal{0.0f}, position{0.0f};
        float depth = 0;
        Rgb seenAlbedo{0.0f};
        Vec3 seenNormal{0.0f};
        float seenNearness = 0;
        std::uint32_t object = 0, material = 0, samples = 0;
    };

    /// Brings every pixel whose x and y are multiples of `stride` to at least `samples` (kSamples
    /// at most), starting from nothing if the scene or the size is another one. False when
    /// cancelled: the same call goes on where it ended.
    bool refine(const std::shared_ptr<const RenderScene>& scene, int width, int height, int stride,
                std::uint32_t samples, const CancelToken& cancel, WorkerPool& pool);

    /// Of every pixel of `scene` at that size; 0 if they are of another one.
    [[nodiscard]] std::uint32_t samplesOf(const std::shared_ptr<const RenderScene>& scene,
                                          int width, int height) const {
        return scene == scene_ && width == width_ && height == height_ ? samples_ : 0;
    }
    [[nodiscard]] const Pixel& at(int x, int y) const {
        return pixels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                       static_cast<std::size_t>(x)];
    }

  private:
    std::shared_ptr<const RenderScene> scene_;  ///< held, so that no other can come to its address
    int width_ = 0, height_ = 0;
    std::uint32_t samples_ = 0;  ///< that every pixel has
    std::vector<Pixel> pixels_;
    std::vector<char> rowIsCurrent_;  ///< else the row is of an older scene; emptied by the worker
                                      ///< that comes to it
};

}  // namespace glint
