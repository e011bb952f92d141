// From linear light to the screen: a pure function of the film. Changing it never restarts a
// render.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "tracer/color/rgb.h"
#include "tracer/scene/scene.h"

namespace glint {

struct DisplaySettings {
    double exposureEv = 0;
    View view = View::Standard;
    bool operator==(const DisplaySettings&) const = default;
};

/// The sRGB transfer curve (IEC 61966-2-1) and its inverse, for values in [0, 1]; outside they
/// clamp.
[[nodiscard]] float srgbFromLinear(float linear);
[[nodiscard]] float linearFromSrgb(float encoded);

/// Maps linear colours to 8-bit sRGB with one exposure. Made once a frame; apply() is called per
/// pixel from any thread.
class DisplayTransform {
  public:
    explicit DisplayTransform(const DisplaySettings& settings);
    /// 0xffRRGGBB. Not-a-number shows as magenta, so that it cannot hide.
    [[nodiscard]] std::uint32_t apply(const Rgb& linear) const;
    /// The same for many; both of the same length.
    void apply(std::span<const Rgb> linear, std::span<std::uint32_t> out) const;
    /// The same as 16-bit codes, each the nearest.
    [[nodiscard]] std::array<std::uint16_t, 3> apply16(const Rgb& linear) const;

  private:
    float scale_;
};

}  // namespace glint
