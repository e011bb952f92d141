// Building small scenes in tests, and rendering them.
#pragma once

#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "tracer/compile/compiler.h"
#include "tracer/compile/render_scene.h"
#include "tracer/render/render.h"
#include "tracer/scene/edit.h"

namespace glint::test {

[[nodiscard]] inline Color grey(double v) { return {v, v, v}; }

/// A scene under construction: each call adds one thing.
class SceneBuilder {
  public:
    SceneBuilder();  ///< 32 x 32 pixels, path, 16 interactions, no light at all

    template <class M>
    MaterialId material(const M& value) {
        return scene_.materials.add(
            {"Material " + std::to_string(scene_.materials.size() + 1), value});
    }
    ObjectId object(const Shape& shape, MaterialId material, const DVec3& at = DVec3(0.0),
                    const Color& emission = {});
    void pointLight(const DVec3& at, const Color& intensity);
    /// A camera with the given vertical angle of view.
    void camera(const DVec3& from, const DVec3& to, double fovDegrees);
    void film(int width, int height, int spp);  ///< 16 times the samples in the full form

    Scene& scene() { return scene_; }
    [[nodiscard]] std::shared_ptr<const RenderScene> compile() const;
    [[nodiscard]] Rendering render(int threads = 2) const;

  private:
    Scene scene_;
};

/// Mean of the picture, and the standard error of that mean from the spread over pixels that share
/// one true value.
struct Estimate {
    double mean = 0, sigma = 0;
};
/// Mean and standard error of every pixel's red channel over renders with different seeds.
struct PixelEstimates {
    int width = 0, height = 0;
    std::vector<Estimate> pixels;  ///< height x width, row-major
    [[nodiscard]] const Estimate& at(int x, int y) const {
        return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(x)];
    }
};
[[nodiscard]] PixelEstimates estimatePixels(SceneBuilder builder, int seeds);

/// Of one channel (0 red, 1 green, 2 blue).
[[nodiscard]] Estimate estimateMean(const Image& image, int channel = 0);
[[nodiscard]] Rgb pixelAt(const Image& image, int x, int y);

/// A pixel's estimate, its standard error, and what it should be.
struct PixelTest {
    double estimate = 0, sigma = 0, exact = 0;
};
/// Whether (estimate - exact) / sigma over the given pixels behaves as a standard normal should: no
/// |z| beyond the bound of a whole suite at alpha = 1e-3 (Sidak), and their mean square near 1.
/// Says what it found first. `unseen`: the most that events too rare to have been sampled could
/// change a pixel by. The mean over all pixels, where such events are seen, must be within 4 sigma
/// of the exact mean all the same.
[[nodiscard]] testing::AssertionResult pixelsAre(const std::vector<PixelTest>& pixels, int seeds,
                                                 double unseen);
/// Fails unless pixelsAre().
void expectPixels(const std::vector<PixelTest>& pixels, int seeds, double unseen,
                  const std::string& what);

/// Whether the picture's mean is within 4 sigma of `exact`, and in the full form also within 0.1 %.
/// Says what it found.
[[nodiscard]] testing::AssertionResult meanIs(const Image& image, double exact);

/// Fails unless meanIs(), and sigma is below 0.1 % of `exact`.
void expectMean(const Image& image, double exact, const std::string& what);

/// The full form of the statistical tests was asked for (GLINT_FULL=1).
[[nodiscard]] bool fullRun();

}  // namespace glint::test
