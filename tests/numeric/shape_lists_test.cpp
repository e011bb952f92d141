// ShapeLists against the plain loop in double (support/scalar_lists.h): the same hit to the last
// bit for every ray, every number of shapes and every instruction set, however shapes lie and
// wherever rays start.
#include "tracer/compile/shape_lists.h"

#include <gtest/gtest.h>

#include <hwy/highway.h>
#include <algorithm>
#include <atomic>
#include <mutex>
#include <random>

#include "tests/support/rays.h"
#include "tests/support/scalar_lists.h"
#include "tracer/math/transform.h"
#include "tracer/math/warp.h"

namespace glint {
namespace {

using ShapeListsFull = test::FullRun;

/// What a scene of random shapes looks like.
struct SceneKind {
    const char* name;
    bool ballsOnly = false;
    double spread = 10;  ///< half the size of the cube that centres are in [m]; 0: all at one point
    double leastSize = 0.1, mostSize = 2;
    DVec3 at{0.0};     ///< the cube's centre
    double stray = 0;  ///< share of shapes that are 1e6 times as large and as far away
};
const SceneKind kKinds[] = {
    {"usual"},
    {.name = "balls", .ballsOnly = true},
    {.name = "concentric", .spread = 0},
    {.name = "tiny", .spread = 1e-6, .leastSize = 1e-9, .mostSize = 1e-6},
    {.name = "huge", .spread = 1e9, .leastSize = 1e3, .mostSize = 3e8},
    {.name = "far", .at = DVec3(1e9, -3e8, 2e7)},
    {.name = "planets", .leastSize = 1e-2, .stray = 0.1},
    {.name = "crowded", .spread = 1, .leastSize = 0.5, .mostSize = 3},
};

class Random {
  public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}
    double operator()(double from, double to) {
        return std::uniform_real_distribution<double>(from, to)(engine_);
    }
    std::size_t below(std::size_t n) {
        return std::uniform_int_distribution<std::size_t>(0, n - 1)(engine_);
    }
    bool chance(double p) { return (*this)(0, 1) < p; }
    DVec3 cube(double half) {
        return {(*this)(-half, half), (*this)(-half, half), (*this)(-half, half)};
    }
    DVec3 direction() { return uniformSphere({(*this)(0, 1), (*this)(0, 1)}); }

  private:
    std::mt19937_64 engine_;
};

/// Turned, stretched unevenly by up to 1:20, sheared, mirrored - or none of it.
DMat3 randomLinear(Random& random, double size) {
    DMat3 linear = random.chance(0.3)
                       ? DMat3(1.0)
                       : rotationFromDegrees({random(0, 360), random(0, 360), random(0, 360)});
    if (random.chance(0.4)) return linear * size;
    if (random.chance(0.3))
        linear = linear * DMat3(DVec3(1, 0, 0), DVec3(random(-2, 2), 1, 0),
                                DVec3(random(-2, 2), random(-2, 2), 1));
    for (int axis = 0; axis < 3; ++axis)
        linear[axis] *= size * std::pow(20, random(-0.5, 0.5)) * (random.chance(0.2) ? -1 : 1);
    return linear;
}

CanonicalShape randomShape(Random& random) {
    switch (random.below(random.chance(0.1) ? 8 : 7)) {
        case 0:
            return CanonicalSphere{};
        case 1:
            return CanonicalBox{};
        case 2:
            return CanonicalQuad{};
        case 3:
            return CanonicalDisk{};
        case 4:
            return CanonicalCylinder{};
        case 5:
            return CanonicalCone{};
        case 6:
            return CanonicalTorus{random(0.02, 1.3)};
        default:
            return CanonicalPlane{};
    }
}

std::vector<ShapeInstance> makeShapes(const SceneKind& kind, std::size_t count, Random& random) {
    std::vector<ShapeInstance> shapes;
    while (shapes.size() < count) {
        const double scale = random.chance(kind.stray) ? 1e6 : 1;
        const double size =
            scale * kind.leastSize * std::pow(kind.mostSize / kind.leastSize, random(0, 1));
        const DMat3 linear = kind.ballsOnly ? DMat3(size) : randomLinear(random, size);
        const auto inverted = inverse(Affine{linear, DVec3(0.0)});
        if (!inverted) continue;
        ShapeInstance shape;
        shape.shape = kind.ballsOnly ? CanonicalSphere{} : randomShape(random);
        shape.worldFromLocal = linear;
        shape.localFromWorld = inverted->linear;
        shape.center = kind.at + random.cube(kind.spread * scale);
        if (!shapes.empty() && random.chance(0.05)) shape.center = shapes.back().center;
        shape.dielectric = random.chance(0.3);
        shapes.push_back(shape);
        if (random.chance(0.02) && shapes.size() < count) shapes.push_back(shape);  // Ties.
    }
    return shapes;
}

struct Query {
    Ray ray;
    MediaStack media;
    double tMax = kInfinity;
    std::uint32_t ignored = kNoShape;
};

DVec3 along(Random& random, const DVec3& from, const DVec3& to) {
    const double length = glm::length(to - from);
    return length > 0 ? (to - from) / length : random.direction();
}

/// At random, at a shape's surface, along its rim, or parallel to axes; from within the scene or
/// far away.
Query randomQuery(const SceneKind& kind, const std::vector<ShapeInstance>& shapes, Random& random) {
    Query q;
    const double around = std::max(kind.spread, kind.mostSize);
    q.ray.origin =
        kind.at + random.cube(around * (random.chance(0.2) ? std::pow(10, random(0, 5)) : 1.2));
    const ShapeInstance& target = shapes[random.below(shapes.size())];
    const DVec3 onUnitSphere = random.direction();
    const DVec3 inCube = random.chance(0.5) ? onUnitSphere : glm::round(random.cube(1.5));
    q.ray.direction = random.chance(0.3) ? random.direction()
                                         : along(random, q.ray.origin,
                                                 target.center + target.worldFromLocal * inCube);
    if (random.chance(0.1)) {  // Tangent to the unit sphere in local space.
        const DVec3 o = target.localPoint(q.ray.origin), across = glm::cross(o, onUnitSphere);
        const double far2 = glm::dot(o, o);
        if (far2 > 1 && glm::length(across) > 0) {
            const DVec3 touching = o / far2 + glm::normalize(across) * std::sqrt(1 - 1 / far2);
            q.ray.direction = glm::normalize(target.worldFromLocal * (touching - o));
        }
    }
    if (random.chance(0.15)) {
        const int axis = static_cast<int>(random.below(3));
        q.ray.direction[axis] = random.chance(0.5) ? 0.0 : -0.0;
        if (random.chance(0.5)) q.ray.direction[(axis + 1) % 3] = 0;
        q.ray.direction = along(random, DVec3(0.0), q.ray.direction);
        if (random.chance(0.5))
            q.ray.origin[axis] =
                target.center[axis] + random(-1, 1) * glm::length(target.worldFromLocal[axis]);
    }
    for (std::size_t i = random.chance(0.3) ? random.below(5) : 0; i > 0; --i)
        q.media.cross(static_cast<std::uint32_t>(random.below(shapes.size())));
    if (random.chance(0.4)) q.tMax = around * std::pow(10, random(-2, 1));
    if (random.chance(0.3)) q.ignored = static_cast<std::uint32_t>(random.below(shapes.size()));
    return q;
}

/// Goes on from a hit: on its surface, to either side.
void startAtHit(Query& q, const ShapeHit& hit, Random& random) {
    q.ray.origin = q.ray.at(hit.t);
    q.ray.fromShape = hit.shape;
    q.ray.fromInside = random.chance(0.5);
    if (random.chance(0.5)) q.ray.direction = random.direction();
}

/// Lists of the same shapes for each instruction set.
struct Subject {
    const char* name;
    ShapeLists lists;
};
template <class MakeLists>
std::vector<Subject> subjectsOf(const MakeLists& makeLists) {
    static std::mutex oneChoiceAtATime;  // Highway's choice is the whole program's.
    const std::scoped_lock lock(oneChoiceAtATime);
    std::vector<Subject> out;
    for (const std::int64_t target : {HWY_SSE4, HWY_AVX2}) {
        hwy::SetSupportedTargetsForTest(0);
        if ((hwy::SupportedTargets() & target) == 0) continue;
        hwy::SetSupportedTargetsForTest(target);
        EXPECT_STREQ(blockKernels<Coordinates::Pairs>().name, hwy::TargetName(target));
        out.push_back({hwy::TargetName(target), makeLists()});
    }
    hwy::SetSupportedTargetsForTest(0);
    return out;
}
std::vector<Subject> makeSubjects(const std::vector<ShapeInstance>& shapes) {
    return subjectsOf([&] { return ShapeLists(shapes); });
}

std::string describe(const ShapeHit& hit) {
    char text[96];
    std::snprintf(text, sizeof text, "t %.17g shape %u face %d", hit.t, hit.shape, hit.face);
    return text;
}

/// Compares all answers; false at the first that differs.
bool compareQuery(const Query& q, const test::ScalarLists& model, const ShapeHit& expected,
                  const std::vector<Subject>& subjects, const std::string& replay) {
    const bool shadowed = model.occluded(q.ray, q.media, q.tMax, q.ignored);
    for (const Subject& subject : subjects) {
        const ShapeHit hit = subject.lists.closest(q.ray, q.media, q.tMax);
        const bool same = (hit.t == expected.t || (std::isnan(hit.t) && std::isnan(expected.t))) &&
                          hit.shape == expected.shape && hit.face == expected.face;
        EXPECT_TRUE(same) << replay << " " << subject.name << ": " << describe(hit)
                          << " instead of " << describe(expected);
        const bool hidden = subject.lists.occluded(q.ray, q.media, q.tMax, q.ignored);
        EXPECT_EQ(hidden, shadowed) << replay << " " << subject.name << ": occlusion";
        if (!same || hidden != shadowed) return false;
    }
    return true;
}

/// `rays` queries; false at the first answer that differs.
bool compareQueries(const SceneKind& kind, const std::vector<ShapeInstance>& shapes,
                    const std::vector<Subject>& subjects, std::size_t rays, Random& random,
                    const std::string& what) {
    const test::ScalarLists model(shapes);
    std::size_t hits = 0;
    Query q;
    ShapeHit last;
    for (std::size_t i = 0; i < rays; ++i) {
        if (last.found() && random.chance(0.5))
            startAtHit(q, last, random);
        else
            q = randomQuery(kind, shapes, random);
        last = model.closest(q.ray, q.media, q.tMax);
        hits += last.found() ? 1 : 0;
        if (!compareQuery(q, model, last, subjects, what + ", ray " + std::to_string(i)))
            return false;
    }
    EXPECT_GT(hits, rays / 20) << kind.name << ": too few hits to mean anything";
    return true;
}

/// Every kind of scene with `count` shapes, `rays` queries each.
void compareScenes(std::size_t count, std::size_t rays, std::uint64_t seed) {
    for (const SceneKind& kind : kKinds) {
        Random random(seed * 1000 + count);
        const std::vector<ShapeInstance> shapes = makeShapes(kind, count, random);
        const std::string what = std::string(kind.name) + ", " + std::to_string(count) +
                                 " shapes, seed " + std::to_string(seed);
        if (!compareQueries(kind, shapes, makeSubjects(shapes), rays, random, what)) return;
    }
}

TEST(ShapeLists, FlatListsAnswerAsTheLoop) {
    for (const std::size_t count : {1u, 2u, 4u, 7u, 8u, 9u, 16u, 40u})
        compareScenes(count, 15000, count);
    for (const std::size_t count : {64u, 65u, 100u, 128u}) compareScenes(count, 4000, count);
}

TEST(ShapeLists, HierarchiesAnswerAsTheLoop) {
    compareScenes(129, 8000, 1);
    compareScenes(300, 4000, 2);
    compareScenes(3000, 400, 3);
    compareScenes(30000, 20, 4);
}

/// Walks of trees of that size look ahead.
TEST(ShapeLists, HierarchiesBeyondTheCacheAnswerAsTheLoop) {
    const SceneKind kinds[] = {
        {.name = "balls", .ballsOnly = true},
        {.name = "far balls", .ballsOnly = true, .at = DVec3(1e9, -3e8, 2e7)},
    };
    for (const SceneKind& kind : kinds) {
        Random random(5);
        const std::vector<ShapeInstance> shapes = makeShapes(kind, 600000, random);
        const std::vector<Subject> subjects = makeSubjects(shapes);
        for (const Subject& s : subjects)
            EXPECT_GT(s.lists.blockCounts().total() / kBlockSize, kCachedNodes) << kind.name;
        if (!compareQueries(kind, shapes, subjects, 20, random, kind.name)) return;
    }
}

/// One shape is dragged, step by step; then all move.
TEST(ShapeLists, RefittedHierarchiesAnswerAsTheLoop) {
    for (const SceneKind& kind : kKinds) {
        Random random(11);
        std::vector<ShapeInstance> shapes = makeShapes(kind, 500, random);
        ShapeLists lists(shapes);
        int refitted = 0;
        for (int step = 0; step < 8; ++step) {
            const std::vector<ShapeInstance> before = shapes;
            const auto move = [&](ShapeInstance& shape) {
                shape.center += random.cube(0.1 * kind.spread + 0.5 * kind.leastSize);
            };
            if (step < 4)
                move(shapes[77]);
            else
                std::for_each(shapes.begin(), shapes.end(), move);
            const std::string what = std::string(kind.name) + ", step " + std::to_string(step);
            const auto movedLists = [&] { return lists.moved(before, shapes); };
            refitted += movedLists() ? 1 : 0;
            const auto subjects = subjectsOf([&] {
                auto moved = movedLists();
                return moved ? std::move(*moved) : ShapeLists(shapes);
            });
            if (!compareQueries(kind, shapes, subjects, 600, random, what)) return;
            lists = subjects.back().lists;
        }
        EXPECT_GE(refitted, 2) << kind.name;
    }
}

/// Boxes are made from shapes and from boxes below; rounding outwards may not add up.
TEST(ShapeLists, BoxesDoNotGrowWhenAShapeMovesToAndFro) {
    Random random(13);
    const std::vector<ShapeInstance> shapes = makeShapes(kKinds[0], 300, random);
    std::vector<ShapeInstance> aside = shapes;
    aside[77].center.x += 0.5 * kKinds[0].leastSize;
    ShapeLists lists(shapes);
    for (int step = 0; step < 2000; ++step) {
        std::optional<ShapeLists> moved =
            step % 2 == 0 ? lists.moved(shapes, aside) : lists.moved(aside, shapes);
        ASSERT_TRUE(moved) << step;
        lists = std::move(*moved);
    }
}

TEST(ShapeLists, OtherShapesGetAHierarchyOfTheirOwn) {
    Random random(12);
    const std::vector<ShapeInstance> shapes = makeShapes(kKinds[0], 300, random);
    const ShapeLists lists(shapes);
    const auto refitted = [&](const std::vector<ShapeInstance>& next) {
        return lists.moved(shapes, next).has_value();
    };
    EXPECT_TRUE(refitted(shapes));
    std::vector<ShapeInstance> fewer(shapes.begin(), shapes.end() - 1), turned = shapes;
    EXPECT_FALSE(refitted(fewer));
    for (ShapeInstance& shape : turned)
        shape.shape = std::holds_alternative<CanonicalBox>(shape.shape)
                          ? CanonicalShape(CanonicalPlane{})
                          : shape.shape;
    EXPECT_FALSE(refitted(turned)) << "a box has become a plane";
    std::vector<ShapeInstance> scattered = shapes;
    for (ShapeInstance& shape : scattered) shape.center = random.cube(kKinds[0].spread);
    EXPECT_FALSE(refitted(scattered)) << "boxes grow too much";
}

TEST_F(ShapeListsFull, AnswerAsTheLoopForAHundredMillionRays) {
    constexpr std::size_t kRays = 12500;
    const test::Tally tally =
        test::tallyInParallel(1000 * 4096, 0, [](test::Random&, std::uint64_t) {
            static std::atomic<std::uint64_t> nextSeed{100};  // Relaxed: only its value counts.
            const std::uint64_t seed = nextSeed.fetch_add(1, std::memory_order_relaxed);
            compareScenes(seed % 50 == 0 ? 129 + seed / 50 : 2 + seed % 60, kRays, seed);
            test::Tally done;
            done.checks = kRays * std::size(kKinds);
            return done;
        });
    test::Tally all = tally;
    all.failures = HasFailure() ? 1 : 0;
    all.print("SSE4 and AVX2 against the scalar loop");
}

TEST(ShapeLists, RaysThatAreNotFiniteMissAsInTheLoop) {
    Random random(5);
    for (const std::size_t count : {3u, 30u, 300u}) {
        const std::vector<ShapeInstance> shapes = makeShapes(kKinds[0], count, random);
        const test::ScalarLists model(shapes);
        const std::vector<Subject> subjects = makeSubjects(shapes);
        const double odd[] = {0.0,   std::nan(""), kInfinity, -kInfinity, 1e-310,
                              1e200, 1e30,         -1e30,     1e-30};
        for (int i = 0; i < 20000; ++i) {
            Query q = randomQuery(kKinds[0], shapes, random);
            (random.chance(0.5) ? q.ray.origin
                                : q.ray.direction)[static_cast<int>(random.below(3))] =
                odd[random.below(std::size(odd))];
            if (random.chance(0.1)) q.ray.direction = DVec3(odd[random.below(std::size(odd))]);
            if (random.chance(0.1)) q.tMax = odd[random.below(std::size(odd))];
            const ShapeHit expected = model.closest(q.ray, q.media, q.tMax);
            if (!compareQuery(q, model, expected, subjects, "ray " + std::to_string(i))) return;
        }
    }
}

TEST(ShapeLists, DirectionsNeedNotHaveUnitLength) {
    Random random(6);
    for (const std::size_t count : {30u, 300u}) {
        const std::vector<ShapeInstance> shapes = makeShapes(kKinds[0], count, random);
        const test::ScalarLists model(shapes);
        const std::vector<Subject> subjects = makeSubjects(shapes);
        for (int i = 0; i < 10000; ++i) {
            Query q = randomQuery(kKinds[0], shapes, random);
            q.ray.direction *= std::pow(10, random(-20, 20));
            const ShapeHit expected = model.closest(q.ray, q.media, q.tMax);
            if (!compareQuery(q, model, expected, subjects, "ray " + std::to_string(i))) return;
        }
    }
}

TEST(ShapeLists, AnEmptySceneIsMissed) {
    const ShapeLists lists{std::vector<ShapeInstance>{}};
    EXPECT_FALSE(lists.closest({}, {}).found());
    EXPECT_FALSE(lists.occluded({}, {}, kInfinity, kNoShape));
    EXPECT_FALSE(ShapeLists{}.closest({}, {}).found());
}

TEST(ShapeLists, AHitAtTheLimitIsNone) {
    ShapeInstance ball;
    ball.shape = CanonicalSphere{};
    ball.center = {0, 0, -3};
    for (const std::size_t count : {1u, 20u, 200u}) {
        const ShapeLists lists(std::vector<ShapeInstance>(count, ball));
        EXPECT_FALSE(lists.closest({}, {}, 2.0).found());
        EXPECT_FALSE(lists.occluded({}, {}, 2.0, kNoShape));
        // Of copies the last lies on top.
        EXPECT_EQ(lists.closest({}, {}, std::nextafter(2.0, 3.0)).shape, count - 1);
        EXPECT_TRUE(lists.occluded({}, {}, std::nextafter(2.0, 3.0), kNoShape));
    }
}

TEST(ShapeLists, TheHierarchyTakesAtMost64BytesAShapeAndWithItABall) {
    Random random(7);
    for (const SceneKind& kind : kKinds) {
        const std::size_t count = 20000;
        const ShapeLists lists(makeShapes(kind, count, random));
        const auto [hierarchy, shapes] = lists.memory();
        EXPECT_LE(hierarchy, 64 * count) << kind.name;
        if (kind.ballsOnly) {
            EXPECT_LE(hierarchy + shapes, 64 * count) << kind.name;
        }
    }
}

}  // namespace
}  // namespace glint
