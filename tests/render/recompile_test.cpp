// What an edit builds anew, and that what it keeps gives the bits of a compile from nothing.
#include <gtest/gtest.h>

#include <functional>

#include "tests/support/scenes.h"
#include "tracer/compile/view.h"

namespace glint {
namespace {

using test::SceneBuilder;

/// A glass ball, `balls` more and a box, a lamp and a sky.
SceneBuilder crowd(int balls) {
    SceneBuilder b;
    const MaterialId clay = b.material(Diffuse{});
    b.object(Sphere{1}, b.material(Glass{}), {0, 1, 0});
    b.object(Box{}, clay, {-2, 0.5, 0});
    b.object(Sphere{0.3}, {}, {0, 4, 1}, {20, 20, 20});
    for (int i = 0; i < balls; ++i)
        b.object(Sphere{0.1}, clay, {0.3 * (i % 20) - 3, 0.1, 0.3 * (i / 20) - 3});
    b.scene().environment.color = Color{0.2, 0.3, 0.4};
    b.camera({0, 2, 6}, {0, 0.8, 0}, 40);
    b.film(40, 30, 1);
    return b;
}

Compiled compileAfter(const Scene& scene, const std::shared_ptr<const RenderScene>& previous) {
    AssetCache assets;
    return compile(scene, {}, assets, previous).value();
}

TEST(Recompile, AnotherViewIsTheSameSceneAndHasTheBitsOfACompile) {
    const std::function<void(Scene&)> edits[] = {
        [](Scene& s) {
            s.camera.position = {3, 1, 4};
        },
        [](Scene& s) {
            s.camera.position = {0.2, 1.1, 0.3};
        },  // in the glass
        [](Scene& s) { s.camera.apertureRadius = 0.2; },
        [](Scene& s) { s.camera.projection = Projection::Orthographic; },
        [](Scene& s) { s.film.width = 57; },
        [](Scene& s) { s.film.filterRadius = 2; },
    };
    const SceneBuilder b = crowd(200);
    SceneBuilder edited = b;
    std::shared_ptr<const RenderScene> seen = b.compile();
    for (const auto& edit : edits) {
        const Scene before = edited.scene();
        edit(edited.scene());
        ASSERT_TRUE(sameButView(before, edited.scene()));
        auto next = withView(*seen, edited.scene());
        ASSERT_TRUE(next.ok());
        EXPECT_EQ(next.value()->lists, seen->lists);
        seen = next.value();
        const auto fresh = edited.compile();
        EXPECT_EQ(seen->features, fresh->features);
        EXPECT_EQ(render(seen, {.threads = 2}).beauty.rgb,
                  render(fresh, {.threads = 2}).beauty.rgb);
    }
    edited.scene().camera.target = edited.scene().camera.position;
    EXPECT_FALSE(withView(*seen, edited.scene()).ok());
}

TEST(Recompile, WhatIsNotTheViewIsNoViewEdit) {
    const SceneBuilder b = crowd(3);
    const std::function<void(Scene&)> edits[] = {
        [](Scene& s) { s.render.seed = 1; },
        [](Scene& s) { s.environment.intensity = 2; },
        [](Scene& s) { s.objects.erase(s.objects.ids().back()); },
        [](Scene& s) {
            s.materials.set(s.materials.ids().front(), {"Other", Mirror{}});
        },
    };
    for (const auto& edit : edits) {
        SceneBuilder edited = b;
        edit(edited.scene());
        SceneBuilder original = b;
        EXPECT_FALSE(sameButView(original.scene(), edited.scene()));
    }
}

TEST(Recompile, AMaterialBuildsNoListsAndAMoveRefitsThem) {
    SceneBuilder b = crowd(200);
    Compiled compiled = compileAfter(b.scene(), nullptr);
    EXPECT_EQ(compiled.stats.shapeListsBuilt, 1);
    b.scene().materials.set(b.scene().materials.ids().front(),
                            {"Clay", Diffuse{.color = Color{0.1, 0.2, 0.3}}});
    const Compiled colored = compileAfter(b.scene(), compiled.scene);
    EXPECT_EQ(colored.stats.shapeListsBuilt + colored.stats.shapeListsRefitted, 0);
    EXPECT_EQ(colored.scene->lists, compiled.scene->lists);

    const ObjectId ball = b.scene().objects.ids().back();
    for (int step = 0; step < 5; ++step) {
        Object moved = b.scene().objects.at(ball);
        moved.transform.translate.x += 0.1;
        b.scene().objects.set(ball, moved);
        compiled = compileAfter(b.scene(), compiled.scene);
        EXPECT_EQ(compiled.stats.shapeListsBuilt, 0);
        EXPECT_EQ(compiled.stats.shapeListsRefitted, 1);
        EXPECT_EQ(render(compiled.scene, {.threads = 2}).beauty.rgb,
                  render(b.compile(), {.threads = 2}).beauty.rgb);
    }
    b.scene().objects.erase(ball);
    EXPECT_EQ(compileAfter(b.scene(), compiled.scene).stats.shapeListsBuilt, 1);
}

}  // namespace
}  // namespace glint
