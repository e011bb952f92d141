// Choosing among lights: probabilities against frequencies.
#include <gtest/gtest.h>

#include <random>

#include "tracer/compile/light_choice.h"

namespace glint {
namespace {

constexpr int kDraws = 200'000;

std::vector<LightBounds> randomLights(std::size_t count, std::mt19937_64& random) {
    std::uniform_real_distribution<double> u(-1, 1);
    std::vector<LightBounds> lights;
    for (std::size_t i = 0; i < count; ++i)
        lights.push_back({{10 * u(random), 10 * u(random), 10 * u(random)}, i % 3 ? 0.1 : 0.0, std::exp(2 * u(random))});
    if (count > 4) lights[4].radius = kInfinity;  // A sun.
    return lights;
}

TEST(LightChoice, ProbabilitiesSumToOneAndAreThoseOfTheChoice) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> u(0, 1);
    for (const std::size_t count : {1, 2, 3, 5, 17, 100, 1000}) {
        const LightChoice choice(randomLights(count, random));
        const DVec3 from(u(random), u(random), u(random)), normal(0, 1, 0);
        double sum = 0;
        for (std::uint32_t i = 0; i < count; ++i) {
            const double p = choice.probability(from, normal, i);
            EXPECT_GT(p, 0) << "light " << i << " of " << count;
            sum += p;
        }
        EXPECT_NEAR(sum, 1, 1e-9) << count;
        std::vector<int> hits(count, 0);
        for (int i = 0; i < kDraws; ++i) {
            const auto chosen = choice.choose(from, normal, (i + u(random)) / kDraws);
            ASSERT_NEAR(chosen.probability, choice.probability(from, normal, chosen.light), 1e-12);
            ++hits[chosen.light];
        }
        // The draws are stratified: each light gets its share to a few strata for each time that its intervals begin or end.
        for (std::uint32_t i = 0; i < count; ++i)
            EXPECT_NEAR(hits[i], kDraws * choice.probability(from, normal, i), 4) << "light " << i << " of " << count;
    }
}

TEST(LightChoice, ALightWithoutPowerIsChosenOnlyAmongItsLike) {
    const LightChoice dark({{{0, 0, 0}, 0, 0}, {{1, 0, 0}, 0, 0}});
    EXPECT_GT(dark.probability({0, 2, 0}, {0, -1, 0}, 0), 0);
    const LightChoice mixed({{{0, 0, 0}, 0, 0}, {{1, 0, 0}, 0, 1}});
    for (const double u : {0.0, 0.3, 1 - 0x1p-24}) EXPECT_EQ(mixed.choose({0, 2, 0}, {0, -1, 0}, u).light, 1u);
}

}  // namespace
}  // namespace glint
