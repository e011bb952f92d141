// The numbers of samples: each half of a pixel's samples is a (0, 2)-net in its first two
// coordinates at every power of two, and blocks do not depend on how they are asked for.
#include <gtest/gtest.h>

#include <set>

#include "tracer/math/sobol.h"

namespace glint {
namespace {

/// Points per elementary interval of area 2^-power with 2^a columns: all must be 1.
bool fillsEachInterval(std::uint32_t pixel, std::uint32_t block, std::uint32_t half, int power,
                       int a) {
    std::set<std::pair<int, int>> cells;
    for (std::uint32_t i = 0; i < (1u << power); ++i) {
        const SampleBlock u = Sampler(7, pixel, 2 * i + half).block(block);
        cells.emplace(static_cast<int>(std::ldexp(u.x, a)),
                      static_cast<int>(std::ldexp(u.y, power - a)));
    }
    return cells.size() == std::size_t{1} << power;
}

TEST(Sampler, EachHalfIsANetAtEveryPowerOfTwo) {
    for (std::uint32_t pixel = 0; pixel < 5; ++pixel)
        for (const std::uint32_t half : {0u, 1u})
            for (int power = 0; power <= 8; ++power)
                for (int a = 0; a <= power; ++a)
                    EXPECT_TRUE(fillsEachInterval(pixel, 258, half, power, a)) << power << " " << a;
}

TEST(Sampler, TheHalvesTogetherAreNoNet) {  // They are scrambled independently: what the test above
                                            // sees, it can also miss.
    int nets = 0;
    for (std::uint32_t pixel = 0; pixel < 50; ++pixel) {
        std::set<int> columns;
        for (std::uint32_t i = 0; i < 16; ++i)
            columns.insert(static_cast<int>(16 * Sampler(7, pixel, i).block(2).x));
        nets += columns.size() == 16;
    }
    EXPECT_LT(nets, 5);
}

TEST(Sampler, TwoBlocksAtOnceAreTheSameNumbers) {
    for (std::uint32_t i = 0; i < 1000; ++i) {
        const Sampler sampler(3, 17 * i, i);
        const auto both = sampler.blocks(i, 5 * i + 2);
        EXPECT_EQ(both[0], sampler.block(i));
        EXPECT_EQ(both[1], sampler.block(5 * i + 2));
    }
}

}  // namespace
}  // namespace glint
