// What a scene lacks costs it nothing: every skip's count is exactly 0 where it holds, and the
// picture is the same to the bit when the work is done all the same.
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "tests/support/paths.h"
#include "tests/support/scenes.h"
#include "tracer/compile/compiler.h"
#include "tracer/io/scene_json.h"
#include "tracer/render/render.h"
#include "tracer/render/skips.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

/// Every scene that comes with Glint, and some that hold nothing of a kind.
std::vector<std::shared_ptr<const RenderScene>> scenes() {
    std::vector<std::shared_ptr<const RenderScene>> out;
    AssetCache assets;
    const auto add = [&](Scene scene, const fs::path& folder) {
        scene.film.width = 24, scene.film.height = 16;
        scene.render.spp = 4;
        scene.render.timeSeconds = scene.render.errorPercent = 0;
        auto compiled = compile(scene, folder, assets);
        ASSERT_TRUE(compiled) << compiled.error().text();
        out.push_back(compiled.value().scene);
    };
    for (const fs::path& folder : {test::inSource("scenes/demo"), test::inSource("scenes/verify")})
        for (const auto& file : fs::directory_iterator(folder)) {
            auto loaded = loadScene(file.path());
            EXPECT_TRUE(loaded) << loaded.error().text();
            for (const Integrator integrator : {Integrator::Path, Integrator::Classic}) {
                Scene scene = loaded.value();
                scene.render.integrator = integrator;
                add(scene, folder);
            }
        }
    add(Scene{}, {});
    test::SceneBuilder balls;
    balls.object(Sphere{1}, balls.material(Diffuse{}));
    balls.pointLight({2, 3, 2}, {10, 9, 8});
    balls.camera({0, 2, 6}, {0, 0, 0}, 40);
    balls.scene().render.maxDepth = 1;
    add(balls.scene(), {});
    for (int i = 0; i < 200; ++i) balls.object(Sphere{0.1}, {}, {i % 20 - 10, 0, i / 20 - 10});
    add(balls.scene(), {});
    test::SceneBuilder glass;
    glass.object(Plane{}, glass.material(Diffuse{}));
    glass.object(Sphere{1}, glass.material(Glass{}), {0, 1, 0});
    glass.object(Box{{0.4, 0.4, 0.4}}, glass.material(Diffuse{}), {0.2, 1, 0});
    glass.pointLight({2, 5, 2}, {30, 30, 30});
    glass.camera({0, 3, 6}, {0, 0.5, 0}, 40);
    glass.scene().render.integrator = Integrator::Classic;
    glass.scene().render.transparentShadows = true;
    add(glass.scene(), {});
    return out;
}

TEST(Skips, CountNothingWhereTheyHoldAndChangeNoBit) {
    std::set<std::string_view> held, forced;
    for (const auto& scene : scenes()) {
        const Rendering spared = render(scene, {.threads = 1});
        const Rendering full = render(scene, {.threads = 1, .kernel = KernelChoice::Full});
        const Rendering all = render(scene, {.threads = 1, .kernel = KernelChoice::NoSkips});
        EXPECT_EQ(spared.beauty.rgb, full.beauty.rgb) << spared.kernel;
        EXPECT_EQ(spared.beauty.rgb, all.beauty.rgb) << spared.kernel;
        for (const Skip& skip : allSkips()) {
            if (!skip.holds(*scene)) continue;
            held.insert(skip.name);
            EXPECT_EQ(spared.work[skip.count], 0u) << skip.name << ", " << spared.kernel;
            EXPECT_EQ(full.work[skip.count], 0u) << skip.name << ", " << full.kernel;
            if (all.work[skip.count] > 0) forced.insert(skip.name);
        }
    }
    EXPECT_EQ(held.size(), allSkips().size()) << "a skip that no scene shows";
    // What kernels decide while they run can be forced; what a scene has no data for cannot.
    for (const char* name :
         {"light that cannot count: no shadow ray", "clear media: no exponentials",
          "opaque surfaces: shadow rays end at any hit", "one light: no choice",
          "no sky: lost rays end at nothing", "no emissive shapes: hits are not asked for light"})
        EXPECT_TRUE(forced.contains(name)) << name;
}

TEST(Skips, EveryCountIsReachedBySomeScene) {
    WorkCounts sum;
    for (const auto& scene : scenes())
        sum += render(scene, {.threads = 1, .kernel = KernelChoice::NoSkips}).work;
    for (std::size_t i = 0; i < kWorkKinds; ++i) {
        // Only edits of a living picture leave hits known: first_hits_test.cpp.
        if (i == static_cast<std::size_t>(Work::KnownHits))
            EXPECT_EQ(sum.of[i], 0u);
        else
            EXPECT_GT(sum.of[i], 0u) << kWorkNames[i];
    }
}

}  // namespace
}  // namespace glint
