// T7: shapes that touch or nearly do. The sliver of sky beside a ball that rests on a floor has a
// closed form.
#include <gtest/gtest.h>

#include "tests/support/world.h"

namespace glint {
namespace {

using namespace test;
using ContactFull = FullRun;

/// Irradiance over pi from a uniform sky at distance x (in radii) from where a unit ball touches
/// the floor: the ball hides cos(theta) sin^2(alpha) = (1 + x^2)^(-3/2) of it.
double skyBesideABall(double x) { return -std::expm1(-1.5 * std::log1p(x * x)); }

/// The same by asking for every direction of a fine grid whether it is free. Free ones lie below an
/// elevation of 4 x.
double measuredSky(const World& world, const DVec3& at, double x, double scale, int side) {
    const double top = std::sin(std::min(4 * x, kPi / 2)), top2 = top * top;
    double free = 0;
    for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j) {
            // Uniform in sin^2 of the elevation: each cell has the same irradiance.
            const double sine = std::sqrt(top2 * (i + 0.5) / side),
                         cosine = std::sqrt(1 - sine * sine), phi = 2 * kPi * (j + 0.5) / side;
            const Ray ray{at, {cosine * std::cos(phi), sine, cosine * std::sin(phi)}, 0, false};
            free += world.scene.lists->occluded(ray, {}, 1e6 * scale, kNoShape) ? 0 : 1;
        }
    return free * top2 / (static_cast<double>(side) * side);
}

void expectContactShadow(int side) {
    Tally tally;  // Rays, and the largest error over the exact value.
    for (const double scale : {1e-6, 1.0, 1e6})
        for (const double x : {1e-5, 1e-3, 1e-1}) {
            const World world({makeInstance(CanonicalPlane{}, DMat3(1.0), DVec3(0.0)),
                               makeInstance(CanonicalSphere{}, DMat3(scale), {0, scale, 0})});
            const double exact = skyBesideABall(x),
                         measured = measuredSky(world, {x * scale, 0, 0}, x, scale, side);
            tally.checks += static_cast<std::uint64_t>(side) * static_cast<std::uint64_t>(side);
            tally.error(std::abs(measured - exact) / exact);
            EXPECT_NEAR(measured, exact, 0.01 * exact) << "at " << x << " radii, scale " << scale;
        }
    tally.print("sky beside a ball on a floor");
}

TEST(Contact, ShadowBesideABallOnAFloorIsExact) { expectContactShadow(300); }
TEST_F(ContactFull, ShadowBesideABallOnAFloorIsExact) { expectContactShadow(4000); }

/// Two balls a hair apart: a ray between them that should meet the second is never lost, and one
/// that leaves the first never meets anything but the second.
Tally crossGap(std::uint64_t count, double gap) {
    return tallyInParallel(count, 11, [=](Random& random, std::uint64_t n) {
        Tally tally;
        World world({});
        for (std::uint64_t i = 0; i < n; ++i) {
            if (i % 256 == 0) {
                const double size = random.logUniform(1e-3, 1e3);
                const DVec3 at = random.inCube(100 * size), axis = random.direction();
                world = World(
                    {makeInstance(CanonicalSphere{}, DMat3(size), at),
                     makeInstance(CanonicalSphere{}, DMat3(size), at + (2 + gap) * size * axis)});
            }
            const ShapeInstance &first = world.scene.shapes[0], &second = world.scene.shapes[1];
            const DVec3 axis = glm::normalize(second.center - first.center);
            const double size = first.worldFromLocal[0].x;
            // From a place near the contact, towards one near the contact on the other ball.
            const DVec3 from = first.center + size * glm::normalize(axis + 1e-3 * random.inCube(1));
            const DVec3 to = second.center - size * glm::normalize(axis + 1e-3 * random.inCube(1));
            Ray ray = rayTo(from, to);
            ray.fromShape = 0;
            // Both balls are met at clear angles: a ray along the tangent of either may pass by.
            if (glm::dot(ray.direction, from - first.center) < 1e-6 * size) continue;
            if (std::abs(glm::dot(ray.direction, to - second.center)) < 1e-6 * size) continue;
            ++tally.checks;
            if (world.scene.lists->closest(ray, {}).shape != 1) tally.fail(replay(second, ray));
        }
        return tally;
    });
}

void expectNoLeakThroughGaps(std::uint64_t count) {
    for (const double gap : {0.0, 1e-12, 1e-5, 1e-3}) {
        const Tally tally = crossGap(count, gap);
        tally.print("gap of " + std::to_string(gap) + " radii");
        EXPECT_EQ(tally.failures, 0u) << tally.first;
    }
}

TEST(Contact, NothingLeaksThroughTheGapBetweenBalls) { expectNoLeakThroughGaps(100000); }
TEST_F(ContactFull, NothingLeaksThroughTheGapBetweenBalls) { expectNoLeakThroughGaps(25'000'000); }

/// Three balls about one centre, 1e-12 of their radius apart. The outermost has the highest index,
/// so that no tie favours it.
World shells(bool glass) {
    std::vector<ShapeInstance> shapes;
    for (const double radius : {1 - 2e-12, 1 - 1e-12, 1.0})
        shapes.push_back(makeInstance(CanonicalSphere{}, DMat3(radius), {0.3, -0.2, 0.1}));
    return World(std::move(shapes), glass);
}

Tally lookAtShells(std::uint64_t count) {
    return tallyInParallel(count, 15, [=](Random& random, std::uint64_t n) {
        const World world = shells(false);
        const DVec3 center = world.scene.shapes[0].center;
        Tally tally;
        for (std::uint64_t i = 0; i < n; ++i) {
            const Ray outer = rayTo(center + random.logUniform(1.01, 100) * random.direction(),
                                    center + 0.999 * random.direction());
            const Ray inner = rayTo(center + random.uniform(0, 0.9) * random.direction(),
                                    center + random.direction());
            tally.checks += 2;
            if (world.scene.lists->closest(outer, {}).shape != 2)
                tally.fail("from outside: " + replay(world.scene.shapes[2], outer));
            if (world.scene.lists->closest(inner, {}).shape != 0)
                tally.fail("from inside: " + replay(world.scene.shapes[0], inner));
        }
        return tally;
    });
}

/// A straight way through shells of glass enters them from outside in, and leaves them from inside
/// out.
Tally crossShells(std::uint64_t count) {
    return tallyInParallel(count, 16, [=](Random& random, std::uint64_t n) {
        const World world = shells(true);
        const DVec3 center = world.scene.shapes[0].center;
        Tally tally;
        for (std::uint64_t i = 0; i < n; ++i) {
            Ray ray = rayTo(center + random.logUniform(1.01, 100) * random.direction(),
                            center + 0.999 * random.direction());
            MediaStack media;
            std::string order;
            for (int k = 0; k < 8; ++k) {
                const ShapeHit hit = world.scene.lists->closest(ray, media);
                if (!hit.found()) break;
                order += std::to_string(hit.shape);
                const SurfacePoint point = world.point(ray, hit, media);
                ray = {point.position, ray.direction, hit.shape, !media.contains(hit.shape)};
                media.cross(hit.shape);
            }
            ++tally.checks;
            if (order != "210012")
                tally.fail("order " + order + ": " + replay(world.scene.shapes[2], ray));
        }
        return tally;
    });
}

void expectShells(std::uint64_t count) {
    for (const Tally& tally : {lookAtShells(count), crossShells(count)}) {
        tally.print("shells 1e-12 apart");
        EXPECT_EQ(tally.failures, 0u) << tally.first;
    }
}

TEST(Contact, ConcentricShellsAHairApartKeepTheirOrder) { expectShells(50000); }
TEST_F(ContactFull, ConcentricShellsAHairApartKeepTheirOrder) { expectShells(10'000'000); }

}  // namespace
}  // namespace glint
