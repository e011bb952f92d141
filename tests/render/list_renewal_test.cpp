// Shapes that have moved get a hierarchy of their own beside the render, and the picture keeps its
// bits.
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "tests/support/films.h"
#include "tests/support/scenes.h"
#include "tracer/render/living_picture.h"

namespace glint {
namespace {

using test::SceneBuilder;
using test::wishFor;

/// So many balls on a floor that they have a hierarchy.
Scene crowd() {
    SceneBuilder b;
    const MaterialId clay = b.material(Diffuse{});
    for (int i = 0; i < 200; ++i)
        b.object(Sphere{0.1}, clay, {0.3 * (i % 20) - 3, 0.1, 0.3 * (i / 20) - 3});
    b.object(Plane{}, clay);
    b.scene().environment.color = Color{0.2, 0.3, 0.4};
    b.camera({0, 2, 6}, {0, 0.8, 0}, 40);
    b.film(24, 18, 1 << 20);
    return b.scene();
}

Scene dragged(Scene scene) {
    const ObjectId id = scene.objects.ids().front();
    Object object = scene.objects.at(id);
    object.transform.translate.x += 0.2;
    scene.objects.set(id, object);
    return scene;
}

/// Does `step` until `done`; false if that takes too long.
template <class Step, class Done>
bool repeat(const Step& step, const Done& done) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (!done()) {
        if (std::chrono::steady_clock::now() > end) return false;
        step();
    }
    return true;
}

TEST(ListRenewal, ShapesThatMovedGetTheirOwnHierarchyAndThePictureKeepsItsBits) {
    Scene scene = crowd();
    WorkerPool pool(2);
    LivingPicture picture(pool);
    const auto lists = [&]() -> const ShapeLists& { return *picture.picture().scene->lists; };
    const auto renderUntil = [&](const auto& done) {
        return repeat([&] { picture.render({1e-3, 1e-3}, {}); }, done);
    };
    picture.takeUp(wishFor(scene));
    ASSERT_TRUE(renderUntil([&] { return picture.picture().spp >= 2; }));
    ASSERT_TRUE(lists().hasHierarchy());
    EXPECT_FALSE(lists().hasMoved());
    scene = dragged(scene);
    picture.takeUp(wishFor(scene));
    EXPECT_TRUE(lists().hasMoved());
    ASSERT_TRUE(renderUntil([&] { return !lists().hasMoved(); }));
    ASSERT_TRUE(lists().hasHierarchy());

    scene.render.spp = picture.picture().spp + 3;
    picture.takeUp(wishFor(scene));
    EXPECT_EQ(picture.retracedShare(), 0);
    test::finish(picture);
    EXPECT_FALSE(
        test::firstDifference(picture.picture().film, test::renderedFromNothing(scene, pool)));
}

/// What was built while shapes moved on is not for where they are now.
TEST(ListRenewal, AHierarchyOfBeforeIsLeftUnused) {
    AssetCache assets;
    const auto compiled = [&](const Scene& scene,
                              const std::shared_ptr<const RenderScene>& before) {
        return compile(scene, {}, assets, before).value().scene;
    };
    const Scene scene = crowd();
    const auto still = compiled(scene, nullptr), second = compiled(dragged(scene), still),
               third = compiled(dragged(dragged(scene)), second);
    ASSERT_TRUE(second->lists->hasMoved() && third->lists->hasMoved());

    ListRenewal renewal;
    renewal.begin(*still);
    EXPECT_FALSE(renewal.isBusy()) << "nothing has moved";
    renewal.begin(*second);
    EXPECT_TRUE(renewal.isBusy());
    const auto wait = [] { std::this_thread::sleep_for(std::chrono::milliseconds(1)); };
    std::shared_ptr<const RenderScene> renewed;
    EXPECT_TRUE(repeat(wait, [&] {
        renewed = renewal.finish(*third);
        return !renewal.isBusy();
    }));
    EXPECT_FALSE(renewed);
    renewal.begin(*third);
    ASSERT_TRUE(repeat(wait, [&] { return (renewed = renewal.finish(*third)) != nullptr; }));
    EXPECT_FALSE(renewed->lists->hasMoved());
    EXPECT_FALSE(renewal.isBusy());
}

}  // namespace
}  // namespace glint
