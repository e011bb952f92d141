// Guide tables find the same piece as a search of all of them.
#include "tracer/math/search_guide.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace glint {
namespace {

/// Starts of pieces of these lengths, and their end.
std::vector<double> startsOf(const std::vector<double>& lengths) {
    std::vector<double> starts{0};
    for (const double length : lengths) starts.push_back(starts.back() + length);
    return starts;
}

/// The last piece that starts at or before the target.
int searched(const std::vector<double>& starts, double target) {
    int piece = 0;
    while (piece + 2 < static_cast<int>(starts.size()) &&
           starts[static_cast<std::size_t>(piece) + 1] <= target)
        ++piece;
    return piece;
}

void expectSamePieces(const std::vector<double>& lengths, std::mt19937_64& random) {
    const std::vector<double> starts = startsOf(lengths);
    const auto startOf = [&](int piece) { return starts[static_cast<std::size_t>(piece)]; };
    const double total = starts.back();
    std::vector<std::uint32_t> guide(lengths.size() + 1);
    fillGuide(std::span<std::uint32_t>(guide), total, startOf);
    std::vector<double> shares{0, std::nextafter(1.0, 0.0)};
    for (const double start : starts)  // Where pieces meet, and the numbers beside.
        for (const double share : {start / total, std::nextafter(start / total, 0.0),
                                   std::nextafter(start / total, 1.0)})
            if (share < 1) shares.push_back(share);
    std::uniform_real_distribution<double> anywhere(0, 1);
    for (int i = 0; i < 2000; ++i) shares.push_back(anywhere(random));
    for (const double u : shares) {
        const PieceRange range = guided(guide, u);
        ASSERT_LE(range.first, range.last);
        ASSERT_EQ(lastFrom(range, u * total, startOf), searched(starts, u * total))
            << u << " of " << lengths.size();
    }
}

TEST(SearchGuide, FindsThePieceThatASearchOfAllFinds) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> exponent(-12, 3);
    for (const std::size_t count : {1u, 2u, 3u, 7u, 64u, 1000u}) {
        std::vector<double> lengths(count);
        for (double& length : lengths) length = std::pow(10.0, exponent(random));
        expectSamePieces(lengths, random);
        for (std::size_t i = 0; i < count; i += 3)
            lengths[i] = 0;  // Empty ones, also in a row and at both ends.
        for (std::size_t i = count / 2; i < count; ++i) lengths[i] = 0;
        lengths[count / 2] = 1;
        expectSamePieces(lengths, random);
    }
}

TEST(SearchGuide, LooksAtTwoPiecesInTheMean) {
    std::mt19937_64 random(4);
    std::uniform_real_distribution<double> exponent(-12, 3);
    std::vector<double> lengths(4096);
    for (double& length : lengths) length = std::pow(10.0, exponent(random));
    const std::vector<double> starts = startsOf(lengths);
    std::vector<std::uint32_t> guide(lengths.size() + 1);
    fillGuide(std::span<std::uint32_t>(guide), starts.back(),
              [&](int piece) { return starts[static_cast<std::size_t>(piece)]; });
    double looked = 0;
    for (std::size_t k = 0; k < lengths.size(); ++k) looked += guide[k + 1] - guide[k] + 1;
    EXPECT_LE(looked / static_cast<double>(lengths.size()), 2);
}

}  // namespace
}  // namespace glint
