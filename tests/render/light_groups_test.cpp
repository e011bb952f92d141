// What a sample records beside its value: light by group, and the materials that it rests on.
#include <gtest/gtest.h>

#include "tests/support/scenes.h"
#include "tracer/render/edit_plan.h"
#include "tracer/render/kernel.h"

namespace glint {
namespace {

using test::SceneBuilder;

/// A lamp, a point light and an evenly bright sky over a glass and a diffuse ball.
SceneBuilder threeSources() {
    SceneBuilder b;
    b.object(Plane{}, b.material(Diffuse{}));
    b.object(Sphere{1}, b.material(Glass{}), {-1, 1, 0});
    b.object(Sphere{1}, b.material(Diffuse{}), {1.2, 1, 0});
    b.object(Sphere{0.5}, {}, {0, 4, 1}, {9, 8, 7});
    b.pointLight({2, 3, 2}, {10, 9, 8});
    b.scene().environment.color = Color{0.4, 0.5, 0.6};
    b.camera({0, 2, 6}, {0, 0.8, 0}, 40);
    return b;
}

/// Calls visit(value, groups, materials) for some samples of every pixel.
template <class Visit>
void forEachSample(const RenderScene& scene, Visit&& visit) {
    GroupLight groups{};
    KernelState state{.scene = scene, .groups = &groups};
    for (int y = 0; y < scene.film.height; ++y)
        for (int x = 0; x < scene.film.width; ++x)
            for (std::uint32_t i = 0; i < 4; ++i) {
                const Rgb value = chooseKernel(scene).run(state, x, y, i);
                visit(value, groups, state.materials);
            }
}

class EveryIntegrator : public testing::TestWithParam<Integrator> {};

TEST_P(EveryIntegrator, GroupsSumToTheSample) {
    SceneBuilder b = threeSources();
    b.scene().render.integrator = GetParam();
    const auto scene = b.compile();
    ASSERT_EQ(scene->lightGroups, 3u);
    std::array<bool, kMaxLightGroups> seen{};
    forEachSample(*scene, [&](const Rgb& value, const GroupLight& groups, std::uint64_t) {
        Rgb sum(0.0f);
        for (std::size_t g = 0; g < groups.size(); ++g) {
            sum += groups[g];
            seen[g] = seen[g] || !isBlack(groups[g]);
        }
        for (int c = 0; c < 3; ++c) ASSERT_NEAR(sum[c], value[c], 1e-5f * value[c]);
    });
    EXPECT_EQ(seen, (std::array{true, true, true, false}));
}

/// A sample that does not name a material keeps its bits whatever its values become, as far as the
/// scene keeps its structure.
TEST_P(EveryIntegrator, SamplesRestOnTheMaterialsThatTheyName) {
    SceneBuilder b = threeSources();
    b.scene().render.integrator = GetParam();
    std::vector<std::pair<Rgb, std::uint64_t>> before;
    const auto scene = b.compile();
    forEachSample(*scene, [&](const Rgb& value, const GroupLight&, std::uint64_t materials) {
        before.emplace_back(value, materials);
    });
    for (const MaterialId id : b.scene().materials.ids()) {
        SceneBuilder edited = b;
        Material material = edited.scene().materials.at(id);
        if (auto* glass = std::get_if<Glass>(&material.value))
            glass->absorption.value = Color{0.5, 0.2, 0.9};
        else
            material.value = Diffuse{Color{0.1, 0.2, 0.3}};
        edited.scene().materials.set(id, material);
        std::size_t i = 0, changed = 0, named = 0;
        const auto after = edited.compile();
        ASSERT_TRUE(sameStructure(*scene, *after));
        forEachSample(*after, [&](const Rgb& value, const GroupLight&, std::uint64_t) {
            const bool rests = before[i].second & materialBit(id);
            if (!rests) {
                ASSERT_EQ(value, before[i].first) << "sample " << i;
            }
            named += rests;
            changed += value != before[i++].first;
        });
        EXPECT_GT(changed, named / 4) << "the recorded sets are far too large";
        EXPECT_LT(named, i);
    }
}

INSTANTIATE_TEST_SUITE_P(Kernels, EveryIntegrator,
                         testing::Values(Integrator::Path, Integrator::Classic));

TEST(LightGroups, NamesGatherSourcesAndTheRestStandsAlone) {
    Scene scene = threeSources().scene();
    EXPECT_EQ(LightGroups(scene).count(), 3u);
    scene.environment.lightGroup = "Sky and lamp";
    const ObjectId lamp = scene.objects.ids().back();
    Object named = scene.objects.at(lamp);
    named.lightGroup = "Sky and lamp";
    scene.objects.set(lamp, named);
    const LightGroups groups(scene);
    EXPECT_EQ(groups.count(), 2u);
    EXPECT_EQ(groups.of(lamp), groups.ofEnvironment());
    EXPECT_NE(groups.of(scene.lights.ids().front()), groups.ofEnvironment());
    for (int i = 0; i < 3; ++i)
        scene.lights.add({"More " + std::to_string(i), PointLight{}, true, ""});
    const LightGroups many(scene);
    EXPECT_EQ(many.count(), 2u) << "four lamps without a group share one";
    EXPECT_EQ(many.of(scene.lights.ids().front()), many.of(scene.lights.ids().back()));
}

TEST(LightGroups, AMixIsOneFactorAGroup) {
    const Scene before = threeSources().scene();
    const LightGroups groups(before);
    Scene after = before;
    after.environment.intensity = 3;
    const LightId id = after.lights.ids().front();
    Light light = after.lights.at(id);
    lightColor(light) = {20, 9, 0};
    after.lights.set(id, light);
    const auto mix = lightMixBetween(before, after, groups);
    ASSERT_TRUE(mix);
    EXPECT_LT(glm::length(mix->gain[groups.ofEnvironment()] - DVec3(3)), 1e-14);
    EXPECT_EQ(mix->gain[groups.of(id)], DVec3(2, 1, 0));
    EXPECT_FALSE(lightMixBetween(after, before, LightGroups(after)))
        << "blue has no light to make more of";
    light.visible = false;
    after.lights.set(id, light);
    EXPECT_EQ(lightMixBetween(before, after, groups)->gain[groups.of(id)], DVec3(0.0));
}

TEST(LightGroups, SourcesOfOneGroupMustChangeAlike) {
    Scene before = threeSources().scene();
    for (int i = 0; i < 4; ++i)
        before.lights.add({"More " + std::to_string(i), PointLight{}, true, "Stage"});
    const LightGroups groups(before);
    Scene after = before;
    const LightId id = after.lights.ids().back();
    Light light = after.lights.at(id);
    lightColor(light) = {1, 1, 1};
    after.lights.set(id, light);
    EXPECT_FALSE(lightMixBetween(before, after, groups));
}

}  // namespace
}  // namespace glint
