// T12, T13, T14: the filtered lists give what shape after shape gives; nearest hit and any hit
// agree to the last bit; rays that are no rays miss.
#include <gtest/gtest.h>

#include "tests/support/world.h"

namespace glint {
namespace {

using namespace test;
using AnyHitFull = FullRun;

std::vector<ShapeInstance> randomShapes(Random& random, int count, double spread) {
    std::vector<ShapeInstance> out;
    for (int i = 0; i < count; ++i) {
        const CanonicalShape shape = oneOfEach()[random.next() % 8];
        if (std::holds_alternative<CanonicalPlane>(shape) && random.next() % 8) continue;
        const double size = random.logUniform(0.01, 2);
        const bool ball = random.next() % 2 == 0;
        out.push_back(makeInstance(shape, ball ? DMat3(size) : randomLinear(random) * size,
                                   random.inCube(spread)));
    }
    return out;
}

/// Shape after shape, without lists. Of equal hits the lower index wins.
ShapeHit bruteForce(const World& world, const Ray& ray, const MediaStack& media) {
    ShapeHit best;
    for (std::uint32_t i = 0; i < world.scene.shapes.size(); ++i)
        if (const Crossing c = hitShape(world.scene.shapes[i], i, ray, media); c.t < best.t)
            best = {c.t, i, c.face};
    return best;
}

/// The glass that a ray starts in: many planes of a random world hold its origin.
MediaStack mediaAround(const World& world, const DVec3& origin) {
    MediaStack media;
    for (std::uint32_t i = 0; i < world.scene.shapes.size(); ++i)
        if (world.scene.shapes[i].dielectric && world.scene.shapes[i].holds(origin)) media.cross(i);
    return media;
}

Tally askBothQuestions(std::uint64_t count, int shapes, bool dielectric) {
    return tallyInParallel(count, 13, [=](Random& random, std::uint64_t n) {
        Tally tally;
        World world({});
        Ray ray;
        MediaStack media;
        for (std::uint64_t i = 0; i < n; ++i) {
            if (i % 512 == 0) world = World(randomShapes(random, shapes, 4), dielectric);
            if (i % 8 == 0) {
                ray = {random.direction() * random.logUniform(6, 1e4), {}};
                ray.direction = glm::normalize(random.inCube(3) - ray.origin);
                media = mediaAround(world, ray.origin);
            }
            tally.checks += 3;
            const ShapeHit hit = world.scene.lists->closest(ray, media),
                           slow = bruteForce(world, ray, media);
            // A ball needs no matrix in the lists, so its t may differ by roundings of the numbers
            // that go into it.
            const double band = 1e-13 * (glm::length(ray.origin) + 10 + (hit.found() ? hit.t : 0));
            if (hit.found() != slow.found() || (hit.found() && std::abs(hit.t - slow.t) > band))
                tally.fail("lists differ from shape after shape: " +
                           replay(world.scene.shapes[slow.found() ? slow.shape : hit.shape], ray));
            if (!hit.found()) {
                if (world.scene.lists->occluded(ray, media, kInfinity, kNoShape))
                    tally.fail("occluded without a hit: " + replay(world.scene.shapes[0], ray));
                i |= 7;
                continue;
            }
            const ShapeInstance& shape = world.scene.shapes[hit.shape];
            // Workers take denormals for 0, so the next number above 0 is the smallest normal one.
            const double justBehind =
                std::max(std::nextafter(hit.t, kInfinity), std::numeric_limits<double>::min());
            if (!world.scene.lists->occluded(ray, media, justBehind, kNoShape))
                tally.fail("seen but not in the way: " + replay(shape, ray));
            // A boundary that is left may lie before the entry that was given for it, by roundings
            // (hitOrder).
            const double place =
                std::abs(ray.origin.x) + std::abs(ray.origin.y) + std::abs(ray.origin.z);
            const double justBefore = dielectric ? hit.t - 0x1p-47 * (hit.t + place) : hit.t;
            if (world.scene.lists->occluded(ray, media, justBefore, kNoShape))
                tally.fail("something nearer than the nearest: " + replay(shape, ray));
            const SurfacePoint point = world.point(ray, hit, media);
            const bool through = dielectric && random.next() % 2 == 0;
            Vec3 wi = randomUp(random);
            if (through == (point.wo.z > 0)) wi = -wi;
            if (through && shape.dielectric) media.cross(hit.shape);
            ray = point.ray(wi);
        }
        return tally;
    });
}

void expectAgreement(std::uint64_t count) {
    for (const int shapes : {1, 6, 30, 300})
        for (const bool dielectric : {false, true}) {
            const Tally tally = askBothQuestions(count, shapes, dielectric);
            tally.print(std::to_string(shapes) + (dielectric ? " glass shapes" : " opaque shapes"));
            EXPECT_EQ(tally.failures, 0u) << tally.first;
        }
}

TEST(AnyHit, ListsBruteForceAndShadowsAgree) { expectAgreement(10000); }
TEST_F(AnyHitFull, ListsBruteForceAndShadowsAgree) { expectAgreement(100'000'000 / 8); }

TEST(AnyHit, RaysThatAreNoRaysMiss) {
    Random random(17);
    const double nan = std::nan("");
    const double strange[] = {nan, kInfinity, -kInfinity, 0.0, -0.0, 1e-310, 5e-324, 1e308, -1e308};
    for (const int shapes : {1, 30, 300}) {
        const World world(randomShapes(random, shapes, 4));
        for (int i = 0; i < 2000; ++i) {
            Ray ray{random.inCube(5), random.direction()};
            (i % 2 ? ray.origin : ray.direction)[static_cast<int>(random.next() % 3)] =
                strange[random.next() % std::size(strange)];
            if (i % 16 == 0) ray.direction = DVec3(0.0);
            const ShapeHit hit = world.scene.lists->closest(ray, {});
            static_cast<void>(world.scene.lists->occluded(ray, {}, 1, kNoShape));
            if (!isFinite(ray.origin) || !isFinite(ray.direction) || ray.direction == DVec3(0.0)) {
                EXPECT_FALSE(hit.found()) << replay(world.scene.shapes[0], ray);
            }
            EXPECT_FALSE(std::isnan(hit.t));
        }
    }
}

}  // namespace
}  // namespace glint
