// Which edits keep which samples.
#include <gtest/gtest.h>

#include "tests/support/random_scene.h"
#include "tests/support/scenes.h"
#include "tracer/render/edit_plan.h"

namespace glint {
namespace {

using test::SceneBuilder;
using Kind = EditPlan::Kind;

struct Stage {
    SceneBuilder b;
    MaterialId floor = b.material(Diffuse{}), glass = b.material(Glass{}),
               clay = b.material(Diffuse{}), blend = b.material(Mix{});
    ObjectId plane = b.object(Plane{}, floor), ball = b.object(Sphere{1}, glass, {-1, 1, 0}),
             lamp = b.object(Sphere{0.5}, {}, {0, 4, 1}, {9, 8, 7});

    Stage() {
        b.pointLight({2, 3, 2}, {10, 9, 8});
        b.scene().environment.color = Color{0.4, 0.5, 0.6};
        Material mix = b.scene().materials.at(blend);
        std::get<Mix>(mix.value).a = {clay};
        b.scene().materials.set(blend, mix);
    }
    /// The plan for an edit: `change(scene)`.
    template <class Change>
    [[nodiscard]] EditPlan plan(Change change) const {
        SceneBuilder copy = b;
        const Scene before = copy.scene();
        change(copy.scene());
        return planEdit(before, copy.scene(), LightGroups(before));
    }
    template <class Change>
    [[nodiscard]] EditPlan objectPlan(ObjectId id, Change change) const {
        return plan([&](Scene& scene) {
            Object object = scene.objects.at(id);
            change(object);
            scene.objects.set(id, object);
        });
    }
};

TEST(EditPlan, WhatDoesNotShowKeepsAllSamples) {
    const Stage stage;
    const auto keeps = [](const EditPlan& plan) {
        return plan.kind == Kind::Keep && plan.mix.isUnit();
    };
    EXPECT_TRUE(keeps(stage.plan([](Scene&) {})));
    EXPECT_TRUE(keeps(stage.objectPlan(stage.ball, [](Object& o) { o.name = "Other"; })));
    EXPECT_TRUE(keeps(stage.objectPlan(stage.ball, [](Object& o) { o.locked = true; })));
    EXPECT_TRUE(keeps(stage.objectPlan(stage.lamp, [](Object& o) { o.lightGroup = "Lamps"; })));
    EXPECT_TRUE(keeps(stage.plan([](Scene& s) { s.display.exposureEv = 2; })));
    EXPECT_TRUE(keeps(stage.plan([](Scene& s) { s.views.push_back({}); })));
    EXPECT_TRUE(keeps(stage.plan([](Scene& s) { s.editor = "{}"; })));
    EXPECT_TRUE(keeps(stage.plan([](Scene& s) { s.cameras.add({}); })));
    EXPECT_TRUE(keeps(stage.plan([](Scene& s) { s.groups.add({"Empty"}); })));
    EXPECT_TRUE(keeps(stage.plan([&](Scene& s) {
        Object grouped = s.objects.at(stage.ball);
        grouped.parent = s.groups.add({"Group"});
        s.objects.set(stage.ball, grouped);
    })));
    EXPECT_TRUE(keeps(stage.plan([](Scene& s) { s.camera.name = "Eye"; })));
    EXPECT_TRUE(keeps(stage.plan(
        [](Scene& s) { s.render.spp = 7, s.render.timeSeconds = 1, s.render.errorPercent = 1; })));
    EXPECT_TRUE(keeps(stage.plan(
        [](Scene& s) { s.objects.add({.name = "Hidden", .shape = Sphere{}, .visible = false}); })));
}

TEST(EditPlan, WhatShowsRestarts) {
    const Stage stage;
    EXPECT_EQ(stage.objectPlan(stage.ball, [](Object& o) { o.transform.translate.x = 1; }).kind,
              Kind::Restart);
    EXPECT_EQ(stage
                  .plan([&](Scene& s) {
                      Object grouped = s.objects.at(stage.ball);
                      grouped.parent =
                          s.groups.add({.name = "Aside", .transform = {.translate = {1, 0, 0}}});
                      s.objects.set(stage.ball, grouped);
                  })
                  .kind,
              Kind::Restart);
    EXPECT_EQ(stage.objectPlan(stage.ball, [](Object& o) { o.shape = Box{}; }).kind, Kind::Restart);
    EXPECT_EQ(stage.objectPlan(stage.ball, [](Object& o) { o.visible = false; }).kind,
              Kind::Restart);
    EXPECT_EQ(stage.objectPlan(stage.ball,
                               [](Object& o) {
                                   o.emission = {1, 1, 1};
                               })
                  .kind,
              Kind::Restart);
    EXPECT_EQ(stage.plan([](Scene& s) { s.camera.position.x += 1; }).kind, Kind::Restart);
    EXPECT_EQ(stage.plan([](Scene& s) { s.render.maxDepth = 3; }).kind, Kind::Restart);
    EXPECT_EQ(stage.plan([](Scene& s) { s.render.seed = 3; }).kind, Kind::Restart);
    EXPECT_EQ(stage.plan([](Scene& s) { s.film.filterRadius = 2; }).kind, Kind::Restart);
    EXPECT_EQ(stage.plan([](Scene& s) { s.environment.rotationDegrees = 2; }).kind, Kind::Restart);
    EXPECT_EQ(stage.plan([](Scene& s) {
                       s.lights.add({"New", PointLight{}, true, ""});
                   })
                  .kind,
              Kind::Restart);
    EXPECT_EQ(stage.plan([](Scene& s) { s.objects.add({.name = "New", .shape = Sphere{}}); }).kind,
              Kind::Restart);
}

TEST(EditPlan, LightsAreMixedUnlessSamplesAreClamped) {
    Stage stage;
    const auto brighter = [&](Object& o) { o.emission = {18, 8, 0}; };
    const EditPlan plan = stage.objectPlan(stage.lamp, brighter);
    EXPECT_EQ(plan.kind, Kind::Keep);
    EXPECT_EQ(plan.mix.gain[LightGroups(stage.b.scene()).of(stage.lamp)], DVec3(2, 1, 0));
    EXPECT_EQ(stage.plan([](Scene& s) { s.environment.intensity = 3; }).kind, Kind::Keep);
    stage.b.scene().render.clamp = 5;
    EXPECT_EQ(stage.objectPlan(stage.lamp, brighter).kind, Kind::Restart);
}

TEST(EditPlan, MaterialsNameWhatRestsOnThem) {
    const Stage stage;
    const auto recolored = [&](MaterialId id) {
        return stage.plan([&](Scene& s) {
            Material material = s.materials.at(id);
            material.value = Diffuse{Color{0.1, 0.2, 0.3}};
            s.materials.set(id, material);
        });
    };
    EXPECT_EQ(recolored(stage.floor).kind, Kind::Retrace);
    EXPECT_EQ(recolored(stage.floor).materials, materialBit(stage.floor));
    EXPECT_EQ(recolored(stage.clay).materials, materialBit(stage.clay) | materialBit(stage.blend))
        << "a mix rests on its parts";
    const EditPlan given =
        stage.objectPlan(stage.ball, [&](Object& o) { o.material = stage.clay; });
    EXPECT_EQ(given.kind, Kind::Retrace);
    EXPECT_EQ(given.materials, materialBit(stage.glass)) << "samples recorded what it was made of";
    const EditPlan renamed = stage.plan([&](Scene& s) {
        Material material = s.materials.at(stage.glass);
        material.name = "Crown glass";
        s.materials.set(stage.glass, material);
    });
    EXPECT_EQ(renamed.kind, Kind::Keep);
}

TEST(EditPlan, GlassForClayIsANewStructure) {
    Stage stage;
    const auto before = stage.b.compile();
    EXPECT_TRUE(sameStructure(*before, *stage.b.compile()));
    Material material = stage.b.scene().materials.at(stage.glass);
    material.value = Diffuse{};
    stage.b.scene().materials.set(stage.glass, material);
    EXPECT_FALSE(sameStructure(*before, *stage.b.compile()));
}

/// Shadow rays have not looked at clear glass.
TEST(EditPlan, ClearShadowsThatEndAreANewStructure) {
    Stage stage;
    stage.b.scene().render.integrator = Integrator::Classic;
    stage.b.scene().render.transparentShadows = true;
    const auto before = stage.b.compile();
    Material material = stage.b.scene().materials.at(stage.glass);
    std::get<Glass>(material.value).ior.value = 1.7;
    stage.b.scene().materials.set(stage.glass, material);
    EXPECT_TRUE(sameStructure(*before, *stage.b.compile()));
    std::get<Glass>(material.value).absorption.value = {1, 0, 0};
    stage.b.scene().materials.set(stage.glass, material);
    EXPECT_FALSE(sameStructure(*before, *stage.b.compile()));
}

/// Whatever field of a document changes, a plan other than Restart is one of what the field is
/// known for.
TEST(EditPlan, RandomDocumentsKeepOnlyThemselves) {
    for (std::uint64_t seed = 1; seed < 300; ++seed) {
        const Scene a = test::randomScene(seed), b = test::randomScene(seed + 1);
        EXPECT_EQ(planEdit(a, a, LightGroups(a)).kind, Kind::Keep);
        EXPECT_EQ(planEdit(a, b, LightGroups(a)).kind, Kind::Restart) << seed;
    }
}

}  // namespace
}  // namespace glint
