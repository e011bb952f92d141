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
