// The picture does not depend on the number of threads, on the kernel, or on being cut out of a
// larger one.
#include <gtest/gtest.h>

#include "tests/support/scenes.h"
#include "tracer/render/kernel.h"
#include "tracer/render/layers.h"

namespace glint {
namespace {

using test::SceneBuilder;

SceneBuilder stillLife(Integrator integrator) {
    SceneBuilder b;
    const MaterialId grey = b.material(Diffuse{}), mirror = b.material(Mirror{});
    const MaterialId glass = b.material(Glass{1.5, Color{0.5, 0.1, 0.2}});
    b.object(Plane{}, grey);
    b.object(Sphere{1}, mirror, {-1.2, 1, 0});
    b.object(Sphere{1}, glass, {1.2, 1, 0});
    b.object(Box{{1, 1, 1}}, b.material(Mix{{grey, false}, {{}, true}, 0.4}), {0, 0.5, 1.5});
    b.object(Sphere{0.4}, {}, {0, 4, 1}, {20, 20, 20});
    b.pointLight({2, 3, 2}, {10, 9, 8});
    b.scene().environment.color = Color{0.2, 0.3, 0.4};
    b.camera({0, 2, 6}, {0, 0.8, 0}, 40);
    b.film(50, 37, 5);
    b.scene().render.integrator = integrator;
    return b;
}

class Determinism : public testing::TestWithParam<Integrator> {};

TEST_P(Determinism, OneTwoThreeAndEightThreadsGiveTheSameBits) {
    const SceneBuilder b = stillLife(GetParam());
    const Image one = b.render(1).beauty;
    for (const int threads : {2, 3, 8})
        EXPECT_EQ(b.render(threads).beauty.rgb, one.rgb) << threads << " threads";
}

TEST_P(Determinism, ACropHasTheBitsOfTheWhole) {
    const SceneBuilder b = stillLife(GetParam());
    const auto scene = b.compile();
    const Image whole = render(scene, {.threads = 2}).beauty;
    const PixelRect rect{7, 5, 20, 18};
    const Image crop = render(scene, {.threads = 2, .crop = rect}).beauty;
    for (int y = 0; y < crop.height; ++y)
        for (int x = 0; x < crop.width; ++x) {
            const bool inside =
                x >= rect.x && x < rect.x + rect.width && y >= rect.y && y < rect.y + rect.height;
            ASSERT_EQ(test::pixelAt(crop, x, y), inside ? test::pixelAt(whole, x, y) : Rgb(0.0f))
                << x << ", " << y;
        }
}

TEST_P(Determinism, OneSampleIsThatOfTheRender) {
    SceneBuilder b = stillLife(GetParam());
    b.scene().render.spp = 1;
    const auto scene = b.compile();
    const Image image = render(scene, {.threads = 1}).beauty;
    EXPECT_EQ(renderSample(*scene, {20, 20, 0}), test::pixelAt(image, 20, 20));
}

INSTANTIATE_TEST_SUITE_P(Both, Determinism, testing::Values(Integrator::Path, Integrator::Classic),
                         [](const auto& tested) {
                             return tested.param == Integrator::Path ? "Path" : "Classic";
                         });

TEST(Kernels, EveryKernelThatCoversASceneGivesTheSameBits) {
    SceneBuilder b;
    b.object(Plane{}, b.material(Diffuse{}));
    b.object(Sphere{1}, b.material(Phong{}), {0, 1, 0});
    b.object(Sphere{0.4}, {}, {0, 4, 1}, {20, 20, 20});
    b.pointLight({2, 3, 2}, {10, 9, 8});
    b.camera({0, 2, 6}, {0, 0.8, 0}, 40);
    const auto scene = b.compile();
    int compared = 0;
    for (const Kernel& kernel : allKernels()) {
        if (kernel.integrator != Integrator::Path || (scene->features & ~kernel.features) != 0)
            continue;
        for (int i = 0; i < 400; ++i) {
            LayerSample layers;
            KernelState chosen{*scene, {}, {}, false}, other{*scene, {}, {}, false, &layers};
            const int x = i % 20 + 6, y = i / 20 + 6;
            ASSERT_EQ(chooseKernel(*scene).run(chosen, x, y, 3), kernel.run(other, x, y, 3))
                << kernel.name << " at " << x << ", " << y;
        }
        ++compared;
    }
    EXPECT_GE(compared, 4);
}

}  // namespace
}  // namespace glint
