// Hostile scenes through compile() and render(): each gives a clear warning or error, or the right
// picture; never a sample that is no number, and never a hang.
#include <gtest/gtest.h>

#include <chrono>

#include "tests/support/paths.h"
#include "tests/support/reference.h"
#include "tests/support/scenes.h"

namespace glint {
namespace {

using test::SceneBuilder;

/// A ball on a floor under a grey sky: every pixel is lit.
SceneBuilder litScene() {
    SceneBuilder b;
    b.object(Plane{}, b.material(Diffuse{}));
    b.object(Sphere{1}, b.material(Glass{}), {0, 1, 0});
    b.scene().environment.color = Color{1, 1, 1};
    b.camera({0, 2, 6}, {0, 0.8, 0}, 40);
    b.film(16, 16, 4);
    return b;
}

/// What compile() says of a scene: warnings' text, or the error's.
struct Answer {
    bool drawn = false;
    std::string text;
    Rendering rendering;
};
Answer answerTo(const Scene& scene) {
    AssetCache assets;
    const auto compiled = compile(scene, test::inSource("scenes"), assets);
    Answer out;
    if (!compiled.ok()) {
        out.text = compiled.error().text();
        return out;
    }
    out.drawn = true;
    for (const CompileWarning& warning : compiled.value().warnings)
        out.text += warning.error.text() + "\n";
    const auto start = std::chrono::steady_clock::now();
    out.rendering = render(compiled.value().scene, {.threads = 2});
    EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), 20)
        << "hangs";
    EXPECT_EQ(out.rendering.nonfiniteSamples, 0u);
    for (const float v : out.rendering.beauty.rgb) EXPECT_TRUE(std::isfinite(v));
    return out;
}
double meanOf(const Answer& answer) { return test::estimateMean(answer.rendering.beauty).mean; }

/// Changes the ball of litScene().
template <class Change>
Answer answerToBall(Change&& change) {
    SceneBuilder b = litScene();
    ObjectId id;
    b.scene().objects.forEach([&](ObjectId each, const Object&) { id = each; });
    Object ball = b.scene().objects.at(id);
    change(ball);
    b.scene().objects.set(id, ball);
    return answerTo(b.scene());
}

TEST(Hostile, ShapesWithoutVolumeAreLeftOutByName) {
    const double nan = std::nan("");
    const std::vector<Shape> flat = {Sphere{0},     Box{{1, 0, 1}}, Cylinder{0, 1},
                                     Cone{1, 0},    Disk{0},        Quad{{0, 1}},
                                     Torus{0, 0.2}, Sphere{nan},    Sphere{kInfinity}};
    for (const Shape& shape : flat) {
        const Answer answer = answerToBall([&](Object& ball) { ball.shape = shape; });
        EXPECT_TRUE(answer.drawn);
        EXPECT_NE(answer.text.find("Object 2"), std::string::npos)
            << kindOf(shape) << ": " << answer.text;
        EXPECT_GT(meanOf(answer), 0.3);
    }
}

TEST(Hostile, TransformsThatAreNoneAreLeftOutByName) {
    const double nan = std::nan("");
    const auto expectLeftOut = [](auto&& change) {
        const Answer answer = answerToBall(change);
        EXPECT_TRUE(answer.drawn);
        EXPECT_NE(answer.text.find("Object 2"), std::string::npos) << answer.text;
        EXPECT_GT(meanOf(answer), 0.3);
    };
    expectLeftOut([](Object& o) { o.transform.scale = {1, 0, 1}; });
    expectLeftOut([&](Object& o) { o.transform.scale = {1, nan, 1}; });
    expectLeftOut([&](Object& o) { o.transform.translate = {nan, 0, 0}; });
    expectLeftOut([&](Object& o) { o.transform.translate = {0, kInfinity, 0}; });
    expectLeftOut([&](Object& o) { o.transform.rotateDegrees = {0, 0, nan}; });
    expectLeftOut([](Object& o) { o.transform.matrix = {1, 2, 3, 0, 2, 4, 6, 0, 1, 1, 1, 0}; });
    expectLeftOut([](Object& o) { o.transform.scale = DVec3(1e200); });
    expectLeftOut(
        [](Object& o) { o.transform.scale = DVec3(1e308), o.transform.translate = DVec3(1e308); });
}

/// A sky of radiance 1 around one object of glass.
SceneBuilder furnace(const Shape& shape, const Glass& glass) {
    SceneBuilder b;
    b.object(shape, b.material(glass));
    b.scene().environment.color = Color{1, 1, 1};
    b.scene().render.maxDepth = 200;
    b.film(12, 12, 4);
    return b;
}

/// Length of a ray's way through a shape, by the reference.
double wayThrough(const CanonicalShape& shape, const DVec3& from, const DVec3& direction) {
    const auto roots = std::visit(
        [&](const auto& s) {
            return test::reference::crossings(
                s, test::Line<long double>{test::VecOf<long double>(from),
                                           test::VecOf<long double>(direction)});
        },
        shape);
    double sum = 0;
    for (std::size_t i = 0; i + 1 < roots.size(); i += 2)
        sum += std::max(0.0, static_cast<double>(roots[i + 1])) -
               std::max(0.0, static_cast<double>(roots[i]));
    return sum;
}

TEST(Hostile, CamerasInsideAndOnSurfacesSeeTheRightPicture) {
    // Canonical sizes, so that the object's space is the shape's.
    const std::pair<Shape, CanonicalShape> shapes[] = {{Sphere{1}, CanonicalSphere{}},
                                                       {Box{{2, 2, 2}}, CanonicalBox{}},
                                                       {Cylinder{1, 2}, CanonicalCylinder{}},
                                                       {Cone{1, 2}, CanonicalCone{}},
                                                       {Torus{1, 0.4}, CanonicalTorus{0.4}}};
    const DVec3 places[] = {{0, 0, 0},   {0, 1, 0},     {1, 0, 0},       {0, -1, 0},
                            {1, 0.4, 0}, {0.6, 0.8, 0}, {0.3, -0.2, 0.1}};
    for (const auto& [shape, canonical] : shapes)
        for (const DVec3& place : places)
            for (const DVec3& way : {DVec3(0.9, 0.15, -0.2), DVec3(0.1, -1, 0.25),
                                     DVec3(-0.1, 1, 0.3), DVec3(-0.3, 0.5, 0.9)}) {
                // Index 1: no reflection, no bend, and exp(-length inside) is left of the sky.
                // Roulette makes it 4096 coins.
                SceneBuilder b = furnace(shape, {1.0, Color{1, 1, 1}});
                b.camera(place, place + way, 1e-7);
                b.film(16, 16, 16);
                const Answer answer = answerTo(b.scene());
                ASSERT_TRUE(answer.drawn) << answer.text;
                EXPECT_NEAR(meanOf(answer),
                            std::exp(-wayThrough(canonical, place, glm::normalize(way))), 0.03)
                    << kindOf(shape) << " from " << place.x << ' ' << place.y << ' ' << place.z
                    << " along " << way.x << ' ' << way.y << ' ' << way.z;
            }
}

TEST(Hostile, ACameraWithoutADirectionIsRefused) {
    const double nan = std::nan("");
    const auto expectRefused = [](auto&& change) {
        SceneBuilder b = litScene();
        change(b.scene().camera);
        const Answer answer = answerTo(b.scene());
        EXPECT_FALSE(answer.drawn);
        EXPECT_NE(answer.text.find("camera"), std::string::npos) << answer.text;
    };
    expectRefused([](Camera& c) { c.target = c.position; });
    expectRefused([](Camera& c) { c.up = c.target - c.position; });
    expectRefused([](Camera& c) { c.up = DVec3(0.0); });
    expectRefused([&](Camera& c) { c.position.x = nan; });
    expectRefused([](Camera& c) { c.target.y = kInfinity; });
    expectRefused([](Camera& c) { c.verticalFovDegrees = 180; });
    expectRefused([](Camera& c) { c.verticalFovDegrees = 0; });
}

TEST(Hostile, NarrowAndWideViewsAndSmallFilmsAreDrawn) {
    for (const double fov : {0.001, 179.0, 179.999}) {
        SceneBuilder b = litScene();
        b.scene().camera.verticalFovDegrees = fov;
        const Answer answer = answerTo(b.scene());
        EXPECT_TRUE(answer.drawn);
        EXPECT_GT(meanOf(answer), 0.05) << fov;
    }
    for (const auto& [width, height] : {std::pair{1, 1}, {1, 300}, {300, 1}}) {
        SceneBuilder b = litScene();
        b.film(width, height, 2);
        EXPECT_GT(meanOf(answerTo(b.scene())), 0.05);
    }
    SceneBuilder up = litScene();
    up.camera({3, 0.5, 0}, {3, 8, 0}, 60);  // straight up into the sky
    EXPECT_NEAR(meanOf(answerTo(up.scene())), 1, 1e-6);
}

TEST(Hostile, StrangeGlassKeepsTheFurnaceWhite) {
    for (const double ior : {1.0, 1 + 1e-12, 0.5, 1e-3, 3.0, 1e3}) {
        SceneBuilder b = furnace(Sphere{1}, {ior});
        b.camera({0, 0.3, 4}, {0, 0, 0}, 40);
        const Answer answer = answerTo(b.scene());
        ASSERT_TRUE(answer.drawn);
        EXPECT_NEAR(meanOf(answer), 1, 0.05) << "index " << ior;
    }
}

TEST(Hostile, AbsorptionOfAMillionIsBlackAndOfZeroIsClear) {
    SceneBuilder b;
    b.object(Sphere{1}, b.material(Glass{1.0, Color{1e6, 1e6, 0}}));
    b.scene().environment.color = Color{1, 1, 1};
    b.camera({0, 0, 4}, {0, 0, 0}, 10);
    b.film(8, 8, 4);
    const Answer answer = answerTo(b.scene());
    EXPECT_LT(test::estimateMean(answer.rendering.beauty, 0).mean, 1e-6);
    EXPECT_NEAR(test::estimateMean(answer.rendering.beauty, 2).mean, 1, 1e-6);
}

TEST(Hostile, DimAndBrightLightsKeepTheirRatio) {
    // More lamps than are all sampled at once, so that their powers are added up too.
    const auto litBy = [](double radiance, double size) {
        SceneBuilder b;
        b.object(Plane{}, b.material(Diffuse{}));
        for (int i = 0; i < 6; ++i)
            b.object(Sphere{0.4 * size}, {}, size * DVec3(i - 2.5, 3, 0),
                     {radiance, radiance, radiance});
        b.camera(size * DVec3(0, 2, 6), DVec3(0.0), 40);
        b.film(8, 8, 4);
        return meanOf(answerTo(b.scene()));
    };
    const double one = litBy(1, 1);
    for (const double size : {1.0, 1e9, 1e-9, 1e60, 1e-60})
        for (const double radiance : {1e-30, 1.0, 1e30})
            EXPECT_NEAR(litBy(radiance, size) / radiance, one, 1e-4 * one)
                << radiance << " at size " << size;
}

TEST(Hostile, SizesNearTheEndsOfDoubleAreLeftOutByName) {
    for (const double radius : {1e-320, 1e-200, 1e-91, 1e91, 1e200, 1e308}) {
        const Answer answer = answerToBall([&](Object& ball) { ball.shape = Sphere{radius}; });
        EXPECT_TRUE(answer.drawn);
        EXPECT_NE(answer.text.find("Object 2"), std::string::npos) << radius << ": " << answer.text;
        EXPECT_NE(answer.text.find("left out"), std::string::npos) << radius << ": " << answer.text;
    }
    for (const double distance : {1e-91, 1e91, 1e200}) {
        SceneBuilder b = litScene();
        b.camera({0, 0, 0}, {0, 0, distance}, 40);
        const Answer answer = answerTo(b.scene());
        EXPECT_FALSE(answer.drawn);
        EXPECT_NE(answer.text.find("too near to its target or too far"), std::string::npos)
            << answer.text;
    }
}

/// A hundred groups in each other, half of which undo the other half, mirrors and a stretch of 1e6
/// to 1 among them: the ball is where it would be without.
TEST(Hostile, AHundredNestedGroupsAreOneTransform) {
    const auto picture = [](int depth) {
        SceneBuilder b = litScene();
        GroupId parent;
        for (int i = 0; i < depth; ++i) {
            const bool undo = i >= depth / 2;
            const int k = undo ? depth - 1 - i : i;
            const DVec3 scale =
                k == 7 ? DVec3(1e6, 1, 1) : DVec3(k % 2 ? -1.25 : 0.8, 1, k % 3 ? 2 : 0.5);
            const double angle = k % 5 == 0 ? 90 : 0;
            // Out: turn after stretch; back: the stretch undone after the turn.
            for (const bool turn : {undo, !undo}) {
                Group group{.name = "G" + std::to_string(2 * i + (turn ? 1 : 0)), .parent = parent};
                if (turn)
                    group.transform.rotateDegrees.y = undo ? -angle : angle;
                else
                    group.transform.scale = undo ? 1.0 / scale : scale;
                parent = b.scene().groups.add(group);
            }
        }
        ObjectId id;
        b.scene().objects.forEach([&](ObjectId each, const Object&) { id = each; });
        Object ball = b.scene().objects.at(id);
        ball.parent = parent;
        b.scene().objects.set(id, ball);
        return answerTo(b.scene());
    };
    const Answer plain = picture(0), nested = picture(100);
    ASSERT_TRUE(nested.drawn) << nested.text;
    EXPECT_EQ(nested.text, plain.text);
    EXPECT_NEAR(meanOf(nested), meanOf(plain), 1e-4);
}

/// Fourteen balls of absorbing glass within each other, all of index 1: what is left of the sky
/// depends on the way through the outermost alone.
TEST(Hostile, ManyNestedMediaAreTracked) {
    SceneBuilder b;
    const MaterialId glass = b.material(Glass{1.0, Color{0.5, 0.5, 0.5}});
    for (int i = 0; i < 14; ++i) b.object(Sphere{1 - 0.05 * i}, glass);
    b.scene().environment.color = Color{1, 1, 1};
    b.scene().render.maxDepth = 200;
    b.camera({0, 0.1, 4}, {0, 0.1, 0}, 1e-7);
    b.film(16, 16, 16);
    const Answer answer = answerTo(b.scene());
    ASSERT_TRUE(answer.drawn) << answer.text;
    EXPECT_NEAR(meanOf(answer),
                std::exp(-0.5 * wayThrough(CanonicalSphere{}, {0, 0.1, 4}, {0, 0, -1})), 0.01);
}

TEST(Hostile, ThreadsGiantsAndCrowdsAreDrawn) {
    SceneBuilder b = litScene();
    const MaterialId glass = b.material(Glass{1.5, Color{}, 0.3});
    b.object(Cylinder{1e-9, 10}, glass, {0, 1, 1});
    b.object(Torus{1, 1e-6}, glass, {0, 1, 1});
    b.object(Torus{1e-3, 1}, glass, {2, 1, 0});
    b.object(Box{{1e-9, 1e9, 1}}, glass, {3, 0, 0});
    b.object(Cone{1e6, 1e-6}, glass, {0, 5, 0}, {1, 1, 1});
    b.object(Sphere{1e9}, glass, {0, -1e9, 0});
    for (int i = 0; i < 20; ++i)
        b.object(Sphere{1.0 + 0.01 * i}, glass, {0, 1, 0});  // deeper than the stack of media
    EXPECT_GT(meanOf(answerTo(b.scene())), 0.01);
}

}  // namespace
}  // namespace glint
