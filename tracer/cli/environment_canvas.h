// A latitude-longitude picture being painted with functions of direction.
#pragma once

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

#include "tracer/io/image_file.h"
#include "tracer/math/types.h"

namespace glint {

/// Unit direction at (u, v) in [0, 1]^2 of a picture as the scene format defines it: row 0 is up,
/// the middle is -z.
[[nodiscard]] DVec3 latLongDirection(double u, double v);
/// The inverse.
[[nodiscard]] DVec2 latLongUv(const DVec3& d);

/// Radiance in doubles; width is twice the height.
class LatLongCanvas {
  public:
    explicit LatLongCanvas(int width);

    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return width_ / 2; }
    /// Solid angle of one texel of the row [sr].
    [[nodiscard]] double texelSolidAngle(int row) const;

    /// Sets each texel to the mean of `radiance(direction)` over samples x samples points in it.
    /// Rows are shared among threads; the result does not depend on how many.
    template <class Radiance>
    void paint(int samples, const Radiance& radiance) {
        std::atomic<int> next = 0;
        std::vector<std::jthread> threads;
        for (unsigned i = 0; i < std::max(1u, std::thread::hardware_concurrency()); ++i)
            threads.emplace_back([&] {
                // Relaxed: the counter only deals out rows; the joins publish the texels.
                for (int row; (row = next.fetch_add(1, std::memory_order_relaxed)) < height();)
                    for (int column = 0; column < width(); ++column)
                        texel(row, column) = mean(row, column, samples, radiance);
            });
    }
    /// Adds a disc of constant radiance, weighted by area, so that its irradiance is kept however
    /// coarse the texels are.
    void addDisc(const DVec3& centre, double angularRadius, const DVec3& radiance);
    /// The picture, each number rounded to 11 significant bits: what 16-bit floats hold, but with
    /// the range of 32 bits; files shrink to a third, and the last bits of the mathematical library
    /// do not show.
    [[nodiscard]] Image image() const;

  private:
    [[nodiscard]] DVec3& texel(int row, int column) {
        return radiance_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
                         static_cast<std::size_t>(column)];
    }
    template <class Radiance>
    [[nodiscard]] DVec3 mean(int row, int column, int samples, const Radiance& radiance) const {
        DVec3 sum(0.0);
        for (int j = 0; j < samples; ++j)
            for (int i = 0; i < samples; ++i)
                sum += radiance(latLongDirection((column + (i + 0.5) / samples) / width(),
                                                 (row + (j + 0.5) / samples) / height()));
        return sum / double(samples * samples);
    }

    int width_;
    std::vector<DVec3> radiance_;  ///< height x width, row-major, top row first
};

}  // namespace glint
