#include "tracer/color/false_color.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace glint {

namespace {

std::uint32_t pack(const std::array<float, 3>& rgb) {
    std::uint32_t out = 0xff;
    for (const float v : rgb)
        out = out << 8 | static_cast<std::uint32_t>(std::clamp(v, 0.0f, 255.0f) + 0.5f);
    return out;
}

/// Full saturation at hue `h` in turns.
float hueChannel(float h, float offset) {
    const float x = std::abs(std::fmod(h + offset, 1.0f) * 6 - 3) - 1;
    return std::clamp(x, 0.0f, 1.0f);
}

}  // namespace

std::uint32_t falseColor(float t) {
    if (std::isnan(t)) return 0xffff00ffu;
    // sRGB anchors whose CIE lightness is about 6, 18, 30, 42, 55, 68, 81, 95.
    constexpr std::array<std::array<float, 3>, 8> kAnchors = {{{16, 12, 30},
                                                               {52, 22, 96},
                                                               {104, 32, 124},
                                                               {158, 50, 114},
                                                               {212, 78, 84},
                                                               {242, 124, 50},
                                                               {250, 184, 68},
                                                               {252, 246, 190}}};
    const float place = std::clamp(t, 0.0f, 1.0f) * static_cast<float>(kAnchors.size() - 1);
    const auto i = std::min(static_cast<std::size_t>(place), kAnchors.size() - 2);
    const float part = place - static_cast<float>(i);
    std::array<float, 3> rgb{};
    for (std::size_t c = 0; c < 3; ++c)
        rgb[c] = kAnchors[i][c] + part * (kAnchors[i + 1][c] - kAnchors[i][c]);
    return pack(rgb);
}

std::uint32_t idColor(std::uint32_t id) {
    if (id == 0) return 0xff202020u;
    // Hues by the golden ratio lie far apart for numbers that follow each other; two steps of
    // lightness part them further.
    const float hue = std::fmod(static_cast<float>(id % 4096) * 0.61803399f, 1.0f);
    const float bright = id / 2 % 2 ? 235.0f : 180.0f, pale = id % 2 ? 0.25f : 0.05f;
    std::array<float, 3> rgb{};
    for (std::size_t c = 0; c < 3; ++c)
        rgb[c] = bright * (pale + (1 - pale) * hueChannel(hue, static_cast<float>(3 - c) / 3));
    return pack(rgb);
}

}  // namespace glint
