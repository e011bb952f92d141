// T1, T2: balls against quad precision, from the surface itself to a million radii away, through
// the middle and grazing.
#include <gtest/gtest.h>

#include "tests/support/hit_check.h"

namespace glint {
namespace {

using namespace test;
using SphereFull = FullRun;

/// Rays from `distance` radii away that pass the centre at b radii, b uniform in [low, high].
Tally throwAtBalls(std::uint64_t count, double distance, double low, double high) {
    return tallyInParallel(count, 1, [=](Random& random, std::uint64_t n) {
        Tally tally;
        ShapeInstance ball;
        ShapeLists lists;
        for (std::uint64_t i = 0; i < n; ++i) {
            if (i % 64 == 0) {
                const double radius = random.logUniform(1e-3, 1e3);
                ball = makeInstance(CanonicalSphere{}, DMat3(radius), random.inCube(10 * radius));
                lists = ShapeLists({ball});
            }
            const double radius = ball.worldFromLocal[0].x;
            const DVec3 away = random.direction(),
                        side = glm::normalize(glm::cross(away, random.direction()));
            // The line at angle asin(b / distance) from the centre passes it at b.
            const double sine = std::min(1.0, random.uniform(low, high) / distance),
                         cosine = std::sqrt(1 - sine * sine);
            checkHit(ball, lists,
                     {ball.center + distance * radius * away,
                      glm::normalize(sine * side - cosine * away)},
                     tally);
        }
        return tally;
    });
}

void expectBalls(std::uint64_t count) {
    for (const double distance : {1.0001, 1.01, 1.5, 3.0, 1e2, 1e4, 1e6}) {
        const Tally tally = throwAtBalls(count, distance, 0, 0.99);
        tally.print("ball at " + std::to_string(distance) + " radii");
        EXPECT_EQ(tally.failures, 0u) << tally.first;
        EXPECT_LE(tally.worst, 1);
    }
}
void expectGrazing(std::uint64_t count) {
    for (const double distance : {1.01, 1.5, 3.0, 1e2, 1e4, 1e6}) {
        const Tally tally = throwAtBalls(count, distance, 0.999, 1.00001);
        tally.print("grazing at " + std::to_string(distance) + " radii");
        EXPECT_EQ(tally.failures, 0u) << tally.first;
    }
}

TEST(Sphere, HitsAgreeWithQuadPrecisionAtEveryDistance) { expectBalls(20000); }
TEST(Sphere, GrazingHitsAgreeWithQuadPrecision) { expectGrazing(20000); }
TEST_F(SphereFull, HitsAgreeWithQuadPrecisionAtEveryDistance) { expectBalls(100'000'000 / 7 + 1); }
TEST_F(SphereFull, GrazingHitsAgreeWithQuadPrecision) { expectGrazing(100'000'000 / 6 + 1); }

TEST(Sphere, FrontHitComesBeforeInsideHit) {
    const CanonicalSphere sphere;
    EXPECT_EQ(sphere.first({0, 0, 3}, {0, 0, -1}, Start::Elsewhere).t, 2);
    EXPECT_EQ(sphere.first({0, 0, 0}, {0, 0, -1}, Start::Elsewhere).t, 1);
    EXPECT_FALSE(sphere.first({0, 0, 3}, {0, 0, 1}, Start::Elsewhere).found());
}

/// The check itself must be able to fail: it refuses the discriminant b^2 - 4 a c in float.
TEST(Sphere, CheckRefusesABallThatIsAHairTooLarge) {
    const ShapeInstance ball = makeInstance(CanonicalSphere{}, DMat3(1.0), DVec3(0.0));
    const ShapeLists larger({makeInstance(CanonicalSphere{}, DMat3(1 + 4e-7), DVec3(0.0))});
    Tally tally;
    checkHit(ball, larger, {{0, 0, 3}, {0, 0, -1}}, tally);
    EXPECT_EQ(tally.failures, 1u);
}

}  // namespace
}  // namespace glint
