// The window while its picture is rendered: random edits, undos, resizes, pauses, channels, regions
// and windows that close in the middle of it. What is shown in the end is the bits of a render of
// its own. 10 000 acts under AddressSanitizer and with GLINT_FULL=1, else 300.
#include <QApplication>
#include <random>

#include "gui/app/actions.h"
#include "gui/app/renderer.h"
#include "gui/viewport/projection.h"
#include "support.h"
#include "tests/bench/viewport_scene.h"
#include "tracer/color/display.h"
#include "tracer/compile/compiler.h"
#include "tracer/io/scene_check.h"
#include "tracer/render/render.h"

namespace glint {

using namespace test;

namespace {

/// Small, with all that an edit can reach, and quick to converge.
Scene busyScene() {
    Scene scene = bench::manyShapes(40);
    scene.lights.add({"Sun", SunLight{}, true, {}});
    scene.render.spp = 3;
    scene.render.maxDepth = 4;
    return scene;
}

class LivingWindow {
  public:
    explicit LivingWindow(unsigned seed) : random_(seed) { open(); }

    /// One act, and now and then a look at what came of it.
    void act() {
        switch (below(16)) {
            case 0:
                return window_->document().undoStack().undo();
            case 1:
                return window_->document().undoStack().redo();
            case 2:
                return window_->resize(700 + below(500), 500 + below(300));
            case 3:
                return renderer().setPaused(!renderer().isPaused());
            case 4:
                return renderer().setChannel(
                    static_cast<Channel>(below(static_cast<int>(kChannels))));
            case 5:
                return renderer().setFiltered(!renderer().isFiltered());
            case 6:
                return renderer().setRegion(
                    below(2) ? std::optional(QRectF(0.1 * below(5), 0.1 * below(5), 0.4, 0.3))
                             : std::nullopt);
            case 7:
                return renderer().setThreads(1 + below(3));
            case 8:
                return renderer().reload();
            case 9:
                return isolate();
            case 10:
                return compare();
            case 11:
                return below(20) ? preview() : open();  // The old window goes whatever it is doing.
            default:
                return edit();
        }
    }
    MainWindow& window() { return *window_; }
    Renderer& renderer() { return window_->renderer(); }

  private:
    int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }

    void open() {
        window_ = openWindow(busyScene());
        window_->resize(800, 600);
    }
    Scene edited() {
        Scene next = window_->document().scene();
        bench::editScene(next,
                         bench::kEditKinds[static_cast<std::size_t>(
                             below(static_cast<int>(bench::kEditKinds.size())))],
                         random_);
        return next;
    }
    void edit() { window_->document().edit(edited(), "Edit"); }
    /// A drag: many values, one step of undo or none.
    void preview() {
        for (int i = below(4); i >= 0; --i) {
            window_->document().preview(edited());
            QCoreApplication::processEvents();
        }
        if (below(2))
            window_->document().commitPreview("Drag");
        else
            window_->document().cancelPreview();
    }
    void isolate() {
        if (below(2)) return renderer().setIsolated({});
        const auto ids = window_->document().scene().objects.ids();
        if (!ids.empty())
            renderer().setIsolated(
                {ids[static_cast<std::size_t>(below(static_cast<int>(ids.size())))]});
    }
    void compare() {
        const Scene* before = window_->document().sceneBefore();
        renderer().setCompared(before && !renderer().isComparing() ? std::optional(*before)
                                                                   : std::nullopt);
    }

    std::mt19937 random_;
    std::unique_ptr<MainWindow> window_;
};

/// What a render of its own shows of the window's document.
std::vector<std::uint32_t> rendered(const Scene& document, int width, int height) {
    Scene scene =
        withViewCamera(document, fittedCamera(document.viewCamera(), document.film, width, height));
    scene.film.width = width;
    scene.film.height = height;
    AssetCache assets;
    auto compiled = compile(scene, {}, assets);
    const Rendering rendering = render(compiled.value().scene, {});
    const DisplayTransform transform({scene.display.exposureEv, scene.display.view});
    std::vector<std::uint32_t> out;
    for (std::size_t i = 0; i + 2 < rendering.beauty.rgb.size(); i += 3)
        out.push_back(transform.apply(
            {rendering.beauty.rgb[i], rendering.beauty.rgb[i + 1], rendering.beauty.rgb[i + 2]}));
    return out;
}

}  // namespace

class LivingWindowTest : public QObject {
    Q_OBJECT

  private slots:
    void survivesAllThatCanHappenWhileItRenders() {
        const int acts = isLongRun() ? 10000 : 300;
        constexpr unsigned kSeed = 3;
        LivingWindow living(kSeed);
        std::mt19937 pause(kSeed);
        for (int i = 0; i < acts; ++i) {
            living.act();
            if (pause() % 4 == 0)
                QTest::qWait(static_cast<int>(pause() % 8));
            else
                QCoreApplication::processEvents();
            if (i % 100 == 0)
                QVERIFY2(sceneProblems(living.window().document().scene()).empty(),
                         qPrintable(QStringLiteral("act %1").arg(i)));
            if ((i + 1) % 1000 == 0) {
                std::printf("%d acts\n", i + 1);
                std::fflush(stdout);
            }
        }
        Renderer& renderer = living.renderer();
        renderer.setCompared({});
        renderer.setIsolated({});
        renderer.setRegion({});
        renderer.setFiltered(false);
        renderer.setChannel(Channel::Beauty);
        renderer.setPaused(false);
        // A light edit may have been shown by mixing what was sampled for other lights, the same
        // light but not the same bits: all anew.
        constexpr int kNewSeed = 77;
        Document& document = living.window().document();
        Scene last = document.scene();
        last.render.seed = kNewSeed;
        document.edit(last, "Edit");
        const auto isDone = [&] {
            const SessionFrame* frame = renderer.frame();
            return frame && frame->scene->settings.seed == kNewSeed &&
                   frame->state == SessionState::Converged && frame->channel == Channel::Beauty &&
                   !frame->region;
        };
        QVERIFY(QTest::qWaitFor(isDone, 60000));
        const SessionFrame& frame = *renderer.frame();
        QCOMPARE(frame.nonfiniteSamples, 0u);
        const auto exact = rendered(document.scene(), frame.width, frame.height);
        QVERIFY2(frame.pixels == exact, "the window shows other bits than a render of its own");
    }
};

}  // namespace glint

QTEST_MAIN(glint::LivingWindowTest)
#include "living_window_test.moc"
