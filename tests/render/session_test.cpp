// The living render: it ends at the picture of the headless one, shows every edit, keeps what a
// view setting does not touch, and can be torn down at any moment.
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <ctime>
#include <fstream>
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

ViewSettings viewOf(const Scene& scene) {
    return {scene.film.width, scene.film.height, {}, false, {}, 0};
}

/// The next frame for which `wanted` holds; a copy, or a failure after two minutes: sanitizers and
/// busy machines are slow.
template <class Wanted>
SessionFrame waitFor(Session& session, Wanted wanted) {
    for (int i = 0; i < 120000; ++i) {
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
    for (std::size_t i = 0; i + 2 < image.rgb.size(); i += 3)
        out.push_back(transform.apply({image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]}));
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
    const SessionFrame frame = waitFor(
        session, [&](const SessionFrame& f) { return f.revision == last && isConverged(f); });
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
    const SessionFrame after =
        waitFor(session, [&](const SessionFrame& f) { return f.pixels != before.pixels; });
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
    const auto isNew = [&](const SessionFrame& f) {
        return f.revision == revision && isConverged(f);
    };
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
    EXPECT_EQ(
        waitFor(session, [](const SessionFrame& f) { return !f.region && isConverged(f); }).pixels,
        whole);
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
        const SessionFrame frame = waitFor(
            session, [&](const SessionFrame& f) { return f.channel == view.paint.channel; });
        EXPECT_EQ(frame.seconds, beauty.seconds) << "channel " << i;
        EXPECT_NE(frame.pixels, beauty.pixels) << "channel " << i;
    }
    view.paint.channel = Channel::Beauty;
    view.paint.filtered = true;
    session.publish(view);
    const SessionFrame filtered =
        waitFor(session, [&](const SessionFrame& f) { return f.filtered; });
    EXPECT_EQ(filtered.seconds, beauty.seconds);
    EXPECT_EQ(filtered.error, beauty.error);
    view.paint.filtered = false;
    session.publish(view);
    EXPECT_EQ(waitFor(session, [](const SessionFrame& f) { return !f.filtered; }).pixels,
              beauty.pixels);
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
    static_cast<void>(
        waitFor(session, [](const SessionFrame& f) { return f.state == SessionState::Paused; }));
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
    const SessionFrame after =
        waitFor(session, [&](const SessionFrame& f) { return f.revision == revision; });
    EXPECT_EQ(after.pixels, before.pixels);
    EXPECT_EQ(after.rays, before.rays);
    EXPECT_EQ(after.restarts, before.restarts);
    b.scene().render.spp = 12;
    const std::uint64_t longer = session.publish(b.scene(), {});
    const SessionFrame more = waitFor(
        session, [&](const SessionFrame& f) { return f.revision == longer && isConverged(f); });
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
    const SessionFrame first =
        waitFor(session, [&](const SessionFrame& f) { return f.width == wider.width; });
    // The first frame of the new size shows the old picture, in its middle, as it was but for a few
    // of its new samples.
    double difference = 0;
    for (int y = 0; y < before.height; ++y)
        for (int x = 0; x < before.width; ++x) {
            const auto red = [](std::uint32_t p) { return static_cast<double>(p >> 16 & 255); };
            difference +=
                std::abs(red(before.pixels[static_cast<std::size_t>(y * before.width + x)]) -
                         red(first.pixels[static_cast<std::size_t>(y * first.width + x + 10)]));
        }
    EXPECT_LT(difference / (before.width * before.height), 2);
    static_cast<void>(waitFor(
        session, [&](const SessionFrame& f) { return f.width == wider.width && isConverged(f); }));
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
    const SessionFrame after =
        waitFor(session, [&](const SessionFrame& f) { return f.revision == revision; });
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
    const SessionFrame other = waitFor(
        session, [&](const SessionFrame& f) { return f.revision == edited && isConverged(f); });
    for (int i = 0; i < 4; ++i) {
        const bool undo = i % 2 == 0;
        const std::uint64_t revision = session.publish(undo ? before : b.scene(), {});
        const SessionFrame back =
            waitFor(session, [&](const SessionFrame& f) { return f.revision == revision; });
        EXPECT_EQ(back.state, SessionState::Converged);
        EXPECT_EQ(back.pixels, undo ? converged.pixels : other.pixels);
        EXPECT_EQ(back.rays, other.rays);
    }
}

/// One random thing that a person or a window does to a session.
class RandomHand {
  public:
    explicit RandomHand(unsigned seed) : random_(seed), b_(stillLife()), history_{b_.scene()} {}

    void begin(Session& session) {
        session.publish(view_);
        session.publish(b_.scene(), {});
    }
    void act(Session& session) {
        switch (random_() % 16) {
            case 0:
            case 1:
            case 2:
                moveBall();
                break;
            case 3:
            case 4:
                moveCamera();
                break;
            case 5:
            case 6:
                editMaterial();
                break;
            case 7:
            case 8:
                b_.scene().environment.intensity = 0.1 + unit();
                break;
            case 9:
                b_.scene() = history_[random_() % history_.size()];
                break;  // undo and redo
            case 10:
                view_.width = static_cast<int>(random_() % 150),
                view_.height = static_cast<int>(random_() % 100);
                return session.publish(view_);
            case 11:
                view_.paused = !view_.paused;
                return session.publish(view_);
            case 12:
                view_.paint = {{unit(), View::Standard},
                               static_cast<Channel>(random_() % kChannels),
                               random_() % 2 == 0};
                return session.publish(view_);
            case 13:
                setRegion();
                return session.publish(view_);
            case 14:
                view_.threads = static_cast<int>(random_() % 4);
                return session.publish(view_);
            default:
                b_.scene().render.spp = static_cast<int>(1 + random_() % 30),
                b_.scene().render.errorPercent = random_() % 3 == 0 ? 5 : 0;
                break;
        }
        history_.push_back(b_.scene());
        if (history_.size() > 20) history_.erase(history_.begin());
        session.publish(b_.scene(), {});
    }
    std::uint32_t random() { return static_cast<std::uint32_t>(random_()); }

  private:
    double unit() { return static_cast<double>(random_() % 1001) / 1000; }
    void moveBall() {
        const ObjectId id = b_.scene().objects.ids()[1 + random_() % 2];
        Object object = b_.scene().objects.at(id);
        object.transform.translate.x = 2 * unit();
        b_.scene().objects.set(id, object);
    }
    void moveCamera() { b_.scene().camera.position.x = unit(); }
    void editMaterial() {
        const MaterialId id = b_.scene().materials.ids()[random_() % 3];
        Material material = b_.scene().materials.at(id);
        if (auto* diffuse = std::get_if<Diffuse>(&material.value))
            diffuse->color.value = {unit(), unit(), unit()};
        if (auto* glass = std::get_if<Glass>(&material.value)) glass->ior.value = 1.1 + unit();
        if (auto* mirror = std::get_if<Mirror>(&material.value))
            mirror->color.value = {unit(), unit(), unit()};
        b_.scene().materials.set(id, material);
    }
    void setRegion() {
        view_.region.reset();
        if (random_() % 2)
            view_.region =
                PixelRect{static_cast<int>(random_() % 80), static_cast<int>(random_() % 60),
                          static_cast<int>(random_() % 90), static_cast<int>(random_() % 60)};
    }

    std::mt19937 random_;
    SceneBuilder b_;
    std::vector<Scene> history_;
    ViewSettings view_{120, 90, {}, false, {}, 0};
};

/// Edits, undos, resizes, pauses, regions and channels at random moments; every session is torn
/// down in the middle of its work.
void survivesRandomHands(int sessions, int acts, unsigned seed) {
    RandomHand hand(seed);
    for (int round = 0; round < sessions; ++round) {
        Session session(1 + round % 3);
        hand.begin(session);
        for (int i = 0; i < acts; ++i) {
            hand.act(session);
            if (hand.random() % 2)
                std::this_thread::sleep_for(std::chrono::microseconds(hand.random() % 6000));
            if (const SessionFrame* frame = session.take()) {
                ASSERT_EQ(frame->pixels.size(), static_cast<std::size_t>(frame->width) *
                                                    static_cast<std::size_t>(frame->height));
                ASSERT_EQ(frame->nonfiniteSamples, 0u);
            }
        }
    }
}

TEST(Session, SurvivesRandomEditsUndosResizesPausesAndQuits) { survivesRandomHands(20, 30, 1); }
TEST(SessionFull, SurvivesTenThousandRandomEditsUndosResizesPausesAndQuits) {
    if (!test::fullRun()) GTEST_SKIP() << "asked for by GLINT_FULL=1";
    survivesRandomHands(200, 50, 2);
}

/// Resident memory of this process [bytes].
double residentBytes() {
    std::ifstream file("/proc/self/statm");
    double pages = 0, resident = 0;
    file >> pages >> resident;
    return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

/// An hour, or GLINT_SOAK_SECONDS: memory at the end is no more than after the first fifth, in
/// which caches fill.
TEST(SessionFull, AnHourOfEditsLeavesMemoryFlat) {
    if (!test::fullRun()) GTEST_SKIP() << "asked for by GLINT_FULL=1";
    const char* asked = std::getenv("GLINT_SOAK_SECONDS");
    const double seconds = asked ? std::atof(asked) : 3600;
    RandomHand hand(3);
    Session session(2);
    hand.begin(session);
    const auto start = std::chrono::steady_clock::now();
    const auto elapsed = [&] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    double early = 0, late = 0;
    std::uint64_t acts = 0, frames = 0;
    for (double now = 0; now < seconds; now = elapsed()) {
        hand.act(session);
        ++acts;
        std::this_thread::sleep_for(std::chrono::microseconds(hand.random() % 20000));
        frames += session.take() != nullptr;
        double& most = now < 0.2 * seconds ? early : late;
        if (acts % 100 == 0) most = std::max(most, residentBytes());
    }
    std::printf(
        "%.0f s: %llu acts, %llu frames, at most %.1f MB in the first fifth, %.1f MB later\n",
        seconds, static_cast<unsigned long long>(acts), static_cast<unsigned long long>(frames),
        early / 1e6, late / 1e6);
    EXPECT_LT(late, 1.05 * early + 16e6);
}

}  // namespace
}  // namespace glint
