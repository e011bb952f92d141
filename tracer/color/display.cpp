#include "tracer/color/display.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

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

/// 8-bit sRGB by table over the linear value: exact to the nearest code, because each code's lower
/// bound is looked up. The table goes by the leading bits of the float, so that the codes, which
/// are dense where it is dark, have at most one bound in an entry: no branches.
class SrgbTable {
  public:
    SrgbTable() {
        for (unsigned code = 1; code < 256; ++code)
            lowerBound_[code] = linearFromSrgb((static_cast<float>(code) - 0.5f) / 255.0f);
        lowerBound_[256] = kInfinity;
        for (unsigned i = 0; i < kEntries; ++i) {
            const auto x = std::bit_cast<float>((kFirst + i) << kDropped);
            first_[i] = static_cast<std::uint8_t>(
                std::upper_bound(lowerBound_ + 1, lowerBound_ + 256, x) - lowerBound_ - 1);
        }
    }
    [[nodiscard]] std::uint32_t encode(float linear) const {
        const float x = std::min(std::max(linear, kLeast), 1.0f);
        const unsigned code = first_[(std::bit_cast<std::uint32_t>(x) >> kDropped) - kFirst];
        return code + (x >= lowerBound_[code + 1]);
    }

  private:
    static constexpr unsigned kDropped =
        16;  ///< bits of the mantissa: 128 entries for each power of two
    static constexpr float kLeast = 1.0f / 8192;  ///< below the first bound, 0.5 / 255 / 12.92
    static constexpr unsigned kFirst = std::bit_cast<std::uint32_t>(kLeast) >> kDropped;
    static constexpr unsigned kEntries =
        (std::bit_cast<std::uint32_t>(1.0f) >> kDropped) - kFirst + 1;
    static constexpr float kInfinity = std::numeric_limits<float>::infinity();
    float lowerBound_[257] = {};
    std::uint8_t first_[kEntries] = {};
};

}  // namespace

DisplayTransform::DisplayTransform(const DisplaySettings& settings)
    : scale_(static_cast<float>(std::exp2(settings.exposureEv))) {}

std::uint32_t DisplayTransform::apply(const Rgb& linear) const {
    std::uint32_t out = 0;
    apply({&linear, 1}, {&out, 1});
    return out;
}

void DisplayTransform::apply(std::span<const Rgb> linear, std::span<std::uint32_t> out) const {
    static const SrgbTable table;
    for (std::size_t i = 0; i < linear.size(); ++i) {
        const Rgb& v = linear[i];
        const bool isNumber = !std::isnan(v.x) && !std::isnan(v.y) && !std::isnan(v.z);
        const std::uint32_t code = table.encode(v.x * scale_) << 16 |
                                   table.encode(v.y * scale_) << 8 | table.encode(v.z * scale_);
        out[i] = 0xff000000u | (isNumber ? code : 0x00ff00ffu);
    }
}

std::array<std::uint16_t, 3> DisplayTransform::apply16(const Rgb& linear) const {
    constexpr std::uint16_t kMost = 65535;
    if (std::isnan(linear.x) || std::isnan(linear.y) || std::isnan(linear.z))
        return {kMost, 0, kMost};
    const auto code = [&](float v) {
        return static_cast<std::uint16_t>(srgbFromLinear(v * scale_) * kMost + 0.5f);
    };
    return {code(linear.x), code(linear.y), code(linear.z)};
}

}  // namespace glint
