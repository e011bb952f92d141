// T5: tori of every thickness, from inside to 1e4 major radii away, against quad precision; and
// rays that start on them.
#include <gtest/gtest.h>

#include "tests/support/hit_check.h"

namespace glint {
namespace {

using namespace test;
using TorusFull = FullRun;

Tally throwAtTori(std::uint64_t count, double ratio, double distance) {
    return checkHits(
        count, 5, [=](Random& random) { return randomInstance(random, CanonicalTorus{ratio}); },
        [=](Random& random) {
            // Aimed at the tube, so that thin ones are hit at all.
            const double phi = random.uniform(0, 2 * kPi),
                         r = 1 + 1.2 * ratio * random.uniform(-1, 1);
            const DVec3 from = distance * random.direction();
            return LocalRay{from, DVec3(r * std::cos(phi), 1.2 * ratio * random.uniform(-1, 1),
                                        r * std::sin(phi))};
        });
}

void expectTori(std::uint64_t count) {
    for (const double ratio : {1e-6, 0.02, 0.25, 0.5, 1.0, 1.7})
        for (const double distance : {1.0, 3.0, 1e2, 1e4}) {
            const Tally tally = throwAtTori(count, ratio, distance);
            tally.print("torus " + std::to_string(ratio) + " at " + std::to_string(distance));
            EXPECT_EQ(tally.failures, 0u) << tally.first;
        }
}

TEST(Torus, HitsAgreeWithQuadPrecision) { expectTori(400); }
TEST_F(TorusFull, HitsAgreeWithQuadPrecision) { expectTori(10'000'000 / 24 + 1); }

/// The crossings of a line, and the ray that starts at one of them.
Tally continueFromTori(std::uint64_t count, double ratio) {
    return tallyInParallel(count, 6, [=](Random& random, std::uint64_t n) {
        Tally tally;
        const CanonicalTorus torus{ratio};
        const ShapeInstance instance = makeInstance(torus, DMat3(1.0), DVec3(0.0));
        while (tally.checks < n) {
            const double phi = random.uniform(0, 2 * kPi);
            const double theta = random.uniform(-1, 1) * (ratio > 1 ? std::acos(-1 / ratio) : kPi),
                         r = 1 + ratio * std::cos(theta);
            const DVec3 at =
                torus.project({r * std::sin(phi), ratio * std::sin(theta), r * std::cos(phi)}, 0);
            const DVec3 direction = random.direction();
            const double cosine = glm::dot(direction, glm::normalize(torus.normal(at, 0)));
            // The start is off the surface by a rounding, which over the tube's radius is an angle.
            if (std::abs(cosine) < 1e-6 + 1e-14 / ratio) continue;
            ++tally.checks;
            const Crossing next =
                torus.first(at, direction, cosine > 0 ? Start::Leaving : Start::Entering);
            // The reference's first crossing behind the one that the ray starts on.
            const Line<long double> line{VecOf<long double>(at), VecOf<long double>(direction)};
            const auto roots = reference::crossings(torus, line);
            std::size_t self = roots.size();
            for (std::size_t k = cosine > 0 ? 1 : 0; k < roots.size(); k += 2)
                if (self == roots.size() || absolute(roots[k]) < absolute(roots[self])) self = k;
            const bool found = self + 1 < roots.size();
            const double exact = found ? static_cast<double>(roots[self + 1]) : kInfinity;
            if (next.found() == found &&
                (!found || std::abs(next.t - exact) <= 1e-7 * (1 + exact))) {
                if (found) tally.error(std::abs(next.t - exact));
                continue;
            }
            // Within the band of a tangent there may be one more pair of crossings or one less.
            const auto grown = reference::crossings(CanonicalTorus{ratio * (1 + 1e-6)}, line);
            const auto shrunk = reference::crossings(CanonicalTorus{ratio * (1 - 1e-6)}, line);
            if (grown.size() == shrunk.size())
                tally.fail(replay(instance, {at, direction, 0, cosine < 0}) +
                           " t=" + std::to_string(next.t) + " exact=" + std::to_string(exact));
        }
        return tally;
    });
}

void expectContinuations(std::uint64_t count) {
    for (const double ratio : {1e-6, 0.02, 0.25, 0.5, 0.99, 1.7}) {
        const Tally tally = continueFromTori(count, ratio);
        tally.print("rays from torus " + std::to_string(ratio));
        EXPECT_EQ(tally.failures, 0u) << tally.first;
    }
}

TEST(Torus, RaysFromItsSurfaceFindTheNextCrossing) { expectContinuations(600); }
TEST_F(TorusFull, RaysFromItsSurfaceFindTheNextCrossing) {
    expectContinuations(10'000'000 / 6 + 1);
}

TEST(Torus, ASpindleHasNoSurfaceWithin) {
    const CanonicalTorus apple{1.5};
    // Through the middle along the axis: in at the top dimple, out at the bottom one.
    const double dimple = std::sqrt(1.5 * 1.5 - 1);
    const Crossing in = apple.first({0, 4, 0}, {0, -1, 0}, Start::Elsewhere);
    EXPECT_NEAR(in.t, 4 - dimple, 1e-14);
    EXPECT_NEAR(apple.first({0, dimple, 0}, {0, -1, 0}, Start::Entering).t, 2 * dimple, 1e-14);
    EXPECT_TRUE(apple.inside({0, 0, 0}));
}

TEST(Torus, RaysFromItsAxisHit) {
    const CanonicalTorus torus{0.25}, apple{1.5};
    EXPECT_NEAR(torus.first({0, 0, 0}, {1, 0, 0}, Start::Elsewhere).t, 0.75, 1e-15);
    EXPECT_NEAR(apple.first({0, 0, 0}, {0, 0, 1}, Start::Elsewhere).t, 2.5, 1e-15);
    EXPECT_FALSE(torus.first({0, 0, 0}, {0, 1, 0}, Start::Elsewhere).found());
    // Level, from the dimple: 1.3^2 + (r - 1)^2 = 1.5^2.
    const double outwards = std::sqrt(1.5 * 1.5 - 1.3 * 1.3);
    EXPECT_NEAR(apple.first({0, 1.3, 0}, {1, 0, 0}, Start::Elsewhere).t, 1 - outwards, 1e-15);
    EXPECT_NEAR(apple.first({0, 1.3, 0}, {1, 0, 0}, Start::KnownOutside).t, 1 - outwards, 1e-15);
}

TEST(Torus, ATangentRayThatLeavesIsNotCaught) {
    const CanonicalTorus torus{0.25};
    EXPECT_FALSE(torus.first({1.25, 0, 0}, {0, 0, 1}, Start::Leaving).found());
    EXPECT_FALSE(torus.first({1.25, 0, 0}, {0, 1, 0}, Start::Leaving).found());
    // From the side of the hole it must still meet the far part of the tube.
    EXPECT_NEAR(torus.first({0.75, 0, 0}, {-1, 0, 0}, Start::Leaving).t, 1.5, 1e-15);
}

}  // namespace
}  // namespace glint
