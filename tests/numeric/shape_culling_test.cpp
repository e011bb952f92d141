// ShapeLists::cull: rays of a bundle meet among the few shapes what they meet among all, for
// cameras and shapes of any size, and most shapes are left out.
#include <gtest/gtest.h>

#include "tests/support/rays.h"
#include "tracer/compile/camera_model.h"
#include "tracer/compile/shape_lists.h"

namespace glint {
namespace {

using test::Random;

/// Shapes of all kinds about a cube of half the size `scale` around `at`.
std::vector<ShapeInstance> makeField(std::size_t count, bool ballsOnly, double scale,
                                     const DVec3& at, Random& random) {
    const CanonicalShape kinds[] = {CanonicalSphere{},   CanonicalBox{},      CanonicalQuad{},
                                    CanonicalDisk{},     CanonicalCylinder{}, CanonicalCone{},
                                    CanonicalTorus{0.3}, CanonicalSphere{}};
    std::vector<ShapeInstance> out;
    for (std::size_t i = 0; i < count; ++i) {
        const double size =
            scale * random.uniform(0.1, 0.6) / std::cbrt(static_cast<double>(count));
        CanonicalShape shape;
        DMat3 linear(size);
        if (!ballsOnly && i % 8 != 0) {
            shape = kinds[i % 8];
            linear = rotationFromDegrees(random.inCube(180));
            for (int axis = 0; axis < 3; ++axis) linear[axis] *= size * random.uniform(0.1, 3);
            linear =
                linear * DMat3(DVec3(1, 0, 0), DVec3(random.uniform(-1, 1), 1, 0), DVec3(0, 0, 1));
        }
        out.push_back(test::makeInstance(shape, linear, at + scale * random.inCube(1)));
    }
    return out;
}

Camera randomCamera(double scale, const DVec3& at, Random& random) {
    Camera camera;
    camera.target = at + 0.5 * scale * random.inCube(1);
    camera.position = camera.target + scale * random.logUniform(0.1, 100) * random.direction();
    camera.up = random.direction();
    camera.verticalFovDegrees =
        random.uniform() < 0.2 ? random.uniform(1e-5, 1e-3) : random.uniform(1, 170);
    if (random.uniform() < 0.3) {
        camera.projection = Projection::Orthographic;
        camera.orthoHeight = scale * random.logUniform(1e-6, 3.2);
    }
    return camera;
}

struct Tally {
    std::size_t rays = 0, hits = 0, culled = 0, bundles = 0, kept = 0, of = 0;
};

/// Rays of tiles of a picture of 320 x 200 pixels.
void compareTiles(std::size_t count, bool ballsOnly, double scale, const DVec3& at, Random& random,
                  Tally& tally) {
    const ShapeLists lists(makeField(count, ballsOnly, scale, at, random));
    const MediaStack media;
    WorkCounts work;
    FewShapes few;
    for (int view = 0; view < 10; ++view) {
        const CameraModel camera(randomCamera(scale, at, random), DVec3(0.0), 320, 200);
        for (int tile = 0; tile < 10; ++tile) {
            const double size = random.uniform() < 0.2 ? 1e-3 : 16, x = random.uniform(0, 320),
                         y = random.uniform(0, 200);
            const auto bundle = camera.bundle(x, y, x + size, y + size);
            ASSERT_TRUE(bundle.has_value());
            ++tally.bundles;
            if (!lists.cull(*bundle, few)) continue;
            ++tally.culled;
            tally.kept += few.balls.size() + few.boxes.size();
            tally.of += count;
            for (int i = 0; i < 40; ++i) {
                // One in four on the edge of the tile.
                const double u = random.uniform(), w = random.uniform(),
                             v = i % 4 ? w : std::round(w);
                const Ray ray = camera.ray(x + size * u, y + size * v);
                const ShapeHit all = lists.closest(ray, media, kInfinity, work),
                               seen = lists.closest(ray, media, kInfinity, work, &few);
                ++tally.rays;
                tally.hits += all.found();
                ASSERT_EQ(all.shape, seen.shape) << count << " shapes, scale " << scale;
                ASSERT_EQ(all.t, seen.t);
                ASSERT_EQ(all.face, seen.face);
            }
        }
    }
}

TEST(ShapeCulling, RaysOfATileMeetAmongTheFewWhatTheyMeetAmongAll) {
    Random random(3);
    Tally tally;
    for (const std::size_t count : {2, 5, 17, 64, 128, 129, 700, 5000})
        for (const double scale : {1.0, 1e-7, 1e9})
            for (const bool ballsOnly : {false, true})
                for (const DVec3& at : {DVec3(0.0), 1e3 * scale * DVec3(1, -2, 0.5)})
                    compareTiles(count, ballsOnly, scale, at, random, tally);
    EXPECT_GT(tally.rays, 100'000u);
    EXPECT_GT(tally.hits, tally.rays / 20);
    EXPECT_GT(tally.culled, tally.bundles / 2);
    EXPECT_LT(tally.kept, tally.of / 4);
}

TEST(ShapeCulling, ALensHasNoBundle) {
    Camera camera;
    camera.apertureRadius = 0.1;
    EXPECT_FALSE(CameraModel(camera, DVec3(0.0), 32, 32).bundle(0, 0, 16, 16).has_value());
}

TEST(ShapeCulling, TheMiddleOfABundleIsInside) {
    Random random(5);
    for (int i = 0; i < 1000; ++i) {
        const Camera settings = randomCamera(1, DVec3(0.0), random);
        const CameraModel camera(settings, DVec3(0.0), 64, 64);
        const auto bundle = camera.bundle(10, 20, 26, 36);
        ASSERT_TRUE(bundle.has_value());
        const Ray middle = camera.ray(18, 28);
        for (const double t : {0.0, 0.1, 10.0, 1e4})
            EXPECT_FALSE(bundle->misses(middle.at(t), [](const DVec3&) { return 0.0; }));
        // Behind a camera whose angle is not so small that rounding blurs it.
        if (settings.projection == Projection::Perspective && settings.verticalFovDegrees >= 1) {
            EXPECT_TRUE(bundle->misses(middle.at(-10), [](const DVec3&) { return 0.0; }));
        }
    }
}

}  // namespace
}  // namespace glint
