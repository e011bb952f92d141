// Chains over a ball: each one found is a path that Snell's law takes, none is missed, and their
// spread is that of the rays.
#include <gtest/gtest.h>

#include <random>

#include "tracer/math/ball_chain.h"
#include "tracer/math/frame.h"

namespace glint {
namespace {

/// A ray behind the unit ball.
struct Exit {
    DVec3 position, direction;
    bool found = false;
};

/// Follows a ray from outside over the unit ball with `chords` pieces inside, by the vector forms
/// of the laws.
Exit follow(const DVec3& origin, const DVec3& direction, double n, int chords) {
    const double along = -glm::dot(origin, direction);
    const DVec3 nearest = origin + along * direction;
    const double half2 = 1 - glm::dot(nearest, nearest);
    if (!(half2 > 0) || along < 0) return {};
    DVec3 p = nearest - std::sqrt(half2) * direction, d = direction;
    const auto refracted = [](const DVec3& v, const DVec3& normal, double eta) {
        const double c = -glm::dot(v, normal);
        return eta * v + (eta * c - std::sqrt(1 - eta * eta * (1 - c * c))) * normal;
    };
    if (chords == 0) return {p, d - 2 * glm::dot(d, p) * p, true};
    d = refracted(d, p, 1 / n);
    for (int i = 1;; ++i) {
        p = glm::normalize(p - 2 * glm::dot(p, d) * d);
        if (i == chords) return {p, refracted(d, -p, n), true};
        d = d - 2 * glm::dot(d, p) * p;
    }
}

struct Setting {
    DVec3 x, y;  ///< y: unit if far
    double n;
    int chords;
    bool far;
    ChainEnds ends;
    DVec3 toX, across;
};

Setting randomSetting(std::mt19937_64& random) {
    std::uniform_real_distribution<double> u(0, 1);
    const auto direction = [&] {
        const double z = 2 * u(random) - 1, turn = 2 * kPi * u(random), r = std::sqrt(1 - z * z);
        return DVec3(r * std::cos(turn), r * std::sin(turn), z);
    };
    const auto distance = [&] { return 1 + std::pow(10, 3 * u(random) - 2); };
    Setting s;
    s.far = u(random) < 0.3;
    s.x = distance() * direction();
    s.y = s.far ? direction() : distance() * direction();
    s.n = 1.05 + 1.5 * u(random);
    s.chords = static_cast<int>(3 * u(random));
    s.toX = glm::normalize(s.x);
    const DVec3 toY = glm::normalize(s.y), normal = glm::cross(s.toX, toY);
    s.ends = {1 / glm::length(s.x), s.far ? 0 : 1 / glm::length(s.y), glm::length(normal),
              glm::dot(s.toX, toY)};
    s.across = glm::cross(normal, s.toX) / s.ends.sine;
    return s;
}

DVec3 firstMeeting(const Setting& s, const BallChain& chain) {
    return std::cos(chain.side * chain.first) * s.toX +
           std::sin(chain.side * chain.first) * s.across;
}

/// Calls check(setting, chain, round) for every chain of 20 000 random settings.
template <class Check>
void forEachChain(std::uint64_t seed, const Check& check) {
    std::mt19937_64 random(seed);
    for (int round = 0; round < 20'000; ++round) {
        const Setting s = randomSetting(random);
        std::array<BallChain, kMaxBallChains> chains;
        const int count = findBallChains(s.ends, s.n, s.chords, chains);
        for (int i = 0; i < count; ++i) check(s, chains[static_cast<std::size_t>(i)], round);
    }
}

TEST(BallChain, EachIsAPathBySnellsLaw) {
    int found = 0;
    forEachChain(1, [&](const Setting& s, const BallChain& chain, int round) {
        if (chain.cosine < 1e-4) return;  // Tangent rays: the direct way loses its digits there.
        const Exit exit = follow(s.x, glm::normalize(firstMeeting(s, chain) - s.x), s.n, s.chords);
        ASSERT_TRUE(exit.found);
        const DVec3 wanted = s.far ? s.y : glm::normalize(s.y - exit.position);
        EXPECT_NEAR(glm::dot(exit.direction, wanted), 1, 1e-9)
            << "round " << round << " chords " << s.chords;
        ++found;
    });
    EXPECT_GT(found, 8000);
}

TEST(BallChain, NoneIsMissed) {
    std::mt19937_64 random(2);
    constexpr int kSteps = 4000;
    int counted = 0;
    for (int round = 0; round < 3000; ++round) {
        const Setting s = randomSetting(random);
        const double theta = std::atan2(s.ends.sine, s.ends.cosine);
        int scanned = 0;
        bool nearFold = false;
        for (const double side : {1.0, -1.0}) {
            if (s.chords == 0 && side < 0) continue;  // A reflection turns towards y.
            double before = 0;
            for (int k = 0; k <= kSteps; ++k) {
                const double i = kPi / 2 * k / kSteps, sine = std::sin(i);
                const double turn = s.chords * kPi + 2 * i - std::asin(s.ends.sx * sine) -
                                    std::asin(s.ends.sy * sine) -
                                    2 * s.chords * std::asin(sine / s.n);
                const double residual = std::remainder(turn - side * theta, 2 * kPi);
                if (k > 0 && std::abs(residual) < 1 && std::abs(before) < 1 &&
                    (residual > 0) != (before > 0))
                    ++scanned;
                if (std::abs(residual) < 2e-3)
                    nearFold =
                        nearFold || std::abs(residual - before) < 2e-6 || k == 0 || k == kSteps;
                before = residual;
            }
        }
        if (nearFold) continue;
        std::array<BallChain, kMaxBallChains> chains;
        EXPECT_EQ(findBallChains(s.ends, s.n, s.chords, chains), scanned)
            << "round " << round << " chords " << s.chords;
        counted += scanned;
    }
    EXPECT_GT(counted, 800);
}

TEST(BallChain, SpreadsAsNeighbouringRaysDo) {
    constexpr double kStep = 1e-6;
    int compared = 0;
    forEachChain(3, [&](const Setting& s, const BallChain& chain, int round) {
        const double spread = ballChainSpread(s.ends, s.n, s.chords, chain.sine, chain.cosine);
        if (chain.cosine < 0.02 || s.ends.sine < 0.02 || spread > 50)
            return;  // Differences lose their digits at edges and folds.
        const Frame frame(glm::normalize(firstMeeting(s, chain) - s.x));
        const auto endOf = [&](double a, double b) {
            const Exit exit =
                follow(s.x, glm::normalize(frame.toWorld(DVec3(a, b, 1.0))), s.n, s.chords);
            if (s.far) return exit.direction;
            const DVec3 wanted =
                glm::normalize(s.y - exit.position);  // To the plane through y across the light.
            return exit.position + glm::dot(s.y - exit.position, wanted) /
                                       glm::dot(exit.direction, wanted) * exit.direction;
        };
        const DVec3 da = (endOf(kStep, 0) - endOf(-kStep, 0)) / (2 * kStep),
                    db = (endOf(0, kStep) - endOf(0, -kStep)) / (2 * kStep);
        EXPECT_NEAR(spread * glm::length(glm::cross(da, db)), 1, 2e-3)
            << "round " << round << " chords " << s.chords;
        ++compared;
    });
    EXPECT_GT(compared, 5000);
}

}  // namespace
}  // namespace glint
