// Surfaces in one place: rugs on floors, posters on boxes, level tops, lamps flush with a ceiling,
// and copies. The same one is seen by every ray, and nothing shadows what it touches.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/scalar_lists.h"
#include "tests/support/world.h"

namespace glint {
namespace {

using namespace test;

/// Shapes whose faces lie in the plane y = 0 around the origin, each placed by numbers of its own,
/// so that their roundings differ.
struct Pair {
    const char* name;
    CanonicalShape below, above;
    DVec3 belowScale, belowAt, aboveScale, aboveAt;
};
const Pair kPairs[] = {{"rug on a floor",
                        CanonicalPlane{},
                        CanonicalQuad{},
                        {1, 1, 1},
                        {3, 0, -2},
                        {1.5, 1, 1.2},
                        {0.1, 0, 0.2}},
                       {"disk on a floor",
                        CanonicalPlane{},
                        CanonicalDisk{},
                        {1, 1, 1},
                        {3, 0, -2},
                        {1.5, 1, 1.2},
                        {0.1, 0, 0.2}},
                       {"poster on a box",
                        CanonicalBox{},
                        CanonicalQuad{},
                        {2, 0.7, 2},
                        {0, -0.7, 0},
                        {1.5, 1, 1.2},
                        {0.1, 0, 0.2}},
                       {"disk on a cap",
                        CanonicalCylinder{},
                        CanonicalDisk{},
                        {2, 0.7, 2},
                        {0, -0.7, 0},
                        {1.4, 1, 1.4},
                        {0.1, 0, 0.1}},
                       {"quad over a disk",
                        CanonicalDisk{},
                        CanonicalQuad{},
                        {2, 1, 2},
                        {0.1, 0, 0.3},
                        {1.1, 1, 1.2},
                        {0, 0, 0}},
                       {"level tops",
                        CanonicalBox{},
                        CanonicalBox{},
                        {2, 0.3, 2},
                        {0.1, -0.3, 0},
                        {1.5, 1.1, 1.6},
                        {0.1, -1.1, 0.2}},
                       {"ball and copy",
                        CanonicalSphere{},
                        CanonicalSphere{},
                        {1, 1, 1},
                        {0, -1, 0},
                        {1, 1, 1},
                        {0, -1, 0}},
                       {"torus and copy",
                        CanonicalTorus{0.4},
                        CanonicalTorus{0.4},
                        {1, 1, 1},
                        {0, -0.4, 1},
                        {1, 1, 1},
                        {0, -0.4, 1}},
                       {"cone and copy",
                        CanonicalCone{},
                        CanonicalCone{},
                        {1, 1, 1},
                        {0, -1, 0.3},
                        {1, 1, 1},
                        {0, -1, 0.3}}};

DMat3 scaling(const DVec3& s) { return {DVec3(s.x, 0, 0), DVec3(0, s.y, 0), DVec3(0, 0, s.z)}; }

/// Rays from above onto the middle of the common face, and what leaves from there.
Tally lookAt(const Pair& pair, std::uint64_t count, bool swap) {
    return tallyInParallel(count, 51, [=](Random& random, std::uint64_t n) {
        Tally tally;
        World world({});
        DMat3 turn(1.0);
        DVec3 at(0.0);
        double size = 1;
        for (std::uint64_t i = 0; i < n; ++i) {
            if (i % 64 == 0) {
                turn = rotationFromDegrees(random.inCube(180));
                size = random.logUniform(1e-3, 1e3);
                at = size * random.inCube(20);
                std::vector<ShapeInstance> shapes = {
                    makeInstance(pair.below, turn * scaling(size * pair.belowScale),
                                 at + turn * (size * pair.belowAt)),
                    makeInstance(pair.above, turn * scaling(size * pair.aboveScale),
                                 at + turn * (size * pair.aboveAt))};
                if (swap) std::swap(shapes[0], shapes[1]);
                world = World(std::move(shapes));
            }
            DVec3 from = random.logUniform(1, 30) * random.direction();
            from.y = std::abs(from.y) * (random.next() % 4 == 0 ? 0.03 : 1) + 1e-2;
            const DVec3 to(random.uniform(-0.6, 0.6), 0, random.uniform(-0.6, 0.6));
            const Ray ray = rayTo(at + turn * (size * from), at + turn * (size * to));
            const ShapeHit hit = world.scene.lists->closest(ray, {});
            if (!hit.found()) continue;
            ++tally.checks;
            const ShapeInstance& shape = world.scene.shapes[hit.shape];
            // A flat shape lies on top; else the later one.
            const bool differ = isClosed(pair.below) != isClosed(pair.above);
            const std::uint32_t expected =
                differ ? (isClosed(world.scene.shapes[0].shape) ? 1 : 0) : 1;
            if (hit.shape != expected) tally.fail("shows the other: " + replay(shape, ray));
            const SurfacePoint point = world.point(ray, hit);
            Vec3 up = randomUp(random);
            if (up.z < 1e-6f)
                continue;  // Which way is up is a matter of the direction's last bits.
            if (point.wo.z < 0) up = -up;
            const Ray out = point.ray(up), in = point.ray(-up);
            // Upwards only tori meet themselves again, or their copy.
            const bool torus = std::holds_alternative<CanonicalTorus>(pair.above);
            if (!torus && world.scene.lists->closest(out, {}).found())
                tally.fail("meets what it lies on: " + replay(shape, out));
            if (!torus && world.scene.lists->occluded(out, {}, kInfinity, kNoShape))
                tally.fail("is shadowed by what it lies on: " + replay(shape, out));
            // Downwards from a flat one there is the other, at once; at flatter angles it is a
            // matter of the last bits which way is down.
            if (std::abs(up.z) > 1e-3f && !isClosed(shape.shape) &&
                isClosed(world.scene.shapes[1 - hit.shape].shape)) {
                const ShapeHit below = world.scene.lists->closest(in, {});
                if (below.shape != 1 - hit.shape || below.t > 1e-9 * size)
                    tally.fail("falls through: " + replay(world.scene.shapes[1 - hit.shape], in));
            }
        }
        return tally;
    });
}

TEST(Coincidence, OneOfTwoSurfacesIsSeenEverywhereAndNeitherShadowsTheOther) {
    for (const Pair& pair : kPairs)
        for (const bool swap : {false, true}) {
            const Tally tally = lookAt(pair, 20000, swap);
            tally.print(pair.name);
            EXPECT_GT(tally.checks, 1000u);
            EXPECT_EQ(tally.failures, 0u) << tally.first;
        }
}

/// The filtered lists, flat and in the hierarchy, choose as the loop over all shapes does.
TEST(Coincidence, AnOrderOfManyCoincidentSurfacesDoesNotDependOnTheSearch) {
    Random random(53);
    for (const int count : {6, 40, 300}) {
        std::vector<ShapeInstance> shapes;
        const DMat3 turn = rotationFromDegrees({10, 20, 30});
        for (int i = 0; i < count; ++i) {
            const DVec3 at = turn * DVec3(random.uniform(-3, 3), 0, random.uniform(-3, 3));
            const DMat3 scale = scaling({random.uniform(0.3, 2), 0.5, random.uniform(0.3, 2)});
            if (i % 3 == 0) shapes.push_back(makeInstance(CanonicalQuad{}, turn * scale, at));
            if (i % 3 == 1) shapes.push_back(makeInstance(CanonicalDisk{}, turn * scale, at));
            if (i % 3 == 2)
                shapes.push_back(
                    makeInstance(CanonicalBox{}, turn * scale, at - turn * DVec3(0, 0.5, 0)));
        }
        const ShapeLists lists(shapes);
        const ScalarLists model(shapes);
        for (int i = 0; i < 20000; ++i) {
            const Ray ray = rayTo(
                turn * DVec3(random.uniform(-9, 9), random.uniform(0.1, 5), random.uniform(-9, 9)),
                turn * DVec3(random.uniform(-3, 3), 0, random.uniform(-3, 3)));
            ASSERT_EQ(lists.closest(ray, {}).shape, model.closest(ray, {}).shape)
                << i << " of " << count;
        }
    }
}

/// Under an even sky a matt rug on a matt floor has its albedo in every pixel, floor and rug alike.
TEST(Coincidence, ARugOnAFloorIsLitLikeOneThatHovers) {
    SceneBuilder b;
    b.object(Plane{}, b.material(Diffuse{Color{0.5, 0.5, 0.5}}), {0, 0.3, 0});
    b.object(Quad{{40, 40}}, b.material(Diffuse{Color{0.2, 0.2, 0.2}}), {0.1, 0.3, 0});
    b.scene().environment.color = Color{1, 1, 1};
    b.camera({1, 3, 5}, {0, 0.3, 0}, 40);
    b.scene().film = {.width = 64, .height = 48};
    b.scene().render.spp = 4;
    for (const float value : b.render().beauty.rgb) ASSERT_NEAR(value, 0.2, 1e-6);
}

/// A room is a box or a cylinder seen from within. A rug on its floor, a picture on its wall
/// and the ground that it stands on look as they do a hair above, behind and below.
TEST(Coincidence, WhatLiesOnTheInsideOfARoomIsLitLikeWhatHovers) {
    const auto picture = [](const Shape& room, double hair, bool groundFirst) {
        SceneBuilder b;
        const MaterialId grey = b.material(Diffuse{Color{0.5, 0.5, 0.5}});
        const MaterialId red = b.material(Diffuse{Color{0.6, 0.2, 0.1}});
        if (groundFirst) b.object(Plane{}, grey, {0, -hair, 0});
        b.object(room, grey, {0.1, 1.35, 0});
        if (!groundFirst) b.object(Plane{}, grey, {0, -hair, 0});
        b.object(Quad{{1.1, 0.9}}, red, {-0.7, hair, 0.3});
        b.object(Disk{0.4}, red, {0.6, hair, 0.2});
        const ObjectId id = b.object(Quad{{0.8, 0.6}}, red, {0.2, 1.1, -2 + hair});
        Object wall = b.scene().objects.at(id);
        wall.transform.rotateDegrees = {90, 0, 0};
        b.scene().objects.set(id, wall);
        b.object(Sphere{0.2}, {}, {0.3, 2.2, 0.2}, {10, 10, 10});
        b.camera({0, 1.5, 1.8}, {0, 0.7, 0}, 70);
        b.film(32, 24, 16);
        return b.render().beauty;
    };
    for (const Shape& room : {Shape(Box{{4, 2.7, 4}}), Shape(Cylinder{2.5, 2.7})})
        for (const bool groundFirst : {true, false}) {
            const Image flush = picture(room, 0, groundFirst),
                        hovering = picture(room, 1e-7, groundFirst);
            for (int channel = 0; channel < 3; ++channel) {
                const double a = estimateMean(flush, channel).mean,
                             c = estimateMean(hovering, channel).mean;
                EXPECT_GT(c, 0.03);
                // Where the ground comes last it is what is seen: its frame turns the samples, so
                // the noise differs.
                EXPECT_NEAR(a, c, (groundFirst ? 1e-3 : 2e-2) * c)
                    << kindOf(room) << ", channel " << channel;
            }
        }
}

/// From below, the ground shows what stands on it, lit.
TEST(Coincidence, ABoxOnTheGroundIsLitFromBelow) {
    for (const bool groundFirst : {true, false}) {
        SceneBuilder b;
        const MaterialId grey = b.material(Diffuse{Color{0.4, 0.4, 0.4}});
        if (groundFirst) b.object(Plane{}, grey, {0, 0.3, 0});
        b.object(Box{{2, 1, 2}}, grey, {0.1, 0.8, 0});
        if (!groundFirst) b.object(Plane{}, grey, {0, 0.3, 0});
        b.scene().environment.color = Color{1, 1, 1};
        b.camera({1, -3, 5}, {0, 0.3, 0}, 20);
        b.film(32, 24, 4);
        for (const float value : b.render().beauty.rgb) ASSERT_NEAR(value, 0.4, 1e-6);
    }
}

/// A lamp in the plane of the ceiling gives the light of one a hair below it.
TEST(Coincidence, ALampFlushWithTheCeilingIsNotShadowedByIt) {
    for (const Shape& lamp : {Shape(Quad{{1, 1}}), Shape(Disk{0.5}), Shape(Box{{1, 0.2, 1}})}) {
        const auto picture = [&](double below) {
            SceneBuilder b;
            const MaterialId grey = b.material(Diffuse{Color{0.5, 0.5, 0.5}});
            b.object(Box{{4, 2.7, 4}}, grey, {0, 1.35, 0});
            const double half = std::holds_alternative<Box>(lamp) ? 0.1 : 0;
            const ObjectId id =
                b.object(lamp, {}, {0.3, 2.7 - below + (half > 0 ? -half : 0), 0.2}, {10, 10, 10});
            Object turned = b.scene().objects.at(id);
            turned.transform.rotateDegrees = {180, 0, 0};
            b.scene().objects.set(id, turned);
            b.camera({0, 1.2, 1.8}, {0, 0.8, 0}, 70);
            b.scene().film = {.width = 32, .height = 24};
            b.scene().render.spp = 16;
            return b.render().beauty;
        };
        const Image flush = picture(0), hovering = picture(1e-7);
        const Estimate a = estimateMean(flush), c = estimateMean(hovering);
        EXPECT_GT(c.mean, 0.1);
        EXPECT_NEAR(a.mean, c.mean, 1e-3 * c.mean) << kindOf(lamp);
    }
}

/// What lets light straight or scattered through, over nothing and over black.
std::vector<Material> sheetsFor(SceneBuilder& b) {
    const MaterialId black = b.material(Diffuse{Color{0, 0, 0}});
    Glass pane;
    pane.thin = true;
    return {{"Paper", Translucent{Color{0.2, 0.2, 0.2}, Color{0.7, 0.7, 0.7}}},
            {"Pane", pane},
            {"Veil", Mix{{{}, true}, {black, false}, 0.5}}};
}

/// Paper, panes and veils flush with the wall of a closed room let none of the light outside in,
/// whether the wall is a box or a rectangle and whichever comes first in the scene.
TEST(Coincidence, NoLightComesThroughASheetOnAWall) {
    for (const DVec3& turn : {DVec3(0, 0, 0), DVec3(17, 31, 0), DVec3(3, 0.5, 71)})
        for (std::size_t sheet = 0; sheet < 3; ++sheet)
            for (const bool box : {true, false})
                for (const bool sheetFirst : {true, false})
                    for (const bool walled : {true, false}) {
                        SceneBuilder b;
                        const MaterialId white = b.material(Diffuse{Color{0.8, 0.8, 0.8}});
                        const MaterialId thin = b.scene().materials.add(sheetsFor(b)[sheet]);
                        const DVec3 middle(0.1, 1.3, -0.7);
                        Group room{.name = "Room"};
                        room.transform.translate = middle;
                        room.transform.rotateDegrees = turn;
                        const GroupId group = b.scene().groups.add(room);
                        const auto add = [&](const Shape& shape, MaterialId material,
                                             const DVec3& at, double tilt) {
                            const ObjectId id = b.object(shape, material, at);
                            Object tilted = b.scene().objects.at(id);
                            tilted.transform.rotateDegrees = {tilt, 0, 0};
                            tilted.parent = group;
                            b.scene().objects.set(id, tilted);
                        };
                        const DVec3 back(0, 0, -2.85);
                        if (sheetFirst) add(Quad{{3, 2}}, thin, back, 90);
                        if (walled && box) add(Box{{4.1, 3.3, 5.7}}, white, {}, 0);
                        if (walled && !box) add(Quad{{40, 40}}, white, back, 90);
                        if (!sheetFirst) add(Quad{{3, 2}}, thin, back, 90);
                        const DMat3 frame = rotationFromDegrees(turn);
                        b.scene().lights.add(
                            {"Sun", SunLight{.direction = frame * DVec3(0, 0, 1)}, true, {}});
                        if (box || !walled) b.scene().environment.color = Color{1000, 1000, 1000};
                        b.camera(middle, middle + frame * back, 60);
                        b.film(24, 18, 4);
                        const Image picture = b.render().beauty;
                        const float most =
                            *std::max_element(picture.rgb.begin(), picture.rgb.end());
                        if (walled)
                            EXPECT_EQ(most, 0) << sheet << box << sheetFirst;
                        else
                            EXPECT_GT(most, 0) << sheet;
                    }
}

/// Sheets in one place let through what each of them does, from either side.
TEST(Coincidence, VeilsInOnePlaceMultiply) {
    for (const int count : {1, 2, 3, 5})
        for (const double side : {1.0, -1.0}) {
            SceneBuilder b;
            const MaterialId veil = b.scene().materials.add(sheetsFor(b)[2]);
            for (int i = 0; i < count; ++i)
                b.object(Quad{{20.0 + i, 30.0}}, veil, {0.1 * i, 0.3, 0});
            b.scene().environment.color = Color{1, 1, 1};
            b.camera({1, 0.3 + side * 3, 2}, {0, 0.3, 0}, 40);
            b.film(32, 24, 64);
            EXPECT_NEAR(estimateMean(b.render().beauty).mean, std::pow(0.5, count), 5e-3)
                << count << side;
        }
}

}  // namespace
}  // namespace glint
