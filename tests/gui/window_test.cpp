// The whole window with real events, rendering in the background all the time.
#include <QApplication>
#include <QDockWidget>
#include <QListWidget>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTreeView>
#include <fstream>

#include "gui/app/actions.h"
#include "gui/app/command_search.h"
#include "gui/app/export_queue.h"
#include "gui/app/file_controller.h"
#include "gui/app/material_previews.h"
#include "gui/app/renderer.h"
#include "gui/app/text.h"
#include "gui/panels/environment_picker.h"
#include "gui/panels/object_list.h"
#include "gui/panels/property_panel.h"
#include "gui/widgets/dial.h"
#include "gui/widgets/message_bar.h"
#include "gui/widgets/status_line.h"
#include "support.h"
#include "tracer/io/image_file.h"
#include "tracer/io/scene_json.h"

namespace glint {

using namespace test;

namespace {

/// The picture shows what the document holds: its middle shows (or no longer shows) an object.
bool middleShows(MainWindow& window, bool object) {
    const QPointF middle = QRectF(window.view().rect()).center();
    return QTest::qWaitFor(
        [&] { return window.view().context().surfaceAt(middle).has_value() == object; },
        kPatienceMs);
}

Scene lit(Scene scene) {
    scene.environment.color = Color{0.5, 0.5, 0.5};
    scene.render.spp = 4;
    return scene;
}

void write(const std::filesystem::path& file, const std::string& text) {
    std::ofstream(file) << text;
}

}  // namespace

class WindowTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    [[nodiscard]] std::filesystem::path file(const char* name) const {
        return toPath(folder_.filePath(name));
    }

  private slots:
    void pictureComesAndStatusTells() {
        const auto window = openWindow(lit(smallScene()));
        QTRY_VERIFY_WITH_TIMEOUT(window->renderer().frame() && window->renderer().frame()->spp > 0,
                                 kPatienceMs);
        QVERIFY(window->status().text().contains("spp"));
        QTRY_VERIFY_WITH_TIMEOUT(window->renderer().frame()->state == SessionState::Converged,
                                 kPatienceMs);
    }
    void clickSelectsAndEmptyGroundDeselects() {
        const auto window = openWindow(lit(smallScene()));
        QVERIFY(middleShows(*window, true));
        QTest::mouseClick(&window->view(), Qt::LeftButton, {}, window->view().rect().center());
        QCOMPARE(window->selection().items(), std::vector<Item>{kBall});
        QTest::mouseClick(&window->view(), Qt::LeftButton, {}, QPoint(5, 200));
        QVERIFY(window->selection().isEmpty());
    }
    void boxSelectsWhatItHolds() {
        const auto window = openWindow(lit(smallScene()));
        RenderView& view = window->view();
        drag(&view, Qt::LeftButton, QPoint(2, 2), QPoint(view.width() - 2, view.height() - 2));
        QVERIFY(window->selection().contains(kBall));
    }
    void addEditUndoRedo() {
        const auto window = openWindow(lit(smallScene()));
        const Scene before = window->document().scene();
        QAction* add = window->findChild<QAction*>("add.box");
        QVERIFY(add);
        add->trigger();
        QCOMPARE(window->document().scene().objects.size(), std::size_t(2));
        type(window->properties().findChild<DragNumber*>("object.shape.size.1"), "2.5");
        const Scene after = window->document().scene();
        (*window).actions()["edit.undo"]->trigger();
        (*window).actions()["edit.undo"]->trigger();
        QVERIFY(window->document().scene() == before);
        (*window).actions()["edit.redo"]->trigger();
        (*window).actions()["edit.redo"]->trigger();
        QVERIFY(window->document().scene() == after);
        QVERIFY(window->windowTitle().contains("*"));
    }
    void everyAddEntryMakesASoundScene() {
        const auto window = openWindow(lit(smallScene()));
        for (QAction* action : window->findChildren<QAction*>())
            if (action->objectName().startsWith("add.") && action->objectName() != "add.menu")
                action->trigger();
        QVERIFY(window->document().scene().objects.size() >= AllShapes::kinds.size());
        QVERIFY(parseScene(formatScene(window->document().scene()), "text").ok());
    }
    void deleteKeyDeletes() {
        const auto window = openWindow(lit(smallScene()));
        window->selection().set({kBall});
        window->actions()["edit.delete"]->trigger();
        QVERIFY(window->document().scene().objects.empty());
        QVERIFY(middleShows(*window, false));
    }
    void gizmoDragMovesInOneStep() {
        const auto window = openWindow(lit(smallScene()));
        RenderView& view = window->view();
        window->selection().set({kBall});
        window->actions()["tool.move"]->trigger();
        const ViewProjection projection = view.context().projection();
        const auto tip = axisEnd(projection, *view.context().gizmoFrame(), 0);
        drag(&view, Qt::LeftButton, tip->toPoint(), tip->toPoint() + QPoint(80, 0));
        const DVec3 moved = worldFromItem(window->document().scene(), kBall).translation;
        QVERIFY(moved.x > 0.2 && std::abs(moved.y) < 1e-9 && std::abs(moved.z) < 1e-9);
        QCOMPARE(window->document().undoStack().count(), 1);
        QCOMPARE(window->document().undoStack().undoText(), QString("Move"));
    }
    void typedNumberDuringADragIsExact() {
        const auto window = openWindow(lit(smallScene()));
        RenderView& view = window->view();
        window->selection().set({kBall});
        window->actions()["tool.move"]->trigger();
        const QPoint middle = view.rect().center();
        QTest::mousePress(&view, Qt::LeftButton, {}, middle);
        QTest::keyClicks(&view, "y1.5");
        QTest::keyClick(&view, Qt::Key_Return);
        QCOMPARE(worldFromItem(window->document().scene(), kBall).translation.y, 1.5);
        QTest::mouseRelease(&view, Qt::LeftButton, {}, middle);
        QCOMPARE(window->document().undoStack().count(), 1);
    }
    void escapeTakesADragBack() {
        const auto window = openWindow(lit(smallScene()));
        RenderView& view = window->view();
        window->selection().set({kBall});
        window->actions()["tool.move"]->trigger();
        const Scene before = window->document().scene();
        QTest::mousePress(&view, Qt::LeftButton, {}, view.rect().center());
        QMouseEvent move(QEvent::MouseMove, QPointF(50, 50), view.mapToGlobal(QPointF(50, 50)),
                         Qt::NoButton, Qt::LeftButton, {});
        QApplication::sendEvent(&view, &move);
        QVERIFY(!(window->document().scene() == before));
        QTest::keyClick(&view, Qt::Key_Escape);
        QVERIFY(window->document().scene() == before);
        QVERIFY(window->selection().contains(kBall));
    }
    void navigationMovesTheViewOnly() {
        const auto window = openWindow(lit(smallScene()));
        RenderView& view = window->view();
        const Camera start = window->document().scene().camera;
        drag(&view, Qt::MiddleButton, {300, 300}, {360, 320});
        const Camera orbited = window->document().scene().camera;
        QVERIFY(!(orbited == start));
        drag(&view, Qt::LeftButton, {300, 300}, {360, 320}, Qt::AltModifier);
        drag(&view, Qt::MiddleButton, {300, 300}, {360, 320}, Qt::ShiftModifier);
        drag(&view, Qt::RightButton, {300, 300}, {300, 330}, Qt::AltModifier);
        const Camera last = window->document().scene().camera;
        QVERIFY(!window->document().isModified());
        for (int i = 0; i < 4; ++i) window->actions()["view.previous"]->trigger();
        QVERIFY(window->document().scene().camera == start);
        for (int i = 0; i < 4; ++i) window->actions()["view.next"]->trigger();
        QVERIFY(window->document().scene().camera == last);
    }
    void wheelGoesNearer() {
        const auto window = openWindow(lit(smallScene()));
        RenderView& view = window->view();
        const QPointF at(view.width() / 2.0, view.height() / 2.0);
        QWheelEvent wheel(at, view.mapToGlobal(at), {}, {0, 120}, Qt::NoButton, {},
                          Qt::NoScrollPhase, false);
        QApplication::sendEvent(&view, &wheel);
        QVERIFY(window->document().scene().camera.position.z < 6);
    }
    void flightMovesWhileTheKeyIsHeld() {
        const auto window = openWindow(lit(smallScene()));
        RenderView& view = window->view();
        QTest::mousePress(&view, Qt::RightButton, {}, {200, 200});
        QTest::keyPress(&view, Qt::Key_W);
        QTRY_VERIFY_WITH_TIMEOUT(window->document().scene().camera.position.z < 5.8, kPatienceMs);
        QCOMPARE(view.tools().tool, Tool::Select);  // W was the flight's, not the move tool's.
        QTest::keyRelease(&view, Qt::Key_W);
        QTest::mouseRelease(&view, Qt::RightButton, {}, {200, 200});
        QVERIFY(!window->document().isModified());
    }
    void shiftRightDragTurnsTheEnvironment() {
        const auto window = openWindow(lit(smallScene()));
        drag(&window->view(), Qt::RightButton, {200, 200}, {300, 200}, Qt::ShiftModifier);
        QVERIFY(window->document().scene().environment.rotationDegrees != 0);
        QCOMPARE(window->document().undoStack().count(), 1);
    }
    void exposureNeedsNoNewRender() {
        const auto window = openWindow(lit(smallScene()));
        QTRY_VERIFY_WITH_TIMEOUT(window->renderer().frame() &&
                                     window->renderer().frame()->state == SessionState::Converged,
                                 kPatienceMs);
        const auto revision = window->renderer().frame()->revision;
        const auto pixel = [&] { return window->renderer().frame()->pixels.front() & 0xffU; };
        const auto before = pixel();
        window->actions()["view.brighter"]->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(pixel() > before, kPatienceMs);
        QCOMPARE(window->renderer().frame()->revision, revision);
        QCOMPARE(window->renderer().frame()->state, SessionState::Converged);
    }
    void environmentIsPickedAndUndone() {
        const auto window = openWindow(lit(smallScene()));
        QListWidget* thumbnails = window->environment().thumbnails();
        QVERIFY(thumbnails->count() > 1);
        emit thumbnails->itemActivated(thumbnails->item(2));
        QVERIFY(window->document().scene().environment.image.ends_with(".exr"));
        window->document().undoStack().undo();
        QVERIFY(window->document().scene().environment.image.empty());
        QCOMPARE(thumbnails->currentRow(), 0);
    }
    void savedSceneOpensEqual() {
        const auto window = openWindow(lit(smallScene()));
        emit window->environment().thumbnails()->itemActivated(
            window->environment().thumbnails()->item(2));
        const Scene scene = window->document().scene();
        QVERIFY(window->files().saveTo(file("saved.glint.json")));
        QVERIFY(!window->document().isModified());
        QVERIFY(!std::filesystem::path(window->document().scene().environment.image).is_absolute());
        const Scene saved = window->document().scene();
        window->document().replace({}, {});
        window->files().load(file("saved.glint.json"));
        QTRY_VERIFY_WITH_TIMEOUT(window->document().scene() == saved, kPatienceMs);
        QCOMPARE(window->windowTitle(), QStringLiteral("saved.glint.json — Glint"));
        QCOMPARE(window->document().scene().objects.size(), scene.objects.size());
    }
    void windowBeginsWithTheFileItIsGiven() {
        const Scene scene = lit(smallScene());
        QVERIFY(saveScene(scene, file("first.json")).ok());
        FileReading reading = readInBackground(file("first.json"));
        reading.content.waitForFinished();
        MainWindow window(Memory::None, reading);
        QVERIFY(window.document().scene() == scene);
        window.show();
        QTRY_COMPARE_WITH_TIMEOUT(window.windowTitle(), QStringLiteral("first.json — Glint"),
                                  kPatienceMs);
    }
    void dockIsFilledWhenItIsSeen() {
        const auto window = openWindow();
        QCoreApplication::processEvents();
        auto* dock = window->findChild<QDockWidget*>("render");
        QVERIFY(!dock->widget());
        dock->raise();
        QTRY_VERIFY_WITH_TIMEOUT(dock->widget() && dock->widget()->isVisible(), kPatienceMs);
    }
    void rowsKeepTheirHeightWhenASceneComes() {
        MainWindow window(Memory::None);
        window.show();
        const auto* tree = window.objectList().findChild<QTreeView*>();
        const auto height = [tree] {
            return tree->visualRect(tree->model()->index(0, 0)).height();
        };
        const int before = height();
        window.document().replace(smallScene(), {});
        QCoreApplication::processEvents();
        QCOMPARE(height(), before);
    }
    void previewsWaitForTheFirstPicture() {
        MainWindow window(Memory::None);
        MaterialPreviews& previews = window.materialPreviews();
        const QSignalSpy changes(&previews, &MaterialPreviews::changed);
        const MaterialId material = window.document().scene().materials.ids().front();
        QVERIFY(previews.of(material).isNull());
        window.show();
        QTRY_VERIFY_WITH_TIMEOUT(changes.count() > 0, kPatienceMs);
        QTRY_VERIFY_WITH_TIMEOUT(!previews.of(material).isNull(), kPatienceMs);
    }
    void brokenFileKeepsTheSceneAndSaysWhy_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::newRow("empty") << QByteArray();
        QTest::newRow("truncated") << QByteArray(R"({"glint": 1, "objects": [{"name")");
        QTest::newRow("no text") << QByteArray("\x00\xff\x80garbage", 10);
        QTest::newRow("misspelt") << QByteArray(R"({"glint": 1, "objcts": []})");
    }
    void brokenFileKeepsTheSceneAndSaysWhy() {
        QFETCH(QByteArray, text);
        const auto window = openWindow(lit(smallScene()));
        const Scene before = window->document().scene();
        write(file("broken.json"), text.toStdString());
        window->files().load(file("broken.json"));
        QTRY_VERIFY_WITH_TIMEOUT(window->messages().isVisible(), kPatienceMs);
        QVERIFY(window->messages().text().contains("broken.json"));
        QVERIFY(window->document().scene() == before);
    }
    void missingFileKeepsTheScene() {
        const auto window = openWindow(lit(smallScene()));
        const Scene before = window->document().scene();
        window->files().load(file("nowhere.json"));
        QTRY_VERIFY_WITH_TIMEOUT(window->messages().isVisible(), kPatienceMs);
        QVERIFY(window->document().scene() == before);
    }
    void partOfABadFileOpensAsUntitled() {
        const auto window = openWindow(lit(smallScene()));
        write(
            file("part.json"),
            R"({"glint": 1, "objects": [{"name": "Good", "shape": {"type": "sphere"}}, {"name": "Bad", "shape": {"type": "spher"}}]})");
        window->files().load(file("part.json"));
        QTRY_VERIFY_WITH_TIMEOUT(window->messages().isVisible(), kPatienceMs);
        auto* open = window->messages().findChild<QPushButton*>();
        QVERIFY(open);
        QTest::mouseClick(open, Qt::LeftButton);
        QCOMPARE(window->document().scene().objects.size(), std::size_t(1));
        QVERIFY(window->document().file().empty());
        QVERIFY(window->document().isModified());
    }
    void unsavedChangesAreAskedAbout() {
        const auto window = openWindow(lit(smallScene()));
        window->selection().set({kBall});
        window->actions()["edit.delete"]->trigger();
        window->close();
        QVERIFY(window->isVisible());
        auto* box = window->findChild<QMessageBox*>("unsavedChanges");
        QVERIFY(box);
        QTest::mouseClick(box->button(QMessageBox::Cancel), Qt::LeftButton);
        QVERIFY(window->isVisible());
        window->close();
        QTest::qWait(0);
        box = nullptr;
        for (QMessageBox* candidate : window->findChildren<QMessageBox*>("unsavedChanges"))
            if (candidate->isVisible()) box = candidate;
        QVERIFY(box);
        QTest::mouseClick(box->button(QMessageBox::Discard), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(!window->isVisible(), kPatienceMs);
    }
    void exportWritesAPicture() {
        const auto window = openWindow(lit(smallScene()));
        ExportRequest request{window->document().scene(), window->document().assetFolder(),
                              file("out.exr")};
        request.scene.film = {.width = 32, .height = 24};
        window->exports().add(request);
        QTRY_VERIFY_WITH_TIMEOUT(window->exports().isIdle(), kPatienceMs);
        const auto image = loadImage(file("out.exr"));
        QVERIFY2(image.ok(), image.ok() ? "" : image.error().text().c_str());
        QCOMPARE(image.value()->width, 32);
        QVERIFY(window->messages().text().contains("out.exr"));
    }
    void failedExportSaysWhy() {
        const auto window = openWindow(lit(smallScene()));
        ExportRequest request{window->document().scene(), {}, "/nowhere/out.exr"};
        request.scene.film = {.width = 8, .height = 8};
        window->exports().add(request);
        QTRY_VERIFY_WITH_TIMEOUT(window->exports().isIdle(), kPatienceMs);
        QVERIFY(window->messages().text().contains("/nowhere/out.exr"));
    }
    void canceledExportWritesNothing() {
        const auto window = openWindow(lit(smallScene()));
        ExportRequest request{window->document().scene(), {}, file("canceled.exr")};
        request.scene.render.spp = 1000000;
        window->exports().add(request);
        window->exports().cancelAll();
        QTRY_VERIFY_WITH_TIMEOUT(window->exports().isIdle(), kPatienceMs);
        QVERIFY(!std::filesystem::exists(file("canceled.exr")));
    }
    void closesInTheMiddleOfAPass() {
        Scene scene = lit(smallScene());
        scene.render.spp = 1000000;
        auto window = openWindow(scene);
        QTRY_VERIFY_WITH_TIMEOUT(window->renderer().frame() != nullptr, kPatienceMs);
        QElapsedTimer clock;
        clock.start();
        window.reset();
        QVERIFY2(clock.elapsed() < 5000, qPrintable(QString::number(clock.elapsed())));
    }
    void pauseKeepsThePicture() {
        Scene scene = lit(smallScene());
        scene.render.spp = 1000000;
        const auto window = openWindow(scene);
        QTRY_VERIFY_WITH_TIMEOUT(window->renderer().frame() && window->renderer().frame()->spp > 0,
                                 kPatienceMs);
        window->actions()["render.pause"]->trigger();
        QTRY_COMPARE_WITH_TIMEOUT(window->renderer().frame()->state, SessionState::Paused,
                                  kPatienceMs);
        QVERIFY(window->renderer().frame()->spp > 0);
        QVERIFY(window->status().text().contains("paused"));
    }
    void copyAndPasteMakesAnotherBall() {
        const auto window = openWindow(lit(smallScene()));
        window->selection().set({kBall});
        window->actions()["edit.copy"]->trigger();
        window->actions()["edit.paste"]->trigger();
        QCOMPARE(window->document().scene().objects.size(), std::size_t(2));
        QCOMPARE(window->selection().items().size(), std::size_t(1));
        QVERIFY(!window->selection().contains(kBall));
    }
    void groupAndUngroupKeepTheDocument() {
        const auto window = openWindow(lit(smallScene()));
        const Scene before = window->document().scene();
        window->selection().set({kBall});
        window->actions()["edit.group"]->trigger();
        QCOMPARE(window->document().scene().groups.size(), std::size_t(1));
        window->actions()["edit.ungroup"]->trigger();
        QVERIFY(window->document().scene().objects == before.objects);
    }
    void everyActionHasTextAndTip() {
        const auto window = openWindow(lit(smallScene()));
        for (const QAction* action : window->actions().all()) {
            QVERIFY2(!action->text().isEmpty(), qPrintable(action->objectName()));
            QVERIFY2(!action->toolTip().isEmpty(), qPrintable(action->objectName()));
        }
    }
    void noTwoActionsShareAKey() {
        const auto window = openWindow(lit(smallScene()));
        std::map<QString, QString> owner;
        for (const QAction* action : window->actions().all())
            for (const QKeySequence& key : action->shortcuts()) {
                const QString text = key.toString();
                QVERIFY2(!owner.contains(text),
                         qPrintable(text + " of " + action->objectName() + " and " + owner[text]));
                owner[text] = action->objectName();
            }
    }
    void savedViewsGoAndStore() {
        const auto window = openWindow(lit(smallScene()));
        window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(window.get()));  // Shortcuts are the active window's.
        const Camera start = window->document().scene().camera;
        QTest::keyClick(window.get(), Qt::Key_2, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(window->document().scene().views.size(), std::size_t(2));
        window->actions()["view.top"]->trigger();
        QVERIFY(!(window->document().scene().camera == start));
        QTest::keyClick(window.get(), Qt::Key_2, Qt::ControlModifier);
        QVERIFY(window->document().scene().camera == start);
    }
    void digitsOfTheKeypadTurnTheViewAndThoseAboveTheLettersChooseChannels() {
        const auto window = openWindow(lit(smallScene()));
        window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(window.get()));  // Shortcuts are the active window's.
        window->view().setFocus();
        QTest::keyClick(&window->view(), Qt::Key_7, Qt::KeypadModifier);
        const Camera above = window->document().scene().viewCamera();
        QVERIFY(glm::normalize(above.target - above.position).y < -0.999);
        QCOMPARE(window->renderer().channel(), Channel::Beauty);
        QTest::keyClick(&window->view(), Qt::Key_7);
        QCOMPARE(window->renderer().channel(), Channel::Samples);
    }
    void narrowWindowHasItsDocksInOneStackAndAWideOneBesideThePicture() {
        const auto window = openWindow();
        auto* objects = window->findChild<QDockWidget*>("objects");
        QCOMPARE(window->dockWidgetArea(objects), Qt::LeftDockWidgetArea);
        window->resize(800, 600);
        QTRY_COMPARE_WITH_TIMEOUT(window->dockWidgetArea(objects), Qt::RightDockWidgetArea,
                                  kPatienceMs);
        QTRY_VERIFY_WITH_TIMEOUT(window->view().width() >= 400, kPatienceMs);
        QTRY_COMPARE_WITH_TIMEOUT(window->size(), QSize(800, 600), kPatienceMs);
        window->resize(1400, 900);
        QTRY_COMPARE_WITH_TIMEOUT(window->dockWidgetArea(objects), Qt::LeftDockWidgetArea,
                                  kPatienceMs);
        QVERIFY(objects->isVisible());
    }
    void dockDoesNotGrowWithTheForm() {
        const auto window = openWindow();
        window->resize(1400, 900);
        QTest::qWait(50);
        const QSize picture = window->view().size();
        window->selection().set({kBall});
        QTest::qWait(50);
        QCOMPARE(window->view().size(), picture);
    }
    void dialsTurnByDragAndEscapeTakesItBack() {
        Scene scene = smallScene();
        scene.environment.sky = Sky{};
        const auto window = openWindow(scene);
        window->findChild<QDockWidget*>("environment")->raise();
        auto* turn = window->environment().findChild<Dial*>("environment.dial");
        auto* sun = window->environment().findChild<Dial*>("environment.sun");
        QVERIFY(turn && sun);
        QTRY_VERIFY_WITH_TIMEOUT(sun->isVisible() && sun->size() == sun->sizeHint(), kPatienceMs);
        const auto at = [](const Dial* dial, double right, double up) {
            return dial->rect().center() + QPoint(static_cast<int>(right * dial->width() / 2),
                                                  -static_cast<int>(up * dial->height() / 2));
        };
        Document& document = window->document();
        // From the top a quarter clockwise.
        test::drag(turn, Qt::LeftButton, at(turn, 0, 0.6), at(turn, 0.6, 0));
        QVERIFY(std::abs(document.committed().environment.rotationDegrees - 90) < 8);
        test::drag(sun, Qt::LeftButton, at(sun, 0, 0), at(sun, 0.5, 0));
        const DVec3 east = document.committed().environment.sky->sunDirection;
        QVERIFY(east.x > 0.5 && std::abs(east.z) < 0.1 && east.y > 0.2);
        QCOMPARE(document.undoStack().count(), 2);
        const Scene before = document.scene();
        for (Dial* dial : {turn, sun}) {
            QTest::mousePress(dial, Qt::LeftButton, {}, at(dial, -0.5, 0));
            QMouseEvent move(QEvent::MouseMove, QPointF(at(dial, 0, -0.5)), QPointF(), Qt::NoButton,
                             Qt::LeftButton, {});
            QApplication::sendEvent(dial, &move);
            QVERIFY(document.isPreviewing());
            QTest::mouseRelease(dial, Qt::RightButton, {},
                                at(dial, 0, 0));  // Another button ends nothing.
            QVERIFY(document.isPreviewing());
            QTest::keyClick(dial, Qt::Key_Escape);
            QVERIFY(!document.isPreviewing() && document.scene() == before);
            QTest::mouseRelease(dial, Qt::LeftButton, {}, at(dial, 0, 0));
            QVERIFY(document.scene() == before);
        }
        QTest::keyClick(turn, Qt::Key_Right);
        QVERIFY(std::abs(document.committed().environment.rotationDegrees -
                         before.environment.rotationDegrees - 5) < 1e-9);
    }
    void numbersLoseDigitsRatherThanBeingCut() {
        DragNumber number;
        number.resize(200, 24);
        number.show();
        number.setValue(-12.3457);
        QCOMPARE(number.text(), QStringLiteral("-12.3457"));
        number.resize(number.fontMetrics().horizontalAdvance("-12.3") + 8, 24);
        QCOMPARE(number.text(), QStringLiteral("-12.3"));
        QCOMPARE(number.value(), -12.3457);
    }
};

}  // namespace glint

QTEST_MAIN(glint::WindowTest)
#include "window_test.moc"
