// The living render: it ends at the picture of the headless one, shows every edit, keeps what a view setting does not touch,
// and can be torn down at any moment.
#include <gtest/gtest.h>

#include <chrono>
#include <ctime>
#include <random>
#include <thread>

#include "tests/support/scenes.h"
#include "tracer/color/display.h"
#include "tracer/render/session.h"

namespace glint {
namespace {

using test::SceneBuilder;

SceneBuilder stillLife() {
    SceneBuilder b;
    b.object(Plane{}, b.material(Diffuse{}));
    b.object(Sphere{1}, b.material(Glass{}), {-1, 1, 0});
    b.object(Sphere{1}, b.material(Mirror{}), {1, 1, 0});
    b.scene().environment.color = Color{0.4, 0.5, 0.6};
    b.pointLight({2, 3, 2}, {10, 9, 8});
    b.camera({0, 2, 6}, {0, 0.8, 0}, 40);
    b.scene().film.width = 61;
    b.scene().film.height = 43;
    b.scene().render.spp = 5;
    return b;
}

ViewSettings viewOf(const Scene& scene) { return {scene.film.width, scene.film.height, {}, false, {}, 0}; }

/// The next frame for which `wanted` holds; a copy, or a failure after ten seconds.
template <class Wanted>
SessionFrame waitFor(Session& session, Wanted wanted) {
    for (int i = 0; i < 10000; ++i) {
        if (const SessionFrame* frame = session.take(); frame && wanted(*frame)) return *frame;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    ADD_FAILURE() << "no such frame came";
    return {};
}
bool isConverged(const SessionFrame& frame) { return frame.state == SessionState::Converged; }

std::vector<std::uint32_t> shown(const Image& image, const DisplaySettings& settings) {
    const DisplayTransform transform(settings);
    std::vector<std::uint32_t> out;
    for (std::size_t i = 0; i + 2 < image.rgb.size(); i += 3) out.push_back(transform.apply({image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]}));
    return out;
}

TEST(Session, ConvergesToTheBitsOfTheHeadlessRender) {
    const SceneBuilder b = stillLife();
    SceneBuilder copy = b;
    const std::vector<std::uint32_t> exact = shown(b.render().beauty, {});
    for (const int threads : {1, 2, 3}) {
        Session session(threads);
        session.publish(viewOf(copy.scene()));
        session.publish(copy.scene(), {});
        const SessionFrame frame = waitFor(session, isConverged);
        EXPECT_EQ(frame.spp, 5);
        EXPECT_EQ(frame.pixels, exact) << threads << " threads";
    }
}

TEST(Session, ShowsTheNewestOfManyEdits) {
    SceneBuilder b = stillLife();
    Session session(2);
    session.publish(viewOf(b.scene()));
    std::uint64_t last = 0;
    for (int i = 0; i < 50; ++i) {
        b.scene().camera.position.x = 0.02 * i;
        last = session.publish(b.scene(), {});
    }
    const SessionFrame frame = waitFor(session, [&](const SessionFrame& f) { return f.revision == last && isConverged(f); });
    EXPECT_EQ(frame.pixels, shown(b.render().beauty, {}));
}

TEST(Session, ExposureChangesThePictureWithoutNewSamples) {
    SceneBuilder b = stillLife();
    Session session(2);
    ViewSettings view = viewOf(b.scene());
    session.publish(view);
    session.publish(b.scene(), {});
    const SessionFrame before = waitFor(session, isConverged);
    view.paint.display.exposureEv = 1;
    session.publish(view);
    const SessionFrame after = waitFor(session, [&](const SessionFrame& f) { return f.pixels != before.pixels; });
    EXPECT_EQ(after.pixels, shown(b.render().beauty, view.paint.display));
    EXPECT_EQ(after.seconds, before.seconds) << "time was spent on new samples";
}

TEST(Session, PausedAndResumedGivesTheSameBits) {
    SceneBuilder b = stillLife();
    b.scene().render.spp = 40;
    Session session(2);
    ViewSettings view = viewOf(b.scene());
    session.publish(view);
    session.publish(b.scene(), {});
    for (int i = 0; i < 10; ++i) {
        view.paused = i % 2 == 0;
        session.publish(view);
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    EXPECT_EQ(waitFor(session, isConverged).pixels, shown(b.render().beauty, {}));
}

TEST(Session, RegionKeepsTheRest) {
    SceneBuilder b = stillLife();
    Session session(2);
    ViewSettings view = viewOf(b.scene());
    session.publish(view);
    session.publish(b.scene(), {});
    const std::vector<std::uint32_t> old = waitFor(session, isConverged).pixels;
    view.region = PixelRect{10, 8, 30, 20};
    session.publish(view);
    b.scene().environment.color = Color{2, 0.1, 0.1};
    const std::uint64_t revision = session.publish(b.scene(), {});
    const auto isNew = [&](const SessionFrame& f) { return f.revision == revision && isConverged(f); };
    const std::vector<std::uint32_t> part = waitFor(session, isNew).pixels;
    const std::vector<std::uint32_t> whole = shown(b.render().beauty, {});
    for (int y = 0; y < view.height; ++y)
        for (int x = 0; x < view.width; ++x) {
            const auto i = static_cast<std::size_t>(y * view.width + x);
            const bool inside = x >= 10 && x < 40 && y >= 8 && y < 28;
            ASSERT_EQ(part[i], inside ? whole[i] : old[i]) << x << "," << y;
        }
    // Without the region the rest is made anew.
    view.region.reset();
    session.publish(view);
    EXPECT_EQ(waitFor(session, [](const SessionFrame& f) { return !f.region && isConverged(f); }).pixels, whole);
}

TEST(Session, ChannelsAndFilterCostNoSamples) {
    SceneBuilder b = stillLife();
    Session session(2);
    ViewSettings view = viewOf(b.scene());
    session.publish(view);
    session.publish(b.scene(), {});
    const SessionFrame beauty = waitFor(session, isConverged);
    for (std::size_t i = 1; i < kChannels; ++i) {
        view.paint.channel = static_cast<Channel>(i);
        session.publish(view);
        const SessionFrame frame = waitFor(session, [&](const SessionFrame& f) { return f.channel == view.paint.channel; });
        EXPECT_EQ(frame.seconds, beauty.seconds) << "channel " << i;
        EXPECT_NE(frame.pixels, beauty.pixels) << "channel " << i;
    }
    view.paint.channel = Channel::Beauty;
    view.paint.filtered = true;
    session.publish(view);
    const SessionFrame filtered = waitFor(session, [&](const SessionFrame& f) { return f.filtered; });
    EXPECT_EQ(filtered.seconds, beauty.seconds);
    EXPECT_EQ(filtered.error, beauty.error);
    view.paint.filtered = false;
    session.publish(view);
    EXPECT_EQ(waitFor(session, [](const SessionFrame& f) { return !f.filtered; }).pixels, beauty.pixels);
}

TEST(Session, ConvergedAndHiddenCostNoProcessorTime) {
    SceneBuilder b = stillLife();
    Session session(2);
    ViewSettings view = viewOf(b.scene());
    session.publish(view);
    session.publish(b.scene(), {});
    static_cast<void>(waitFor(session, isConverged));
    const auto share = [] {
        const std::clock_t before = std::clock();
        constexpr int kMilliseconds = 1000;
        std::this_thread::sleep_for(std::chrono::milliseconds(kMilliseconds));
        return static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC / (1e-3 * kMilliseconds);
    };
    EXPECT_LT(share(), 0.005);
    b.scene().render.spp = 1000000;
    session.publish(b.scene(), {});
    EXPECT_GT(share(), 0.02);  // It is seen when there is work.
    view.paused = true;
    session.publish(view);
    static_cast<void>(waitFor(session, [](const SessionFrame& f) { return f.state == SessionState::Paused; }));
    EXPECT_LT(share(), 0.005);
}

TEST(Session, NamesAndStopRulesKeepTheSamples) {
    SceneBuilder b = stillLife();
    Session session(2);
    session.publish(viewOf(b.scene()));
    session.publish(b.scene(), {});
    const SessionFrame before = waitFor(session, isConverged);
    const ObjectId id = b.scene().objects.ids().front();
    Object renamed = b.scene().objects.at(id);
    renamed.name = "Ground";
    renamed.locked = true;
    b.scene().objects.set(id, renamed);
    const std::uint64_t revision = session.publish(b.scene(), {});
    const SessionFrame after = waitFor(session, [&](const SessionFrame& f) { return f.revision == revision; });
    EXPECT_EQ(after.pixels, before.pixels);
    EXPECT_EQ(after.rays, before.rays);
    EXPECT_EQ(after.restarts, before.restarts);
    b.scene().render.spp = 12;
    const std::uint64_t longer = session.publish(b.scene(), {});
    const SessionFrame more = waitFor(session, [&](const SessionFrame& f) { return f.revision == longer && isConverged(f); });
    EXPECT_EQ(more.restarts, before.restarts);
    EXPECT_EQ(more.pixels, shown(b.render().beauty, {}));
}

/// Mean of the 8-bit values.
double meanOf(const std::vector<std::uint32_t>& pixels) {
    double sum = 0;
    for (const std::uint32_t p : pixels) sum += (p >> 16 & 255) + (p >> 8 & 255) + (p & 255);
    return sum / (3.0 * static_cast<double>(pixels.size()));
}

TEST(Session, ResizingKeepsWhatIsThere) {
    SceneBuilder b = stillLife();
    b.scene().render.spp = 64;
    Session session(2);
    session.publish(viewOf(b.scene()));
    session.publish(b.scene(), {});
    const SessionFrame before = waitFor(session, isConverged);
    ViewSettings wider = viewOf(b.scene());
    wider.width += 20;
    session.publish(wider);
    const SessionFrame first = waitFor(session, [&](const SessionFrame& f) { return f.width == wider.width; });
    // The first frame of the new size shows the old picture, in its middle, as it was but for a few of its new samples.
    double difference = 0;
    for (int y = 0; y < before.height; ++y)
        for (int x = 0; x < before.width; ++x) {
            const auto red = [](std::uint32_t p) { return static_cast<double>(p >> 16 & 255); };
            difference += std::abs(red(before.pixels[static_cast<std::size_t>(y * before.width + x)]) - red(first.pixels[static_cast<std::size_t>(y * first.width + x + 10)]));
        }
    EXPECT_LT(difference / (before.width * before.height), 2);
    static_cast<void>(waitFor(session, [&](const SessionFrame& f) { return f.width == wider.width && isConverged(f); }));
}

TEST(Session, MixingLightsCostsNoRaysAndIsRight) {
    SceneBuilder b = stillLife();
    b.scene().film.width = b.scene().film.height = 32;
    b.scene().render.spp = 256;
    Session session(2);
    session.publish(viewOf(b.scene()));
    session.publish(b.scene(), {});
    const SessionFrame before = waitFor(session, isConverged);
    b.scene().environment.intensity = 0.2;
    const LightId id = b.scene().lights.ids().front();
    Light light = b.scene().lights.at(id);
    lightColor(light) = {2, 9, 16};
    b.scene().lights.set(id, light);
    const std::uint64_t revision = session.publish(b.scene(), {});
    const SessionFrame after = waitFor(session, [&](const SessionFrame& f) { return f.revision == revision; });
    EXPECT_EQ(after.rays, before.rays);
    EXPECT_EQ(after.state, SessionState::Converged) << "in its first frame";
    EXPECT_EQ(after.retracedShare, 0);
    EXPECT_NEAR(meanOf(after.pixels), meanOf(shown(b.render().beauty, {})), 1.0);
}

TEST(Session, UndoBringsTheConvergedPictureBack) {
    SceneBuilder b = stillLife();
    b.scene().film.width = 128;
    b.scene().film.height = 96;
    b.scene().render.spp = 128;
    Session session(2);
    session.publish(viewOf(b.scene()));
    const Scene before = b.scene();
    session.publish(before, {});
    const SessionFrame converged = waitFor(session, isConverged);
    ASSERT_GT(converged.seconds, 0.2) << "too quick to be worth keeping";
    const ObjectId ball = b.scene().objects.ids()[1];
    Object moved = b.scene().objects.at(ball);
    moved.transform.translate.x += 0.5;
    b.scene().objects.set(ball, moved);
    const std::uint64_t edited = session.publish(b.scene(), {});
    const SessionFrame other = waitFor(session, [&](const SessionFrame& f) { return f.revision == edited && isConverged(f); });
    for (int i = 0; i < 4; ++i) {
        const bool undo = i % 2 == 0;
        const std::uint64_t revision = session.publish(undo ? before : b.scene(), {});
        const SessionFrame back = waitFor(session, [&](const SessionFrame& f) { return f.revision == revision; });
        EXPECT_EQ(back.state, SessionState::Converged);
        EXPECT_EQ(back.pixels, undo ? converged.pixels : other.pixels);
        EXPECT_EQ(back.rays, other.rays);
    }
}

/// Changes a random value of a random material, or gives an object another one.
void editMaterials(Scene& scene, std::mt19937& random) {
    const auto unit = [&] { return static_cast<double>(random() % 1001) / 1000; };
    const std::vector<MaterialId> ids = scene.materials.ids();
    const MaterialId id = ids[random() % ids.size()];
    if (random() % 8 == 0) {
        const std::vector<ObjectId> objects = scene.objects.ids();
        const ObjectId given = objects[random() % objects.size()];
        Object object = scene.objects.at(given);
        object.material = id;
        scene.objects.set(given, object);
        return;
    }
    Material material = scene.materials.at(id);
    if (auto* glass = std::get_if<Glass>(&material.value)) {
        glass->ior.value = 1.1 + unit();
        glass->absorption.value = {unit(), unit(), unit()};
    } else if (auto* mix = std::get_if<Mix>(&material.value)) {
        mix->amount.value = unit();
    } else if (auto* mirror = std::get_if<Mirror>(&material.value)) {
        mirror->color.value = {unit(), unit(), unit()};
    } else {
        material.value = Diffuse{Color{unit(), unit(), unit()}};
    }
    scene.materials.set(id, material);
}

/// A still life in which light passes a veil and stays within glass.
SceneBuilder materialStage(Integrator integrator) {
    SceneBuilder b;
    const MaterialId clay = b.material(Diffuse{}), veil = b.material(Mix{});
    Material mix = b.scene().materials.at(veil);
    std::get<Mix>(mix.value) = {.a = {{}, true}, .b = {clay}};
    b.scene().materials.set(veil, mix);
    b.object(Plane{}, b.material(Diffuse{}));
    b.object(Sphere{1}, b.material(Glass{}), {-1, 1, 0});
    b.object(Sphere{0.4}, b.material(Mirror{}), {-1, 1, 0});
    b.object(Sphere{0.6}, b.material(Diffuse{}), {1, 0.6, 0});
    b.object(Box{{1, 2, 0.2}}, veil, {0.3, 1, 1});
    b.object(Sphere{0.5}, {}, {0, 4, 1}, {9, 8, 7});
    b.scene().environment.color = Color{0.4, 0.5, 0.6};
    b.pointLight({2, 3, 2}, {10, 9, 8});
    b.camera({0, 2, 6}, {0, 0.8, 0}, 40);
    b.scene().film.width = 24;
    b.scene().film.height = 18;
    b.scene().render.spp = 3;
    b.scene().render.integrator = integrator;
    b.scene().render.transparentShadows = true;
    return b;
}

/// Random material edits one after the other, each compared with a render from nothing.
void materialEditsAreExact(Integrator integrator, int edits, unsigned seed) {
    std::mt19937 random(seed);
    SceneBuilder b = materialStage(integrator);
    Session session(2);
    session.publish(viewOf(b.scene()));
    session.publish(b.scene(), {});
    static_cast<void>(waitFor(session, isConverged));
    double share = 0;
    int retraced = 0;
    for (int i = 0; i < edits; ++i) {
        editMaterials(b.scene(), random);
        const std::uint64_t revision = session.publish(b.scene(), {});
        const SessionFrame frame = waitFor(session, [&](const SessionFrame& f) { return f.revision == revision && isConverged(f); });
        ASSERT_EQ(frame.pixels, shown(b.render().beauty, {})) << "edit " << i << " of seed " << seed;
        if (frame.retracedShare < 1) share += frame.retracedShare, ++retraced;
    }
    EXPECT_GT(retraced, edits / 2) << "most edits are to keep some pixels";
    testing::Test::RecordProperty("mean share of the pixels", std::to_string(share / retraced));
}

TEST(Session, MaterialEditsAreBitEqualToAFullRender) {
    materialEditsAreExact(Integrator::Path, 150, 1);
    materialEditsAreExact(Integrator::Classic, 150, 2);
}
TEST(SessionFull, TenThousandMaterialEditsAreBitEqualToAFullRender) {
    if (!test::fullRun()) GTEST_SKIP() << "asked for by GLINT_FULL=1";
    materialEditsAreExact(Integrator::Path, 5000, 3);
    materialEditsAreExact(Integrator::Classic, 5000, 4);
}

TEST(Session, SurvivesRandomEditsResizesPausesAndQuits) {
    std::mt19937 random(1);
    SceneBuilder b = stillLife();
    const std::vector<ObjectId> ids = b.scene().objects.ids();
    for (int round = 0; round < 20; ++round) {
        Session session(1 + round % 3);
        ViewSettings view{120, 90, {}, false, {}, 0};
        session.publish(view);
        for (int i = 0; i < 25; ++i) {
            Object moved = b.scene().objects.at(ids[1 + random() % 2]);
            moved.transform.translate.x = static_cast<double>(random() % 100) / 50;
            b.scene().objects.set(ids[1], moved);
            session.publish(b.scene(), {});
            if (random() % 3 == 0) {
                view = {static_cast<int>(random() % 150), 90, {static_cast<double>(random() % 5), View::Standard}, random() % 4 == 0};
                session.publish(view);
            }
            if (random() % 2) std::this_thread::sleep_for(std::chrono::milliseconds(random() % 6));
            if (const SessionFrame* frame = session.take()) {
                ASSERT_EQ(frame->pixels.size(), static_cast<std::size_t>(frame->width) * static_cast<std::size_t>(frame->height));
                ASSERT_EQ(frame->nonfiniteSamples, 0u);
            }
        }
    }  // Each session is torn down in the middle of its work.
}

}  // namespace
}  // namespace glint
