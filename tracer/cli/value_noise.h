// Smooth noise from an integer hash: the same on every machine.
#pragma once

#include <cstdint>

#include "tracer/math/types.h"

namespace glint {

/// A number in [0, 1) for a grid point.
[[nodiscard]] inline double latticeValue(std::int64_t x, std::int64_t y) {
    auto h = static_cast<std::uint64_t>(x) * 0x9e3779b97f4a7c15u ^
             static_cast<std::uint64_t>(y) * 0xc2b2ae3d27d4eb4fu;
    // Finalizer of SplitMix64 (Steele, Lea, Flood 2014).
    h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9u;
    h = (h ^ (h >> 27)) * 0x94d049bb133111ebu;
    return static_cast<double>((h ^ (h >> 31)) >> 11) * 0x1p-53;
}

/// Values of the grid points, blended with vanishing first and second derivatives at them.
[[nodiscard]] inline double valueNoise(const DVec2& p) {
    const DVec2 cell = glm::floor(p), f = p - cell;
    const DVec2 s = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
    const auto x = static_cast<std::int64_t>(cell.x), y = static_cast<std::int64_t>(cell.y);
    return glm::mix(glm::mix(latticeValue(x, y), latticeValue(x + 1, y), s.x),
                    glm::mix(latticeValue(x, y + 1), latticeValue(x + 1, y + 1), s.x), s.y);
}

/// Octaves of half the size and half the weight each, turned against one another; in [0, 1).
[[nodiscard]] inline double fractalNoise(DVec2 p, int octaves) {
    double sum = 0, weight = 0.5, total = 0;
    for (int i = 0; i < octaves; ++i, weight /= 2) {
        sum += weight * valueNoise(p);
        total += weight;
        p = DVec2(1.6 * p.x + 1.2 * p.y, -1.2 * p.x + 1.6 * p.y) + DVec2(17.3, 9.1);
    }
    return sum / total;
}

}  // namespace glint
