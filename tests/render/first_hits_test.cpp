// What camera rays hit is kept where an edit cannot change it, and nowhere else: every picture has
// the bits of a render from nothing.
#include <gtest/gtest.h>

#include <functional>
#include <random>
#include <thread>

#include "tests/support/films.h"
#include "tests/support/scenes.h"

namespace glint {
namespace {

using test::finish;
using test::firstDifference;
using test::renderedFromNothing;
using test::SceneBuilder;
using test::wishFor;

/// A clay ball, a lamp, and glass: a ball, and two blocks with one face in common whose priorities
/// decide what is seen of them.
Scene stage(Integrator integrator = Integrator::Path) {
    SceneBuilder b;
    const MaterialId clay = b.material(Diffuse{}), clear = b.material(Glass{}),
                     tinted = b.material(Glass{.ior = {1.3}, .priority = 1});
    b.object(Plane{}, clay);
    b.object(Sphere{0.6}, b.material(Diffuse{}), {1, 0.6, 0});
    b.object(Sphere{1}, clear, {-1, 1, 0});
    b.object(Box{{1, 1, 1}}, clear, {0.4, 0.5, 1.5});
    b.object(Box{{1, 1, 0.5}}, tinted, {0.4, 0.5, 1.75});
    b.object(Sphere{0.5}, {}, {0, 4, 1}, {9, 8, 7});
    b.scene().environment.color = Color{0.4, 0.5, 0.6};
    b.pointLight({2, 3, 2}, {10, 9, 8});
    b.camera({0, 2, 6}, {0, 0.8, 0}, 40);
    b.film(24, 18, 2);
    b.scene().render.spp = 2;
    b.scene().render.integrator = integrator;
    return b.scene();
}

/// A picture, and beside it one that spares no work: that one traces camera rays again though their
/// hits are known, and counts them.
struct Both {
    WorkerPool pool{2};
    LivingPicture sparing{pool}, tracing{pool, static_cast<Features>(Feature::NoSkips)};

    void show(const LivingPicture::Wish& wish) {
        for (LivingPicture* picture : {&sparing, &tracing}) {
            picture->takeUp(wish);
            finish(*picture);
        }
    }
    void expectExact(const Scene& scene, const std::string& what) {
        EXPECT_FALSE(firstDifference(sparing.picture().film, renderedFromNothing(scene, pool)))
            << what;
        EXPECT_EQ(sparing.picture().counts.work[Work::KnownHits], 0u) << what;
    }
    [[nodiscard]] std::uint64_t knownHits() const {
        return tracing.picture().counts.work[Work::KnownHits];
    }
};

/// How many hits a picture of `before` knows of when the edit is traced.
std::uint64_t hitsKept(const Scene& before, const std::function<void(Scene&)>& edit,
                       const std::string& what) {
    Both pictures;
    pictures.show(wishFor(before));
    EXPECT_EQ(pictures.knownHits(), 0u) << what;
    Scene after = before;
    edit(after);
    pictures.show(wishFor(after));
    pictures.expectExact(after, what);
    return pictures.knownHits();
}

template <class Value>
void editMaterial(Scene& scene, std::size_t number, const Value& value) {
    const MaterialId id = scene.materials.ids()[number];
    Material material = scene.materials.at(id);
    material.value = value;
    scene.materials.set(id, material);
}
void editObject(Scene& scene, std::size_t number, const std::function<void(Object&)>& edit) {
    const ObjectId id = scene.objects.ids()[number];
    Object object = scene.objects.at(id);
    edit(object);
    scene.objects.set(id, object);
}
void moveLamp(Scene& scene) {
    const LightId id = scene.lights.ids().front();
    Light light = scene.lights.at(id);
    std::get<PointLight>(light.value).position.x += 0.5;
    scene.lights.set(id, light);
}

struct Case {
    const char* what;
    std::function<void(Scene&)> edit;
};

// None is a new mix of the same light alone, which would keep the samples.
const Case kKeeping[] = {
    {"a lamp moves", moveLamp},
    {"a lamp comes",
     [](Scene& s) {
         s.lights.add({"Second", PointLight{{-2, 3, 2}, {3, 3, 3}}, true, ""});
     }},
    {"an object shines",
     [](Scene& s) {
         editObject(s, 1, [](Object& o) { o.emission = {1, 2, 3}; });
         moveLamp(s);
     }},
    {"a lamp of some size goes out",
     [](Scene& s) {
         editObject(s, 5, [](Object& o) { o.emission = {}; });
         moveLamp(s);
     }},
    {"the sky is hidden", [](Scene& s) { s.environment.visibleToCamera = false; }},
    {"clay becomes a mirror",
     [](Scene& s) {
         editMaterial(s, 0, Mirror{});
         editMaterial(s, 3, Mirror{});
     }},
    {"an object turns black",
     [](Scene& s) {
         editObject(s, 0, [](Object& o) { o.material = {}; });
         moveLamp(s);
     }},
    {"another depth", [](Scene& s) { s.render.maxDepth = 3; }},
    {"the other integrator",
     [](Scene& s) {
         s.render.integrator =
             s.render.integrator == Integrator::Path ? Integrator::Classic : Integrator::Path;
     }},
    {"another medium fills where two overlap",
     [](Scene& s) {
         editMaterial(s, 1, Glass{.priority = 2});
         moveLamp(s);
     }},
    {"no boundary bends light",
     [](Scene& s) {
         editMaterial(s, 1, Glass{.ior = {1.0}});
         moveLamp(s);
     }},
    {"glass gets colour",
     [](Scene& s) {
         editMaterial(s, 1, Glass{.absorption = {Color{1, 2, 3}}});
         moveLamp(s);
     }},
};
const Case kLosing[] = {
    {"clay becomes glass", [](Scene& s) { editMaterial(s, 3, Glass{}); }},
    {"glass becomes a mirror", [](Scene& s) { editMaterial(s, 1, Mirror{}); }},
    {"glass becomes thin", [](Scene& s) { editMaterial(s, 1, Glass{.thin = true}); }},
    {"an object moves",
     [](Scene& s) { editObject(s, 1, [](Object& o) { o.transform.translate.x += 0.1; }); }},
    {"an object is hidden",
     [](Scene& s) { editObject(s, 1, [](Object& o) { o.visible = false; }); }},
    {"an object shrinks to nothing",
     [](Scene& s) { editObject(s, 1, [](Object& o) { o.transform.scale = DVec3(0.0); }); }},
    {"the camera moves", [](Scene& s) { s.camera.position.x += 0.1; }},
    {"the camera goes into the glass",
     [](Scene& s) {
         s.camera.position = {-1, 1, 0.2};
     }},
    {"a lens", [](Scene& s) { s.camera.apertureRadius = 0.1; }},
    {"a picture of another size", [](Scene& s) { s.film.width = 30; }},
    {"a wider filter", [](Scene& s) { s.film.filterRadius = 1; }},
    {"other noise", [](Scene& s) { s.render.seed = 7; }},
};

void expectKept(const Scene& scene) {
    const auto pixels = static_cast<std::uint64_t>(scene.film.width * scene.film.height);
    for (const Case& c : kKeeping) {
        const std::uint64_t kept = hitsKept(scene, c.edit, c.what);
        EXPECT_GT(kept, 0u) << c.what;
        EXPECT_LE(kept, pixels) << c.what;
    }
}

TEST(FirstHits, AreKeptWhereNeitherCameraNorShapesChange) {
    for (const Integrator integrator : {Integrator::Path, Integrator::Classic})
        expectKept(stage(integrator));
}
TEST(FirstHits, AreKeptBehindALens) {
    Scene scene = stage();
    scene.camera.apertureRadius = 0.2;
    expectKept(scene);
}
TEST(FirstHits, AreKeptInsideOfMedia) {
    Scene scene = stage();
    scene.camera.position = {-1, 1, 0.5};
    expectKept(scene);
    scene.camera.projection =
        Projection::Orthographic;  // Some rays start in the glass, some outside.
    expectKept(scene);
}
/// The camera is in both blocks, and one of the boundaries in front of it is hidden: the path goes
/// on without an interaction.
TEST(FirstHits, AreTheCamerasAloneBehindHiddenBoundaries) {
    Scene scene = stage();
    scene.camera.position = {0.4, 0.5, 1.75};
    scene.camera.target = {5, 0.5, 1.75};
    expectKept(scene);
    scene.render.integrator = Integrator::Classic;
    expectKept(scene);
}
TEST(FirstHits, AreLostWithCameraOrShapes) {
    for (const Case& c : kLosing) EXPECT_EQ(hitsKept(stage(), c.edit, c.what), 0u) << c.what;
}

TEST(FirstHits, EveryPixelIsSparedAfterALightHasMoved) {
    const Scene scene = stage();
    EXPECT_EQ(hitsKept(scene, moveLamp, "a lamp moves"),
              static_cast<std::uint64_t>(scene.film.width * scene.film.height));
}

TEST(FirstHits, NoShapeIsAskedForThem) {
    SceneBuilder b;
    for (int i = 0; i < 5; ++i) b.object(Sphere{0.5}, {}, {i - 2, 0, 0});
    b.scene().environment.color = Color{1, 1, 1};
    b.camera({0, 1, 6}, {0, 0, 0}, 40);
    b.scene().render.spp = 1;
    WorkerPool pool(2);
    LivingPicture picture(pool);
    picture.takeUp(wishFor(b.scene()));
    finish(picture);
    const WorkCounts before = picture.picture().counts.work;
    EXPECT_GT(before[Work::BallTests], 0u);
    b.scene().environment.visibleToCamera = false;
    picture.takeUp(wishFor(b.scene()));
    finish(picture);
    const WorkCounts after = picture.picture().counts.work;
    EXPECT_EQ(after[Work::BallTests], before[Work::BallTests]);
    EXPECT_EQ(after[Work::BallBlocks], before[Work::BallBlocks]);
}

/// Pixels of a region keep theirs, though those around have never been traced.
TEST(FirstHits, AreThoseOfTheRegion) {
    Both pictures;
    LivingPicture::Wish wish = wishFor(stage());
    wish.region = PixelRect{3, 4, 10, 9};
    pictures.show(wish);
    moveLamp(wish.scene);
    pictures.show(wish);
    EXPECT_EQ(pictures.knownHits(), 90u);
    moveLamp(wish.scene);
    wish.region.reset();
    pictures.show(wish);
    EXPECT_EQ(pictures.knownHits(), 180u);
    pictures.expectExact(wish.scene, "the whole picture");
}

TEST(FirstHits, UndoTakesNoneOfAnotherView) {
    Scene scene = stage();
    scene.render.spp = 1 << 20;
    WorkerPool pool(2);
    LivingPicture picture(pool);
    picture.takeUp(wishFor(scene));
    while (picture.picture().seconds < 0.25) picture.render({1e-3, 2e-2}, {});
    Scene other = scene;
    other.camera.position.x += 1;
    picture.takeUp(wishFor(other));
    while (picture.picture().spp == 0) picture.render({1e-3, 1e-3}, {});
    const std::uint64_t restarts = picture.restarts();
    scene.render.spp = 2;
    picture.takeUp(wishFor(scene));
    EXPECT_EQ(picture.restarts(), restarts) << "the picture of before is kept";
    editMaterial(scene, 3, Mirror{});
    moveLamp(scene);
    picture.takeUp(wishFor(scene));
    finish(picture);
    EXPECT_FALSE(firstDifference(picture.picture().film, renderedFromNothing(scene, pool)));
}

/// Lets the next pass go on for a random time at most.
void renderAWhile(LivingPicture& picture, std::mt19937& random) {
    std::atomic<std::uint64_t> epoch{0};
    std::thread other([&, wait = random() % 200] {
        std::this_thread::sleep_for(std::chrono::microseconds(wait));
        epoch = 1;
    });
    while (!picture.isConverged() && epoch == 0) picture.render({1e-5, 1e-4}, {&epoch, 0});
    other.join();
}

TEST(FirstHits, RandomEditsCutShortAreBitEqualToAFullRender) {
    std::mt19937 random(1);
    for (const Integrator integrator : {Integrator::Path, Integrator::Classic}) {
        Scene scene = stage(integrator);
        std::vector<Scene> past{scene};
        WorkerPool pool(3);
        LivingPicture picture(pool);
        for (int i = 0; i < 150; ++i) {
            if (random() % 5 == 0)
                scene = past[random() % past.size()];
            else if (random() % 4 == 0)
                kLosing[random() % std::size(kLosing)].edit(scene);
            else
                kKeeping[random() % (std::size(kKeeping) - 1)].edit(scene);
            if (scene.lights.size() > 3) scene = past.front();
            past.push_back(scene);
            picture.takeUp(wishFor(scene));
            renderAWhile(picture, random);
            if (random() % 3 == 0) continue;
            finish(picture);
            ASSERT_FALSE(firstDifference(picture.picture().film, renderedFromNothing(scene, pool)))
                << "edit " << i;
        }
    }
}

/// Numbers of generations come again after 65536 of them.
TEST(FirstHits, NoneComesBackAfterManyEdits) {
    SceneBuilder b;
    const auto one = b.compile();
    b.scene().render.seed = 1;
    const auto other = b.compile();
    FirstHits hits;
    hits.takeUp(*one);
    EXPECT_FALSE(hits.find(3, 4));
    hits.keep(3, 4, {2.5, 7, 3});
    ASSERT_TRUE(hits.find(3, 4));
    EXPECT_EQ(hits.find(3, 4)->t, 2.5);
    EXPECT_EQ(hits.find(3, 4)->shape, 7u);
    EXPECT_EQ(hits.find(3, 4)->face, 3);
    for (int i = 0; i < 70000; ++i) {
        hits.takeUp(i % 2 == 0 ? *other : *one);
        hits.keep(3, 5, {});
        ASSERT_FALSE(hits.find(3, 4)) << i;
    }
    hits.keep(3, 4, {});
    ASSERT_TRUE(hits.find(3, 4)) << "a ray that hits nothing is known to";
    EXPECT_FALSE(hits.find(3, 4)->found());
}

}  // namespace
}  // namespace glint
