// Finding the piece that holds a place among many laid end to end in about two steps: a table says
// between which to look (Chen, Asau, "On Generating Random Variates from an Empirical
// Distribution", AIIE Transactions 6(2), 1974: the guide table method).
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

namespace glint {

/// The first and the last of the pieces that come into question.
struct PieceRange {
    int first, last;
};

/// Of `count` pieces that reach from 0 to `total`, those in which each share 0, 1 / count ... 1 of
/// the whole lies: guide.size() is count + 1.
template <class StartOf>
void fillGuide(std::span<std::uint32_t> guide, double total, const StartOf& startOf) {
    const int count = static_cast<int>(guide.size()) - 1;
    int piece = 0;
    for (int k = 0; k <= count; ++k) {
        const double target = total * k / count;
        while (piece + 1 < count && startOf(piece + 1) <= target) ++piece;
        guide[static_cast<std::size_t>(k)] = static_cast<std::uint32_t>(piece);
    }
}

/// Where the share `u` of the whole, in [0, 1), lies.
[[nodiscard]] inline PieceRange guided(std::span<const std::uint32_t> guide, double u) {
    const int count = static_cast<int>(guide.size()) - 1;
    const auto k = static_cast<std::size_t>(std::clamp(static_cast<int>(u * count), 0, count - 1));
    return {static_cast<int>(guide[k]), static_cast<int>(guide[k + 1])};
}

/// The last piece of the range that starts at or before the target; the first where none does.
/// Without branches but for the length.
template <class StartOf>
[[nodiscard]] int lastFrom(const PieceRange& range, double target, const StartOf& startOf) {
    int last = range.first;
    for (int count = range.last - range.first + 1; count > 1;) {
        const int half = count / 2;
        last = startOf(last + half) <= target ? last + half : last;
        count -= half;
    }
    return last;
}

}  // namespace glint
