// T22: the set of dielectrics that a path is inside of stays that of geometry over millions of
// crossings, where glass is nested, touches, overlaps, and shares faces.
#include <gtest/gtest.h>

#include "tests/support/world.h"

namespace glint {
namespace {

using namespace test;
using MediaWalkFull = FullRun;

struct Place {
    CanonicalShape shape;
    DVec3 halfSize, center;
    DVec3 turnDegrees{0.0};
};

World glassOf(const std::vector<Place>& places) {
    std::vector<ShapeInstance> shapes;
    for (const Place& p : places) {
        const DMat3 scale(DVec3(p.halfSize.x, 0, 0), DVec3(0, p.halfSize.y, 0),
                          DVec3(0, 0, p.halfSize.z));
        shapes.push_back(
            makeInstance(p.shape, rotationFromDegrees(p.turnDegrees) * scale, p.center));
    }
    return World(std::move(shapes), true);
}

struct Arrangement {
    const char* name;
    std::vector<Place> places;
};

/// All within 3 m of the origin. Numbers that no float or double holds exactly, so that touching
/// faces differ by rounding.
std::vector<Arrangement> arrangements() {
    const CanonicalSphere ball;
    const CanonicalBox box;
    const CanonicalCylinder drum;
    const DVec3 turn{17, 31, -43};
    const DVec3 along = rotationFromDegrees(turn)[0];
    return {
        {"balls in balls, one touching from inside",
         {{ball, DVec3(1.1), {0.1, 0, 0}},
          {ball, DVec3(0.7), {0.2, 0.1, 0}},
          {ball, DVec3(0.3), {0.2, 0.1, 0.4}},
          {ball, DVec3(0.2), {0.2, 0, 0.1}}}},
        {"balls that touch from outside",
         {{ball, DVec3(0.7), {-0.7, 0, 0}},
          {ball, DVec3(0.3), {0.3, 0, 0}},
          {ball, DVec3(0.6), {-0.7, 1.3, 0}}}},
        {"boxes that share faces",
         {{box, {0.5, 0.5, 0.5}, {0, 0, 0}},
          {box, {0.5, 0.1, 0.5}, {0, 0.6, 0}},
          {box, {0.3, 0.5, 0.5}, {0.8, 0, 0}},
          {box, {0.5, 0.5, 0.5}, {0, 0, -1}}}},
        {"turned boxes that share a face",
         {{box, DVec3(0.7), -0.7 * along, turn}, {box, {0.1, 0.7, 0.7}, 0.1 * along, turn}}},
        {"a box twice, and one that fills half of it",
         {{box, DVec3(0.6), {0, 0, 0}},
          {box, DVec3(0.6), {0, 0, 0}},
          {box, {0.3, 0.6, 0.6}, {0.3, 0, 0}}}},
        {"ball, box and drum that overlap",
         {{ball, DVec3(0.9), {0, 0, 0}},
          {box, {0.6, 0.7, 0.5}, {0.5, 0.3, 0}, turn},
          {drum, {0.4, 1.1, 0.4}, {-0.3, 0, 0.2}}}},
        {"water in a tumbler, with a bubble",
         {{drum, {0.6, 0.9, 0.6}, {0, 0, 0}},
          {drum, {0.5, 0.8, 0.5}, {0, 0.1, 0}},
          {drum, {0.5, 0.6, 0.5}, {0, -0.1, 0}},
          {ball, DVec3(0.1), {0.1, -0.1, 0}}}},
        {"flattened balls within a box that they touch",
         {{box, {1, 0.2, 1}, {0, 0, 0}},
          {ball, {1, 0.2, 1}, {0, 0, 0}},
          {ball, {0.5, 0.1, 0.3}, {0, 0.1, 0}}}},
    };
}

/// Points so near a surface that rounding may put them on either side: in local units, where every
/// shape is about 1 large.
constexpr double kAmbiguous = 1e-9;

enum class Side { Inside, Outside, Unclear };
Side sideOf(const ShapeInstance& shape, const DVec3& point) {
    const DVec3 p = shape.localPoint(point);
    return std::visit(
        [&](const auto& s) {
            const bool wide = s.inside(p * (1 - kAmbiguous)),
                       narrow = s.inside(p * (1 + kAmbiguous));
            return wide != narrow ? Side::Unclear : wide ? Side::Inside : Side::Outside;
        },
        shape.shape);
}

/// How a walker crosses surfaces: as the tracer does, or in the usual way, which knows nothing and
/// starts 1e-4 further on.
struct Tracked {
    static const MediaStack& known(const MediaStack& media) { return media; }
    static Ray start(const Ray& ray) { return ray; }
};
struct Nudged {
    static MediaStack known(const MediaStack&) { return {}; }
    static Ray start(const Ray& ray) { return {ray.at(1e-4), ray.direction}; }
};

/// A path that bounces and refracts at random, and is compared with geometry in the middle of every
/// segment.
template <class Way>
class Walker {
  public:
    Walker(const World& world, Random& random) : world_(world), random_(random) { startAnew(); }

    void step(Tally& tally) {
        const ShapeHit hit = world_.scene.lists->closest(ray_, Way::known(media_));
        compare(hit.found() ? hit.t / 2 : 1e3, tally);
        if (!hit.found() || wrong_ || ++steps_ == 200) return startAnew();
        const SurfacePoint point = world_.point(ray_, hit, media_);
        const bool crosses = random_.next() % 4 != 0;
        Vec3 wi = randomUp(random_);
        if (crosses == point.outside) wi.z = -wi.z;
        const bool straight = crosses && random_.next() % 2 == 0;
        ray_ = Way::start(straight ? Ray{point.position, ray_.direction, point.shape, point.outside}
                                   : point.ray(wi));
        if (crosses) media_.cross(hit.shape);
        crossings_ += crosses ? 1 : 0;
    }
    [[nodiscard]] std::uint64_t crossings() const { return crossings_; }

  private:
    /// At a place and with the media around it, of which none is unclear.
    void startAnew() {
        wrong_ = false;
        steps_ = 0;
        bool clear = false;
        while (!clear) {
            ray_ = {random_.inCube(2), random_.direction()};
            media_ = {};
            clear = true;
            for (std::uint32_t i = 0; i < world_.scene.shapes.size(); ++i) {
                const Side side = sideOf(world_.scene.shapes[i], ray_.origin);
                clear = clear && side != Side::Unclear;
                if (side == Side::Inside) media_.cross(i);
            }
        }
    }

    void compare(double t, Tally& tally) {
        for (std::uint32_t i = 0; i < world_.scene.shapes.size(); ++i) {
            const Side side = sideOf(world_.scene.shapes[i], ray_.at(t));
            if (side == Side::Unclear) continue;
            ++tally.checks;
            if (media_.contains(i) == (side == Side::Inside)) continue;
            wrong_ = true;
            tally.fail(replay(world_.scene.shapes[i], ray_));
        }
    }

    const World& world_;
    Random& random_;
    Ray ray_;
    MediaStack media_;
    std::uint64_t crossings_ = 0;
    int steps_ = 0;
    bool wrong_ = false;
};

template <class Way>
Tally walk(const World& world, std::uint64_t crossings) {
    return tallyInParallel(crossings, 22, [&](Random& random, std::uint64_t n) {
        Tally tally;
        Walker<Way> walker(world, random);
        while (walker.crossings() < n) walker.step(tally);
        return tally;
    });
}

void expectNoFlips(std::uint64_t crossings) {
    const auto cases = arrangements();
    for (const Arrangement& a : cases) {
        const World world = glassOf(a.places);
        const std::uint64_t each = crossings / cases.size();
        const Tally tally = walk<Tracked>(world, each);
        tally.print(a.name);
        EXPECT_EQ(tally.failures, 0u) << a.name << ": " << tally.first;
        EXPECT_GE(tally.checks, askedOf(each) * a.places.size() * 3 / 4)
            << a.name << ": too few places were clear";
    }
}

TEST(MediaWalk, NeverFlipsInsideAndOutsideInAMillionCrossings) { expectNoFlips(1'000'000); }
TEST_F(MediaWalkFull, NeverFlipsInsideAndOutsideInAHundredMillionCrossings) {
    expectNoFlips(100'000'000);
}

TEST(MediaWalk, AnEpsilonInsteadOfTrackingFlips) {
    for (const Arrangement& a : arrangements())
        EXPECT_GT(walk<Nudged>(glassOf(a.places), 10'000).failures, 0u) << a.name;
}

}  // namespace
}  // namespace glint
