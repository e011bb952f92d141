// LightBuffer: shadow rays to any part of a light meet among the shapes of their cell what they
// meet among all, and most shapes are left out.
#include "tracer/compile/light_buffer.h"

#include <gtest/gtest.h>

#include "tests/support/rays.h"

namespace glint {
namespace {

using test::Random;

/// Balls and turned boxes in a cube of half the size `scale`, and a floor.
std::vector<ShapeInstance> makeField(std::size_t count, double scale, Random& random) {
    std::vector<ShapeInstance> out{
        test::makeInstance(CanonicalPlane{}, DMat3(1.0), {0, -1.2 * scale, 0})};
    while (out.size() < count) {
        CanonicalShape shape;
        DMat3 linear(scale * random.uniform(0.03, 0.2));
        if (out.size() % 2 == 0) {
            shape = CanonicalBox{};
            linear = rotationFromDegrees(random.inCube(180));
            for (int axis = 0; axis < 3; ++axis) linear[axis] *= scale * random.uniform(0.01, 0.3);
        }
        out.push_back(test::makeInstance(shape, linear, scale * random.inCube(1)));
    }
    return out;
}

struct Tally {
    std::size_t rays = 0, shadowed = 0, buffered = 0, kept = 0, of = 0;
};

/// Rays from points on the floor and anywhere to `towards(from)`: a direction and how far.
template <class Towards>
void compareRays(const std::vector<ShapeInstance>& shapes, const LightPlace& place, double scale,
                 const Towards& towards, Random& random, Tally& tally) {
    const ShapeLists lists(shapes);
    double reach = 0;
    for (std::size_t i = 1; i < shapes.size(); ++i)
        reach = std::max(reach, glm::length(glm::abs(shapes[i].center) + shapes[i].halfSize()));
    const LightBuffer buffer(place, lists, reach);
    WorkCounts work;
    for (int i = 0; i < 4000; ++i) {
        DVec3 from = scale * (random.uniform() < 0.1 ? 30.0 : 1.3) * random.inCube(1);
        if (i % 2 == 0) from.y = shapes[0].center.y;
        if (i % 16 == 1)
            from = place.infinitelyFar ? DVec3(0.0) : place.at + scale * DVec3(1, 1, -1);
        const auto [direction, distance] = towards(from);
        const Ray ray{from, direction, i % 2 == 0 ? 0u : kNoShape};
        const FewShapes* few = buffer.between(from);
        const bool shadowed = lists.occluded(ray, {}, distance, kNoShape, work);
        ++tally.rays;
        tally.shadowed += shadowed;
        if (!few) continue;
        ++tally.buffered;
        tally.kept += few->balls.size() + few->boxes.size();
        tally.of += shapes.size() - 1;
        ASSERT_EQ(lists.occluded(ray, {}, distance, kNoShape, work, few), shadowed)
            << shapes.size() << " shapes, scale " << scale << ", ray " << i;
        ASSERT_EQ(lists.closest(ray, {}, distance, work, few).shape,
                  lists.closest(ray, {}, distance, work).shape);
    }
}

void expectMuchLeftOut(const Tally& tally) {
    EXPECT_GT(tally.shadowed, tally.rays / 20);
    EXPECT_GT(tally.buffered, tally.rays / 2);
    EXPECT_LT(tally.kept, tally.of / 3);
}

TEST(LightBuffer, RaysToALampMeetAmongTheFewWhatTheyMeetAmongAll) {
    Random random(9);
    Tally tally;
    for (const std::size_t count : {12, 40, 129})
        for (const double scale : {1.0, 1e-6, 1e8})
            for (const double radius : {0.0, 0.02, 0.2})
                for (const DVec3& at : {DVec3(0.1, 2, 0.3), DVec3(0.0), DVec3(-40, 25, 3)}) {
                    const LightPlace place{false, scale * at, scale * radius};
                    compareRays(
                        makeField(count, scale, random), place, scale,
                        [&](const DVec3& from) {
                            const DVec3 to = place.at + place.radius * random.direction() - from;
                            return std::pair(glm::normalize(to), glm::length(to));
                        },
                        random, tally);
                }
    expectMuchLeftOut(tally);
}

TEST(LightBuffer, RaysToASunMeetAmongTheFewWhatTheyMeetAmongAll) {
    Random random(10);
    Tally tally;
    for (const std::size_t count : {12, 40, 129})
        for (const double scale : {1.0, 1e-6, 1e8})
            for (const double tangent : {0.0, 0.0047, 0.05})
                for (const DVec3& towards :
                     {DVec3(0, 1, 0), DVec3(0.9, 0.1, -0.3), DVec3(0, 0, -1)}) {
                    const LightPlace place{true, glm::normalize(towards), tangent};
                    compareRays(
                        makeField(count, scale, random), place, scale,
                        [&](const DVec3&) {
                            const DVec3 aside = glm::cross(place.at, random.direction());
                            return std::pair(glm::normalize(place.at + tangent * aside), kInfinity);
                        },
                        random, tally);
                }
    expectMuchLeftOut(tally);
}

}  // namespace
}  // namespace glint
