#include "tracer/color/display.h"

#include <algorithm>
#include <cmath>

namespace glint {

float srgbFromLinear(float linear) {
    const float x = std::clamp(linear, 0.0f, 1.0f);
    return x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1 / 2.4f) - 0.055f;
}

float linearFromSrgb(float encoded) {
    const float x = std::clamp(encoded, 0.0f, 1.0f);
    return x <= 0.04045f ? x / 12.92f : std::pow((x + 0.055f) / 1.055f, 2.4f);
}

namespace {

/// 8-bit sRGB by table over the linear value: exact to the nearest code, because each code's lower bound is looked up.
class SrgbTable {
  public:
    SrgbTable() {
        for (unsigned code = 1; code < 256; ++code)
            lowerBound_[code] = linearFromSrgb((static_cast<float>(code) - 0.5f) / 255.0f);
        for (unsigned i = 0; i < kGuesses; ++i) {
            const float x = static_cast<float>(i) / static_cast<float>(kGuesses);
            guess_[i] = static_cast<std::uint8_t>(std::upper_bound(lowerBound_ + 1, lowerBound_ + 256, x) - lowerBound_ - 1);
        }
    }
    [[nodiscard]] std::uint32_t encode(float linear) const {
        if (!(linear > 0)) return 0;
        if (linear >= lowerBound_[255]) return 255;
        unsigned code = guess_[static_cast<unsigned>(linear * static_cast<float>(kGuesses))];
        while (code < 255 && linear >= lowerBound_[code + 1]) ++code;
        return code;
    }

  private:
    static constexpr unsigned kGuesses = 4096;
    float lowerBound_[256] = {};
    std::uint8_t guess_[kGuesses] = {};
};

}  // namespace

DisplayTransform::DisplayTransform(const DisplaySettings& settings)
    : scale_(static_cast<float>(std::exp2(settings.exposureEv))) {}

std::uint32_t DisplayTransform::apply(const Rgb& linear) const {
    static const SrgbTable table;
    if (std::isnan(linear.x) || std::isnan(linear.y) || std::isnan(linear.z)) return 0xffff00ffu;
    return 0xff000000u | table.encode(linear.x * scale_) << 16 | table.encode(linear.y * scale_) << 8 |
           table.encode(linear.z * scale_);
}

std::array<std::uint16_t, 3> DisplayTransform::apply16(const Rgb& linear) const {
    constexpr std::uint16_t kMost = 65535;
    if (std::isnan(linear.x) || std::isnan(linear.y) || std::isnan(linear.z)) return {kMost, 0, kMost};
    const auto code = [&](float v) { return static_cast<std::uint16_t>(srgbFromLinear(v * scale_) * kMost + 0.5f); };
    return {code(linear.x), code(linear.y), code(linear.z)};
}

}  // namespace glint
