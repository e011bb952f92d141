// T3, T4: every shape under random affine transforms (turns, unequal scales, shear, mirrors)
// against quad precision; hits put back onto the surface; rays aimed at edges, rims and the apex.
#include <gtest/gtest.h>

#include "tests/support/hit_check.h"

namespace glint {
namespace {

using namespace test;
using ShapesFull = FullRun;

Tally throwAt(const CanonicalShape& shape, std::uint64_t count, double distance) {
    return checkHits(
        count, 2, [=](Random& random) { return randomInstance(random, shape); },
        [=](Random& random) {
            const DVec3 from = distance * random.direction();
            DVec3 to = random.next() % 2 == 0 ? rimPoint(random, shape) : random.inCube(1.2);
            // Along an axis, in a face's plane, down the axis itself: exact zeros in the direction.
            if (random.next() % 8 == 0) to = from, to[static_cast<int>(random.next() % 3)] *= -1;
            return LocalRay{from, to};
        });
}

void expectAgreement(std::uint64_t count) {
    for (const CanonicalShape& shape : oneOfEach()) {
        if (std::holds_alternative<CanonicalTorus>(shape)) continue;  // torus_test.cpp
        for (const double distance : {2.0, 30.0, 1e4}) {
            const Tally tally = throwAt(shape, count, distance);
            tally.print(std::string(nameOf(shape)) + " at " + std::to_string(distance) + " sizes");
            EXPECT_EQ(tally.failures, 0u) << tally.first;
        }
    }
}

TEST(Shapes, HitsUnderAffineTransformsAgreeWithQuadPrecision) { expectAgreement(8000); }
TEST_F(ShapesFull, HitsUnderAffineTransformsAgreeWithQuadPrecision) {
    expectAgreement(100'000'000 / 21 + 1);
}

/// A point of a curved side, and the unit normal there (canonical space).
struct SidePoint {
    DVec3 at, normal;
};
SidePoint sidePoint(Random& random, const CanonicalShape& shape) {
    if (std::holds_alternative<CanonicalSphere>(shape)) {
        const DVec3 p = random.direction();
        return {p, p};
    }
    const double phi = random.uniform(0, 2 * kPi), y = random.uniform(-1, 1);
    const DVec3 out(std::cos(phi), 0, std::sin(phi));
    if (std::holds_alternative<CanonicalCylinder>(shape)) return {out + DVec3(0, y, 0), out};
    return {(1 - y) / 2 * out + DVec3(0, y, 0), glm::normalize(out + DVec3(0, 0.5, 0))};
}

/// Rays that are nearly tangent to a curved side: they pass it at 0.999 to 1.00001 of its radius.
Tally graze(const CanonicalShape& shape, std::uint64_t count, double distance) {
    return checkHits(
        count, 4, [=](Random& random) { return randomInstance(random, shape); },
        [=](Random& random) {
            const SidePoint side = sidePoint(random, shape);
            const DVec3 along = glm::normalize(glm::cross(side.normal, random.direction()));
            const DVec3 to = side.at - random.uniform(-1e-5, 1e-3) * side.normal;
            return LocalRay{to - distance * along, to};
        });
}

void expectGrazing(std::uint64_t count) {
    for (const CanonicalShape& shape :
         {CanonicalShape(CanonicalSphere{}), CanonicalShape(CanonicalCylinder{}),
          CanonicalShape(CanonicalCone{})})
        for (const double distance : {0.01, 2.0, 30.0, 1e4}) {
            const Tally tally = graze(shape, count, distance);
            tally.print(std::string("grazing ") + nameOf(shape) + " from " +
                        std::to_string(distance));
            EXPECT_EQ(tally.failures, 0u) << tally.first;
        }
}

TEST(Shapes, GrazingHitsOfCurvedSidesAgreeWithQuadPrecision) { expectGrazing(6000); }
TEST_F(ShapesFull, GrazingHitsOfCurvedSidesAgreeWithQuadPrecision) {
    expectGrazing(100'000'000 / 12 + 1);
}

/// Turned, stretched by up to 1e6 to 1, and turned again, so that local axes are sheared: needles,
/// slabs and slivers.
DMat3 extremeLinear(Random& random) {
    const auto turn = [&] { return rotationFromDegrees(random.inCube(180)); };
    const auto factor = [&] { return random.logUniform(1e-3, 1e3); };
    const DMat3 scale(DVec3(factor(), 0, 0), DVec3(0, factor(), 0), DVec3(0, 0, factor()));
    return turn() * scale * (random.next() % 2 == 0 ? turn() : DMat3(1.0));
}

Tally throwAtNeedles(const CanonicalShape& shape, std::uint64_t count) {
    return checkHits(
        count, 14,
        [=](Random& random) {
            return makeInstance(shape, extremeLinear(random), random.inCube(10));
        },
        [=](Random& random) {
            const DVec3 from = random.logUniform(1.1, 100) * random.direction();
            return LocalRay{from,
                            random.next() % 2 == 0 ? rimPoint(random, shape) : random.inCube(1.2)};
        },
        Company::OneFarOff);
}

void expectNeedles(std::uint64_t count) {
    for (const CanonicalShape& shape : oneOfEach()) {
        const Tally tally = throwAtNeedles(shape, count);
        tally.print(std::string("stretched to 1e6 : 1, ") + nameOf(shape));
        EXPECT_EQ(tally.failures, 0u) << tally.first;
    }
}

TEST(Shapes, NeedlesAndSliversAgreeWithQuadPrecision) { expectNeedles(6000); }
TEST_F(ShapesFull, NeedlesAndSliversAgreeWithQuadPrecision) { expectNeedles(10'000'000 / 8); }

/// Puts random points near a surface back onto it, on the face that is nearest.
Tally projectOnto(const CanonicalShape& shape, std::uint64_t count) {
    return tallyInParallel(count, 3, [=](Random& random, std::uint64_t n) {
        Tally tally;
        while (tally.checks < n) {
            const DVec3 from = random.logUniform(2, 1e6) * random.direction(),
                        direction = glm::normalize(random.inCube(1) - from);
            std::visit(
                [&](const auto& s) {
                    const Crossing hit = s.first(from, direction, Start::Elsewhere);
                    if (!hit.found()) return;
                    ++tally.checks;
                    const DVec3 p = s.project(from + hit.t * direction, hit.face);
                    const double off = residual(shape, VecOf<long double>(p), hit.face);
                    tally.error(off);
                    if (!(off <= 4e-16))
                        tally.fail(std::string(nameOf(shape)) + " off by " + std::to_string(off));
                    // Outwards: the ray came from outside (of open shapes: from either side).
                    if (s.closed && !s.inside(from) &&
                        !(glm::dot(s.normal(p, hit.face), direction) <=
                          1e-7 * glm::length(s.normal(p, hit.face))))
                        tally.fail(std::string(nameOf(shape)) + " normal points inwards");
                },
                shape);
        }
        return tally;
    });
}

void expectResiduals(std::uint64_t count) {
    for (const CanonicalShape& shape : oneOfEach()) {
        const Tally tally = projectOnto(shape, count);
        tally.print("residual of " + std::string(nameOf(shape)));
        EXPECT_EQ(tally.failures, 0u) << tally.first;
    }
}

TEST(Shapes, HitsArePutBackOntoTheSurface) { expectResiduals(20000); }
TEST_F(ShapesFull, HitsArePutBackOntoTheSurface) { expectResiduals(100'000'000 / 8); }

TEST(Shapes, OutwardStaysOutwardUnderMirrors) {
    Random random(7);
    for (const CanonicalShape& shape : oneOfEach())
        for (int i = 0; i < 200; ++i) {
            const ShapeInstance s = makeInstance(shape, randomLinear(random), DVec3(0.0));
            const DVec3 above(0.2, 5, 0.1), direction = glm::normalize(DVec3(0.3, 0, 0.1) - above);
            std::visit(
                [&](const auto& canonical) {
                    const Crossing hit = canonical.first(above, direction, Start::Elsewhere);
                    if (!hit.found()) return;
                    const DVec3 p = canonical.project(above + hit.t * direction, hit.face);
                    const DVec3 n = canonical.normal(p, hit.face) * s.localFromWorld;
                    EXPECT_LT(glm::dot(n, s.worldFromLocal * direction), 0) << nameOf(shape);
                },
                shape);
        }
}

/// Found among 1e9 rays: a start that rounding puts 2e-16 outside, along a tangent. Where the
/// distance is c / q, both near 0, it becomes 1e-5 radii instead of 5e-9.
TEST(Shapes, ATangentRayThatEntersLeavesWhereItStarts) {
    const double along = 2.5e-11, outside = 2.3e-16;
    for (const double side : {-1.0, 1.0}) {
        const DVec3 o(1 + outside, 0, 0), d = glm::normalize(DVec3(side * along, 0, 1));
        EXPECT_LE(CanonicalSphere{}.first(o, d, Start::Entering).t, 1e-7);
        EXPECT_LE(CanonicalCylinder{}.first(o, d, Start::Entering).t, 1e-7);
    }
}

TEST(Shapes, ApexOfAConeIsMetFromAbove) {
    const CanonicalCone cone;
    const Crossing hit = cone.first({0, 3, 0}, {0, -1, 0}, Start::Elsewhere);
    EXPECT_EQ(hit.t, 2);
    EXPECT_EQ(cone.project({0, 1, 0}, hit.face), DVec3(0, 1, 0));
    EXPECT_EQ(cone.normal({0, 1, 0}, hit.face), DVec3(0, 1, 0));
    // The nappe above the apex is no part of the cone.
    EXPECT_FALSE(cone.first({-3, 2, 0}, {1, 0, 0}, Start::Elsewhere).found());
}

TEST(Shapes, ARayInThePlaneOfAFaceMeetsOrMissesWithoutNaN) {
    const CanonicalBox box;
    EXPECT_EQ(box.first({-3, 1, 0}, {1, 0, 0}, Start::Elsewhere).t, 2);
    EXPECT_FALSE(box.first({-3, std::nextafter(1.0, 2.0), 0}, {1, 0, 0}, Start::Elsewhere).found());
    const CanonicalCylinder cylinder;
    EXPECT_EQ(cylinder.first({1, -3, 0}, {0, 1, 0}, Start::Elsewhere).t, 2);
    EXPECT_FALSE(CanonicalPlane{}.first({0, 0, 0}, {1, 0, 0}, Start::Elsewhere).found());
}

/// A path is known to be inside, but its origin is a rounding outside of a face and it goes along
/// that face: it must leave there, and not be carried to another face.
TEST(Shapes, ABoundaryAHairBehindIsMetWhereTheRayIs) {
    const double above = std::nextafter(1.0, 2.0);
    const auto stays = [](const auto& shape, const DVec3& o, const DVec3& d) {
        for (const Start start : {Start::KnownInside, Start::Entering}) {
            const Crossing hit = shape.first(o, d, start);
            EXPECT_EQ(hit.t, 0);
            EXPECT_LE(glm::length(shape.project(o, hit.face) - o), 1e-15);
        }
    };
    stays(CanonicalBox{}, {0.5, above, 0.2}, {1, 0, 0});
    stays(CanonicalBox{}, {above, 0.3, 0.2}, {0, 1, 0});
    stays(CanonicalBox{}, {0.1, 0.3, -above}, {0, 1, 0});
    stays(CanonicalCylinder{}, {0.3, above, 0}, {1, 0, 0});
    stays(CanonicalCylinder{}, {0.3, -above, 0}, {1, 0, 0});
    stays(CanonicalCylinder{}, {above, 0.3, 0}, {0, 1, 0});
    stays(CanonicalCone{}, {0.3, -above, 0}, {1, 0, 0});
}

/// Two glass blocks share a face. Light reflected within the upper one leaves the shared face
/// upwards; rounding may have put that point inside the lower block, which it must not hit, least
/// of all at its far end.
TEST(Shapes, AFaceJustLeftIsNotMetAgainByATrackedPath) {
    const double below = std::nextafter(1.0, 0.0);
    const auto passes = [](const auto& shape, const DVec3& o, const DVec3& d) {
        EXPECT_FALSE(shape.first(o, d, Start::KnownOutside).found());
        const Crossing back = shape.first(o, -d, Start::KnownOutside);
        EXPECT_EQ(back.t, 0);
        EXPECT_LE(glm::length(shape.project(o, back.face) - o), 1e-15);
    };
    passes(CanonicalBox{}, {0.5, below, 0.2}, {0.6, 0.8, 0});
    passes(CanonicalSphere{}, {0, below, 0}, {0.6, 0.8, 0});
    passes(CanonicalCylinder{}, {0.5, below, 0.2}, {0.6, 0.8, 0});
    passes(CanonicalCone{}, {0.5, -below, 0}, {0.6, -0.8, 0});
    passes(CanonicalTorus{0.5}, {1, std::nextafter(0.5, 0.0), 0}, {0.6, 0.8, 0});
    passes(CanonicalPlane{}, {0.5, -1e-17, 0.2}, {0.6, 0.8, 0});
}

}  // namespace
}  // namespace glint
