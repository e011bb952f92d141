// T8: no ray gets out of a closed opaque shape, and none out of glass without crossing its surface.
#include <gtest/gtest.h>

#include "tests/support/world.h"

namespace glint {
namespace {

using namespace test;
using LeaksFull = FullRun;

/// A point inside the canonical shape.
DVec3 innerPoint(Random& random, const CanonicalShape& shape) {
    while (true) {
        const DVec3 p = random.inCube(1.3);
        if (std::visit([&](const auto& s) { return s.inside(p); }, shape)) return p;
    }
}

/// The next ray of a path inside: at random, or aimed exactly at an edge, a rim or the apex.
Ray next(Random& random, const World& world, const SurfacePoint& point) {
    const ShapeInstance& wall = world.scene.shapes[0];
    if (random.next() % 4 == 0) {
        Ray ray =
            rayTo(point.position, wall.center + wall.worldFromLocal * rimPoint(random, wall.shape));
        ray.fromShape = point.shape;
        ray.fromInside = true;
        if (glm::dot(ray.direction, point.frame.n) < 0) return ray;
    }
    return point.ray(-randomUp(random));
}

/// A path that bounces about inside a closed shape, and from each place looks for a light outside.
Tally bounceInside(std::uint64_t count, const CanonicalShape& shape) {
    return tallyInParallel(count, 9, [=](Random& random, std::uint64_t n) {
        Tally tally;
        World world({});
        DVec3 light{0};
        Ray ray;
        for (std::uint64_t i = 0; i < n; ++i) {
            if (i % 64 == 0) {
                const double size = random.logUniform(1e-4, 1e6);
                world = World(
                    {makeInstance(shape, randomLinear(random) * size, random.inCube(1000 * size))});
                const ShapeInstance& wall = world.scene.shapes[0];
                light = wall.center +
                        wall.worldFromLocal * (random.uniform(2, 1000) * random.direction());
                ray = {wall.center + wall.worldFromLocal * innerPoint(random, shape),
                       random.direction()};
            }
            tally.checks += 2;
            const ShapeHit hit = world.scene.lists->closest(ray, {});
            if (!hit.found()) {
                tally.fail(replay(world.scene.shapes[0], ray));
                i |= 63;
                continue;
            }
            const SurfacePoint point = world.point(ray, hit);
            const DVec3 to = light - point.position;
            const Vec3 wi = toFloat(point.frame.toLocal(glm::normalize(to)));
            const Ray shadow{point.position, glm::normalize(to), point.shape, wi.z < 0};
            // Only directions into the shape are asked for: a wall that is turned away is dark
            // without a shadow ray.
            if (wi.z < 0 && !world.scene.lists->occluded(shadow, {}, glm::length(to), kNoShape))
                tally.fail(replay(world.scene.shapes[0], shadow));
            ray = next(random, world, point);
        }
        return tally;
    });
}

void expectNoLeaks(std::uint64_t count) {
    for (const CanonicalShape& shape : oneOfEach()) {
        if (!isClosed(shape) || std::holds_alternative<CanonicalPlane>(shape)) continue;
        const Tally tally = bounceInside(count, shape);
        tally.print(std::string("inside ") + nameOf(shape));
        EXPECT_EQ(tally.failures, 0u) << tally.first;
    }
}

TEST(Leaks, NoRayGetsOutOfAClosedShape) { expectNoLeaks(60000); }
TEST_F(LeaksFull, NoRayGetsOutOfAClosedShape) { expectNoLeaks(1'000'000'000 / 10); }

/// Paths through a cluster of glass shapes that overlap, touch and coincide. Inside and outside are
/// tracked; the tracking must agree with geometry in the middle of every long enough stretch.
Tally crossGlass(std::uint64_t count) {
    return tallyInParallel(count, 10, [=](Random& random, std::uint64_t n) {
        Tally tally;
        const DMat3 one(1.0);
        const World world(
            {
                makeInstance(CanonicalBox{}, one, {0, 0, 0}),
                makeInstance(CanonicalBox{}, one, {0, 2, 0}),  // stacked
                makeInstance(CanonicalSphere{}, one, {0, 4, 0}),
                makeInstance(CanonicalSphere{}, one, {0, 4, 0}),  // the same ball twice
                makeInstance(CanonicalSphere{}, one, {2, 0.1, 0}),
                makeInstance(CanonicalCylinder{}, one, {-2, 0.3, 0}),  // touching
                makeInstance(CanonicalCone{}, one, {0.3, 0.7, 0.4}),
                makeInstance(CanonicalTorus{0.5}, one, {0, 0.5, 0}),          // overlapping
                makeInstance(CanonicalCylinder{}, DMat3(0.7), {-2, 0.3, 0}),  // nested
            },
            true);
        for (std::uint64_t i = 0; i < n; ++i) {
            Ray ray{8.0 * random.direction() + DVec3(0, 2, 0), {}};
            ray.direction =
                glm::normalize(random.inCube(1.5) + DVec3(0, random.uniform(0, 4), 0) - ray.origin);
            MediaStack media;
            for (int k = 0; k < 40; ++k) {
                const ShapeHit hit = world.scene.lists->closest(ray, media);
                if (!hit.found()) {
                    ++tally.checks;
                    if (!media.empty())
                        tally.fail("left the scene inside of glass: " +
                                   replay(world.scene.shapes[media[0]], ray));
                    break;
                }
                if (hit.t > 1e-6) {
                    const DVec3 middle = ray.at(hit.t / 2);
                    for (std::uint32_t s = 0; s < world.scene.shapes.size(); ++s) {
                        ++tally.checks;
                        const ShapeInstance& shape = world.scene.shapes[s];
                        const auto inside = [&](double grow) {
                            const DVec3 p = (1 - grow) * shape.localPoint(middle);
                            return std::visit([&](const auto& c) { return c.inside(p); },
                                              shape.shape);
                        };
                        if (inside(1e-9) == inside(-1e-9) && inside(0) != media.contains(s))
                            tally.fail("tracked wrongly: " + replay(shape, ray));
                    }
                }
                const SurfacePoint point = world.point(ray, hit, media);
                // Any turn will do: through or back, straight or scattered.
                Vec3 wi = randomUp(random);
                const bool through = random.next() % 2 == 0;
                if (through != (point.wo.z < 0)) wi = -wi;
                if (through) media.cross(hit.shape);
                ray = point.ray(wi);
            }
        }
        return tally;
    });
}

void expectTracking(std::uint64_t count) {
    const Tally tally = crossGlass(count);
    tally.print("glass, touching and coincident");
    EXPECT_EQ(tally.failures, 0u) << tally.first;
}

TEST(Leaks, InsideAndOutsideOfGlassNeverFlip) { expectTracking(100000); }
TEST_F(LeaksFull, InsideAndOutsideOfGlassNeverFlip) { expectTracking(2'000'000); }

}  // namespace
}  // namespace glint
