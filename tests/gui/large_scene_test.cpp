// 5 000 objects in the whole window: prints how long the interface's thread is busy with each thing
// that a person does. The bars are 1 s to open and 50 ms for the rest, in processor time of that
// thread; a test fails only far above them.
#include <QApplication>
#include <QLineEdit>
#include <QScrollBar>
#include <QTemporaryDir>
#include <QTreeView>
#include <cstdio>
#include <ctime>

#include "gui/app/actions.h"
#include "gui/app/file_controller.h"
#include "gui/app/renderer.h"
#include "gui/app/text.h"
#include "gui/panels/object_list.h"
#include "gui/panels/object_model.h"
#include "gui/panels/property_panel.h"
#include "support.h"
#include "tracer/io/scene_json.h"

namespace glint {

using namespace test;

namespace {

constexpr int kObjects = 5000;

/// Balls in a square, in groups of 100, of a few materials.
Scene largeScene() {
    Scene scene;
    for (int i = 0; i < 5; ++i) scene.materials.add({"Material " + std::to_string(i), Diffuse{}});
    for (int i = 0; i < kObjects / 100; ++i)
        scene.groups.add({"Group " + std::to_string(i), {}, {}});
    std::vector<Object> objects;
    for (int i = 0; i < kObjects; ++i) {
        Object object;
        object.name = "Ball " + std::to_string(i);
        object.shape = Sphere{0.3 + 0.0001 * i};
        object.material = MaterialId{static_cast<std::uint32_t>(i % 5 + 1)};
        object.parent = GroupId{static_cast<std::uint32_t>(i / 100 + 1)};
        object.transform.translate = {i % 70 - 35.0, 0.3, i / 70 - 35.0};
        objects.push_back(std::move(object));
    }
    scene.objects.addAll(std::move(objects));
    scene.lights.add({"Key", PointLight{}, true, {}});
    return scene;
}

double threadMs() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

/// Processor time of `work` and of all that it brings about at once: layout, painting.
template <class Work>
double busyMs(Work&& work) {
    QCoreApplication::processEvents();
    const double start = threadMs();
    work();
    for (int i = 0; i < 3; ++i) QCoreApplication::processEvents();
    return threadMs() - start;
}

}  // namespace

class LargeSceneTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    std::unique_ptr<MainWindow> window_;

    void report(const char* what, double ms, double bar) {
        std::printf("%-44s %7.1f ms (bar %.0f)\n", what, ms, bar);
        std::fflush(stdout);
        QVERIFY2(ms < 4 * bar, what);
    }
    QTreeView* tree() { return window_->objectList().tree(); }
    std::vector<Item> all() const {
        std::vector<Item> out;
        window_->document().scene().objects.forEach(
            [&](ObjectId id, const Object&) { out.push_back(Item::of(id)); });
        return out;
    }

  private slots:
    void initTestCase() {
        applyTheme(Theme::Dark);
        const auto file = toPath(folder_.filePath("large.json"));
        QVERIFY(saveScene(largeScene(), file).ok());
        window_ = std::make_unique<MainWindow>(Memory::None);
        window_->resize(1200, 800);
        window_->show();
        QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
        const double inThread = busyMs([&] {
            window_->files().load(file);
            QTRY_COMPARE_WITH_TIMEOUT(window_->document().scene().objects.size(),
                                      std::size_t(kObjects), kPatienceMs);
        });
        report("open: the interface's thread", inThread, 1000);
        const double reading = busyMs([&] { QVERIFY(loadScene(file).ok()); });
        report("open: reading the file", reading, 1000);
        window_->renderer().setPaused(true);
        tree()->expandAll();
    }
    void selectOneByClick() {
        const QModelIndex row = tree()->model()->index(2, 0, tree()->model()->index(0, 0));
        tree()->scrollTo(row);
        report("select one by a click", busyMs([&] {
                   QTest::mouseClick(tree()->viewport(), Qt::LeftButton, {},
                                     tree()->visualRect(row).center());
               }),
               50);
        QCOMPARE(window_->selection().items().size(), std::size_t(1));
    }
    void selectAllAndNone() {
        report("select all", busyMs([&] { window_->actions()["edit.selectAll"]->trigger(); }), 50);
        QVERIFY(window_->selection().items().size() >= std::size_t(kObjects));
        report("select none", busyMs([&] { window_->selection().clear(); }), 50);
        report("select every object", busyMs([&] { window_->selection().set(all()); }), 50);
    }
    void scroll() {
        double worst = 0;
        for (int i = 0; i < 60; ++i) {
            const double ms = busyMs([&] { tree()->verticalScrollBar()->setValue(i * 97); });
            worst = std::max(worst, ms);
        }
        report("scroll the list, worst step", worst, 50);
    }
    void rename() {
        const Item item = Item::of(ObjectId{2500});
        report("select one", busyMs([&] { window_->selection().set({item}); }), 50);
        report("rename: begin", busyMs([&] { window_->actions()["edit.rename"]->trigger(); }), 50);
        auto* editor = tree()->findChild<QLineEdit*>();
        QVERIFY(editor);
        editor->selectAll();
        const double ms = busyMs([&] {
            QTest::keyClicks(editor, "New");
            QTest::keyClick(editor, Qt::Key_Return);
        });
        QTRY_COMPARE_WITH_TIMEOUT(nameOf(window_->document().scene(), item), std::string("New"),
                                  kPatienceMs);
        report("rename: type and end", ms, 50);
        report("rename: undo", busyMs([&] { window_->actions()["edit.undo"]->trigger(); }), 50);
    }
    void search() {
        auto* line = window_->objectList().findChild<QLineEdit*>();
        report("search: a letter", busyMs([&] { QTest::keyClicks(line, "4"); }), 50);
        report("search: another", busyMs([&] { QTest::keyClicks(line, "9"); }), 50);
        report("search: cleared", busyMs([&] { line->clear(); }), 50);
    }
    void editOne() {
        window_->selection().set({Item::of(ObjectId{7})});
        auto* radius = window_->properties().findChild<DragNumber*>("object.shape.radius");
        QVERIFY(radius);
        report("type a radius", busyMs([&] { type(radius, "0.4"); }), 50);
    }
    void editAll() {
        window_->selection().set(all());
        auto* radius = window_->properties().findChild<DragNumber*>("object.shape.radius");
        QVERIFY(radius);
        report("type a radius for 5 000", busyMs([&] { type(radius, "0.35"); }), 50);
        report("its undo", busyMs([&] { window_->actions()["edit.undo"]->trigger(); }), 50);
    }
    void hideAndDragAll() {
        report("hide 5 000", busyMs([&] { window_->actions()["edit.hide"]->trigger(); }), 50);
        report("its undo", busyMs([&] { window_->actions()["edit.undo"]->trigger(); }), 50);
        window_->actions()["tool.move"]->trigger();
        RenderView& view = window_->view();
        QVERIFY(view.context().gizmoFrame());
        const QPointF at =
            *view.context().projection().project(view.context().gizmoFrame()->origin);
        QTest::mousePress(&view, Qt::LeftButton, {}, at.toPoint());
        double worst = 0;
        for (int i = 1; i < 6; ++i) {
            QMouseEvent move(QEvent::MouseMove, at + QPointF(9 * i, 0), view.mapToGlobal(at),
                             Qt::NoButton, Qt::LeftButton, {});
            worst = std::max(worst, busyMs([&] { QApplication::sendEvent(&view, &move); }));
        }
        QTest::mouseRelease(&view, Qt::LeftButton, {}, at.toPoint());
        report("drag 5 000, worst step", worst, 50);
    }
    void orbit() {
        RenderView& view = window_->view();
        QTest::mousePress(&view, Qt::MiddleButton, {}, QPoint(200, 200));
        double worst = 0;
        for (int i = 1; i < 10; ++i) {
            const QPointF at(200 + 5 * i, 200);
            QMouseEvent move(QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton,
                             Qt::MiddleButton, {});
            worst = std::max(worst, busyMs([&] { QApplication::sendEvent(&view, &move); }));
        }
        QTest::mouseRelease(&view, Qt::MiddleButton, {}, QPoint(250, 200));
        report("orbit with 5 000 selected, worst step", worst, 50);
    }
    void cleanupTestCase() { window_.reset(); }
};

}  // namespace glint

QTEST_MAIN(glint::LargeSceneTest)
#include "large_scene_test.moc"
