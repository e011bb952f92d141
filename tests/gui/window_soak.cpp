#include "tests/gui/window_soak.h"

#include <unistd.h>

#include <QTest>
#include <QUndoStack>
#include <cstdio>
#include <fstream>
#include <random>

#include "gui/app/document.h"
#include "gui/app/renderer.h"
#include "gui/viewport/render_view.h"
#include "tests/bench/clock.h"
#include "tests/bench/viewport_scene.h"
#include "tracer/math/statistics.h"

namespace glint::bench {

namespace {

/// What the process holds in memory [MB].
double residentMegabytes() {
    std::ifstream file("/proc/self/statm");
    double pages = 0, resident = 0;
    file >> pages >> resident;
    return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

class Visitor {
  public:
    explicit Visitor(MainWindow& window) : window_(window), size_(window.size()) {}

    void act() {
        QUndoStack& undo = window_.document().undoStack();
        // As many steps back as forth: what is to be undone is memory in use.
        constexpr int kMostSteps = 200;
        if (undo.index() > kMostSteps)
            while (undo.canUndo()) undo.undo();
        switch (random_() % 16) {
            case 0:
                return undo.undo();
            case 1:
                return undo.redo();
            case 2:
                return window_.renderer().setPaused(!window_.renderer().isPaused());
            case 3:
                return window_.renderer().setChannel(static_cast<Channel>(random_() % kChannels));
            case 4:
                return window_.renderer().setFiltered(!window_.renderer().isFiltered());
            case 5:
                return window_.resize(size_ - QSize(below(200), below(200)));
            case 6:
                return select();
            default:
                return edit();
        }
    }

  private:
    int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
    void select() {
        const std::vector<ObjectId> ids = window_.document().scene().objects.ids();
        if (!ids.empty()) window_.selection().set({Item::of(ids[random_() % ids.size()])});
    }
    void edit() {
        Scene next = window_.document().scene();
        editScene(next, kEditKinds[random_() % kEditKinds.size()], random_);
        window_.document().edit(std::move(next), QStringLiteral("Edit"));
    }

    MainWindow& window_;
    QSize size_;
    std::mt19937 random_{1};
};

}  // namespace

void soak(MainWindow& window, double minutes, Json& json) {
    window.renderer().setThreads(1);
    Visitor visitor(window);
    const Stopwatch watch;
    std::vector<double> megabytes;
    std::uint64_t actions = 0;
    while (watch.wallSeconds() < 60 * minutes) {
        visitor.act();
        ++actions;
        QTest::qWait(static_cast<int>(actions * 7919 % 60));
        if (watch.wallSeconds() < 60.0 * (static_cast<double>(megabytes.size()) + 1)) continue;
        megabytes.push_back(residentMegabytes());
        std::printf("%4zu min, %8llu actions, %.0f MB\n", megabytes.size(),
                    static_cast<unsigned long long>(actions), megabytes.back());
        std::fflush(stdout);
    }
    json.push_back({{"what", "soak"}, {"actions", actions}, {"megabytes", megabytes}});
    if (megabytes.size() < 3) return;
    const auto third = static_cast<std::ptrdiff_t>(megabytes.size() / 3);
    const double middle = median({megabytes.begin() + third, megabytes.begin() + 2 * third}),
                 last = median({megabytes.end() - third, megabytes.end()});
    std::printf("median of the middle third %.0f MB, of the last %.0f MB: %+.1f %%\n", middle, last,
                100 * (last / middle - 1));
}

}  // namespace glint::bench
