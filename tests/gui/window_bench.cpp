// glint-window-bench: the editor's window under random edits: how long its thread is held, how soon
// an edit is on the screen, and what a window costs that has nothing to do. A measurement, not a
// test. Usage: glint-window-bench SCENE [EDITS] [JSON], or for memory glint-window-bench soak SCENE
// [MINUTES] [JSON].
#include <QApplication>
#include <QEventLoop>
#include <QPaintEvent>
#include <QTest>
#include <QTimer>
#include <algorithm>
#include <cstdio>
#include <random>

#include "gui/app/document.h"
#include "gui/app/main_window.h"
#include "gui/app/renderer.h"
#include "gui/app/text.h"
#include "gui/app/theme.h"
#include "gui/viewport/render_view.h"
#include "tests/bench/clock.h"
#include "tests/bench/output.h"
#include "tests/bench/viewport_scene.h"
#include "tests/gui/window_soak.h"
#include "tracer/io/scene_json.h"

using namespace glint;
using namespace glint::bench;

namespace {

constexpr int kWidth = 1280, kHeight = 720;  // of the picture

/// How long calls took [ms]: on the clock, and of the processor alone, which other programs do not
/// add to.
struct Times {
    std::vector<double> clock, processor;
    void add(const Stopwatch& watch) {
        clock.push_back(1e3 * watch.wallSeconds());
        processor.push_back(1e3 * watch.threadSeconds());
    }
};

double at(std::vector<double> values, double share) {
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
}

/// Times what the renderer has the window's thread do: taking a frame and drawing it.
class TimedApplication : public QApplication {
  public:
    using QApplication::QApplication;
    Times take, paint, any;
    const QObject *renderer = nullptr, *view = nullptr;
    std::function<void()> painted;

    bool notify(QObject* receiver, QEvent* event) override {
        const bool takes = receiver == renderer && event->type() == QEvent::MetaCall,
                   paints = receiver == view && event->type() == QEvent::Paint;
        const Stopwatch watch;
        ++depth_;
        const bool result = QApplication::notify(receiver, event);
        --depth_;
        if (takes) take.add(watch);
        if (paints) paint.add(watch);
        if (depth_ == 0) any.add(watch);
        if (paints && painted) painted();
        return result;
    }

  private:
    int depth_ = 0;
};

void print(const char* what, const Times& times, Json& json) {
    std::printf(
        "%-28s %6zu times: p50 %.2f, p99 %.2f, p99.9 %.2f, longest %.2f ms; of the processor p99.9 "
        "%.2f ms\n",
        what, times.clock.size(), at(times.clock, 0.5), at(times.clock, 0.99),
        at(times.clock, 0.999), at(times.clock, 1), at(times.processor, 0.999));
    json.push_back({{"what", what},
                    {"count", times.clock.size()},
                    {"p50_ms", at(times.clock, 0.5)},
                    {"p99_ms", at(times.clock, 0.99)},
                    {"p999_ms", at(times.clock, 0.999)},
                    {"processor_p999_ms", at(times.processor, 0.999)}});
}

void print(const char* what, const std::vector<double>& ms, Json& json) {
    std::printf("%-28s %6zu times: p50 %.2f, p95 %.2f, p99 %.2f ms\n", what, ms.size(), at(ms, 0.5),
                at(ms, 0.95), at(ms, 0.99));
    json.push_back({{"what", what},
                    {"count", ms.size()},
                    {"p50_ms", at(ms, 0.5)},
                    {"p95_ms", at(ms, 0.95)},
                    {"p99_ms", at(ms, 0.99)}});
}

/// Lets the window alone for so long. A loop that sleeps: QTest::qWait() polls.
void rest(int milliseconds) {
    QEventLoop loop;
    QTimer::singleShot(milliseconds, &loop, &QEventLoop::quit);
    loop.exec();
}

}  // namespace

int main(int argc, char** argv) {
    TimedApplication application(argc, argv);
    const bool soaks = argc > 1 && std::string_view(argv[1]) == "soak";
    if (soaks) {
        --argc;
        ++argv;
    }
    if (argc < 2) {
        std::fprintf(stderr,
                     "usage: glint-window-bench SCENE [EDITS] [JSON]\n       glint-window-bench "
                     "soak SCENE [MINUTES] [JSON]\n");
        return 1;
    }
    auto loaded = loadScene(argv[1]);
    if (!loaded) return complain(loaded.error(), 2);
    const int edits = argc > 2 ? std::atoi(argv[2]) : 1000;
    applyTheme(Theme::Dark);
    MainWindow window(Memory::None);
    Scene scene = loaded.value();
    scene.render.spp = 1 << 20;
    window.document().replace(scene, std::filesystem::absolute(argv[1]));
    window.show();
    window.resize(window.size() + QSize(kWidth, kHeight) - window.view().size());
    Renderer& renderer = window.renderer();
    const auto frame = [&] { return renderer.frame(); };
    if (!QTest::qWaitFor([&] { return frame() && frame()->spp > 0; }, 60000))
        return complain({.message = "no picture came"}, 4);
    std::printf("picture of %d x %d\n", frame()->width, frame()->height);

    Json json = Json::array();
    if (soaks) {
        soak(window, argc > 2 ? std::atof(argv[2]) : 60, json);
        return writeJson(argc > 3 ? argv[3] : "", json) ? 0 : 3;
    }
    std::mt19937 random(1);
    Times edit;
    std::vector<double> shown;
    std::optional<Stopwatch> sinceEdit;
    std::uint64_t wanted = 0;
    application.renderer = &renderer;
    application.view = &window.view();
    QEventLoop untilShown;  // Sleeps between events, as the application's own loop:
                            // QTest::qWaitFor() polls every 10 ms.
    application.painted = [&] {
        if (!sinceEdit || !frame() || frame()->revision < wanted) return;
        shown.push_back(1e3 * sinceEdit->wallSeconds());
        sinceEdit.reset();
        untilShown.quit();
    };
    application.any = {};
    for (int i = 0; i < edits; ++i) {
        Scene next = window.document().scene();
        editScene(next, kEditKinds[static_cast<std::size_t>(i) % kEditKinds.size()], random);
        if (next == window.document().scene()) continue;
        wanted = frame()->revision + 1;
        sinceEdit.emplace();
        const Stopwatch watch;
        window.document().edit(std::move(next), QStringLiteral("Edit"), QStringLiteral("bench"));
        edit.add(watch);
        QTimer patience;
        patience.setSingleShot(true);
        QObject::connect(&patience, &QTimer::timeout, &untilShown, &QEventLoop::quit);
        patience.start(10000);
        if (sinceEdit) untilShown.exec();
        if (sinceEdit) return complain({.message = "an edit was not shown within ten seconds"}, 4);
        rest(static_cast<int>(random() % 40));
    }
    print("take a frame", application.take, json);
    print("draw it", application.paint, json);
    print("edit call, whole window", edit, json);
    print("any event, whole window", application.any, json);
    print("edit until drawn", shown, json);

    Scene ends = window.document().scene();
    ends.render.spp = 4;
    window.document().edit(ends, QStringLiteral("Edit"));
    if (!QTest::qWaitFor([&] { return frame()->state == SessionState::Converged; }, 600000))
        return complain({.message = "the picture did not converge"}, 4);
    const auto idle = [&](const char* what) {
        // Pictures of materials and the like may still be in the making.
        for (int i = 0; i < 60; ++i) {
            const Stopwatch second;
            rest(1000);
            if (second.processSeconds() < 0.005) break;
        }
        const std::uint64_t rays = frame()->rays;
        const Stopwatch watch;
        rest(5000);
        const double share = watch.processSeconds() / watch.wallSeconds();
        std::printf("%-28s %.3f %% of a processor, %llu rays\n", what, 100 * share,
                    static_cast<unsigned long long>(frame()->rays - rays));
        json.push_back(
            {{"what", what}, {"processor_share", share}, {"rays", frame()->rays - rays}});
    };
    idle("converged");
    ends.render.spp = 1 << 20;
    window.document().edit(ends, QStringLiteral("Edit"));
    rest(200);
    window.showMinimized();
    idle("minimised, not converged");
    window.showNormal();
    rest(500);
    window.hide();
    idle("hidden, not converged");
    return writeJson(argc > 3 ? argv[3] : "", json) ? 0 : 3;
}
