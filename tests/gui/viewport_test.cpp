// Hands on the picture: selecting, gizmos, navigation, each with real events.
#include <QApplication>
#include <QClipboard>
#include <QMenu>
#include <QSignalSpy>
#include <QWheelEvent>
#include <cmath>

#include "gui/app/actions.h"
#include "gui/app/renderer.h"
#include "gui/viewport/overlay.h"
#include "gui/viewport/selection_outline.h"
#include "support.h"
#include "tracer/compile/compiler.h"

namespace glint {

using namespace test;

namespace {

/// Two balls beside each other, a ring behind, seen from the front.
Scene threeThings() {
    Scene scene = smallScene();
    scene.environment.color = Color{0.5, 0.5, 0.5};
    Object right;
    right.name = "Right";
    right.shape = Sphere{0.6};
    right.transform.translate = {1.4, 0, 0.5};
    scene.objects.add(right);
    Object ring;
    ring.name = "Ring";
    ring.shape = Torus{1.6, 0.1};
    ring.transform.rotateDegrees = {80, 0, 20};
    ring.transform.translate = {0, 0, -1};
    scene.objects.add(ring);
    scene.camera.position = {0, 0, 6};
    scene.camera.target = {0, 0, 0};
    return scene;
}

const Item kRight = Item::of(ObjectId{2});

void moveTo(QWidget* widget, const QPointF& at, Qt::MouseButtons buttons,
            Qt::KeyboardModifiers modifiers = {}) {
    QMouseEvent move(QEvent::MouseMove, at, widget->mapToGlobal(at), Qt::NoButton, buttons,
                     modifiers);
    QApplication::sendEvent(widget, &move);
}

DVec3 placeOf(MainWindow& window, Item item) {
    return worldFromItem(window.document().scene(), item).translation;
}

bool isNear(double a, double b, double tolerance = 1e-9) { return std::abs(a - b) <= tolerance; }

}  // namespace

class ViewportTest : public QObject {
    Q_OBJECT

    std::unique_ptr<MainWindow> window_;
    RenderView& view() { return window_->view(); }
    QPoint pixelOf(const DVec3& point) {
        return view().context().projection().project(point)->toPoint();
    }
    const Camera& camera() { return window_->document().scene().camera; }
    void open(const Scene& scene = threeThings()) {
        window_ = openWindow(scene);
        window_->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(window_.get()));
        view().setFocus();
        QTRY_VERIFY_WITH_TIMEOUT(
            view().context().surfaceAt(QRectF(view().rect()).center()).has_value(), kPatienceMs);
    }
    void useTool(const char* tool, Item item) {
        window_->selection().set({item});
        window_->actions()[tool]->trigger();
        QVERIFY(view().context().gizmoFrame());
    }
    /// The end of an axis handle, on the screen.
    QPoint tipOf(int axis) {
        return axisEnd(view().context().projection(), *view().context().gizmoFrame(), axis)
            ->toPoint();
    }

  private slots:
    void comparingShowsThePictureBeforeTheLastStepAtOnce() {
        Scene scene = threeThings();
        scene.render.spp = 4;
        open(scene);
        const Renderer& renderer = window_->renderer();
        const auto converged = [&] {
            const SessionFrame* frame = renderer.frame();
            return frame && frame->state == SessionState::Converged &&
                   QSize(frame->width, frame->height) == view().size() * view().devicePixelRatioF();
        };
        useTool("tool.move", kRight);
        QTest::qWait(200);  // The panel of the selection takes its place.
        QTRY_VERIFY_WITH_TIMEOUT(converged(), kPatienceMs);
        const auto before = renderer.frame()->pixels;
        drag(&view(), Qt::LeftButton, tipOf(0), tipOf(0) + QPoint(40, 0));
        QTRY_VERIFY_WITH_TIMEOUT(converged() && renderer.frame()->pixels != before, kPatienceMs);
        const auto after = renderer.frame()->pixels;
        const std::uint64_t rays = renderer.frame()->rays;
        window_->actions()["view.compare"]->trigger();
        QTRY_COMPARE_WITH_TIMEOUT(renderer.frame()->pixels, before, kPatienceMs);
        window_->actions()["view.compare"]->trigger();
        QTRY_COMPARE_WITH_TIMEOUT(renderer.frame()->pixels, after, kPatienceMs);
        QCOMPARE(renderer.frame()->rays, rays);
        window_->actions()["view.compare"]->trigger();
        window_->document().undoStack().undo();
        QVERIFY(!renderer.isComparing());
        QVERIFY(!window_->actions()["view.compare"]->isEnabled());
    }
    void cleanup() { window_.reset(); }

    // ---- Selecting ----

    void shiftClickExtendsAndTakesOut() {
        open();
        QTest::mouseClick(&view(), Qt::LeftButton, {}, pixelOf({0, 0, 1}));
        QTest::mouseClick(&view(), Qt::LeftButton, Qt::ShiftModifier, pixelOf({1.4, 0, 1.1}));
        QCOMPARE(window_->selection().items(), (std::vector<Item>{kBall, kRight}));
        QTest::mouseClick(&view(), Qt::LeftButton, Qt::ShiftModifier, pixelOf({0, 0, 1}));
        QCOMPARE(window_->selection().items(), std::vector<Item>{kRight});
        QTest::keyClick(window_.get(), Qt::Key_Escape);
        QVERIFY(window_->selection().isEmpty());
    }
    void clickOnALightsMarkSelectsIt() {
        Scene scene = threeThings();
        PointLight light;
        light.position = {-2, 1.5, 0};
        scene.lights.set(LightId{1}, {"Key", light, true, {}});
        open(scene);
        QTest::mouseClick(&view(), Qt::LeftButton, {}, pixelOf({-2, 1.5, 0}));
        QCOMPARE(window_->selection().items(), std::vector<Item>{Item::of(LightId{1})});
    }
    void aSunHasAMarkInTheSky() {
        Scene scene = threeThings();
        SunLight sun;
        sun.direction = {0.3, -0.2, 1};
        scene.lights.set(LightId{1}, {"Sun", sun, true, {}});
        open(scene);
        const auto glyphs = glyphsOf(window_->document().scene(), view().context().projection());
        QCOMPARE(glyphs.size(), std::size_t(1));
        QTest::mouseClick(&view(), Qt::LeftButton, {}, glyphs.front().at.toPoint());
        QCOMPARE(window_->selection().items(), std::vector<Item>{Item::of(LightId{1})});
    }
    void lockedObjectsCannotBePicked() {
        Scene scene = threeThings();
        scene = withLocked(scene, kBall, true);
        open(scene);
        QTest::mouseClick(&view(), Qt::LeftButton, {}, pixelOf({0, 0, 1}));
        QVERIFY(window_->selection().isEmpty());
    }
    void silhouetteIsThatOfEveryPixelsRay() {
        for (const auto& selected : {std::vector<ObjectId>{ObjectId{1}},
                                     {ObjectId{3}},
                                     {ObjectId{1}, ObjectId{2}, ObjectId{3}}}) {
            Scene scene = threeThings();
            scene.film = {.width = 203, .height = 150};
            AssetCache assets;
            SilhouetteRequest request{
                compile(scene, {}, assets).value().scene, 203, 150, selected, selected.back(), {}};
            const std::vector<Shown> shown = silhouette(request);
            std::size_t wrong = 0, inside = 0;
            for (int y = 0; y < 150; ++y)
                for (int x = 0; x < 203; ++x) {
                    const auto hit = pick(*request.scene, 203, 150, x + 0.5, y + 0.5);
                    const bool chosen =
                        hit && std::binary_search(selected.begin(), selected.end(), hit->object);
                    const Shown wanted = !chosen                         ? Shown::Other
                                         : hit->object == request.active ? Shown::Active
                                                                         : Shown::Selected;
                    inside += chosen;
                    wrong += shown[static_cast<std::size_t>(y * 203 + x)] != wanted;
                }
            QVERIFY(inside > 100);
            QCOMPARE(wrong, std::size_t(0));
        }
    }
    void outlineRunsAroundTheSelectionOnly() {
        open();
        window_->selection().set({kBall});
        view().repaint();
        QTRY_VERIFY_WITH_TIMEOUT(!view().outline().image(view().context()).isNull(), kPatienceMs);
        const QImage outline = view().outline().image(view().context());
        QCOMPARE(outline.size(), view().size() * view().devicePixelRatioF());
        const auto isDrawn = [&](const QPoint& at) { return qAlpha(outline.pixel(at)) > 0; };
        QVERIFY(!isDrawn(pixelOf({0, 0, 1})));
        // Up from the middle of the ball: inside nothing, then a line of a few pixels, then
        // nothing.
        const int x = outline.width() / 2;
        int lines = 0, thick = 0;
        for (int y = outline.height() / 2; y > 0; --y) {
            if (isDrawn({x, y})) ++thick;
            if (isDrawn({x, y}) && !isDrawn({x, y + 1})) ++lines;
        }
        QCOMPARE(lines, 1);
        QVERIFY2(thick >= 2 && thick <= 4, qPrintable(QString::number(thick)));
        window_->selection().clear();
        QVERIFY(view().outline().image(view().context()).isNull());
    }

    // ---- Gizmos ----

    void keysLockToAnAxisAndTypedNumbersAreExact() {
        open();
        useTool("tool.move", kBall);
        QTest::mousePress(&view(), Qt::LeftButton, {}, pixelOf({0, 0, 0}));
        QTest::keyClick(&view(), Qt::Key_X);
        moveTo(&view(), pixelOf({0.8, 0.9, 0}), Qt::LeftButton);
        const DVec3 locked = placeOf(*window_, kBall);
        QVERIFY(locked.x > 0.5 && isNear(locked.y, 0) && isNear(locked.z, 0));
        QTest::keyClick(&view(), Qt::Key_Z);
        QTest::keyClicks(&view(), "-2.25");
        QTest::mouseRelease(&view(), Qt::LeftButton, {}, pixelOf({0.8, 0.9, 0}));
        QVERIFY(placeOf(*window_, kBall) == DVec3(0, 0, -2.25));
        QCOMPARE(window_->document().undoStack().count(), 1);
    }
    void ctrlSnapsAndShiftIsFine() {
        open();
        useTool("tool.move", kBall);
        const QPoint from = tipOf(0), to = from + QPoint(67, 0);
        drag(&view(), Qt::LeftButton, from, to);
        const double free = placeOf(*window_, kBall).x;
        window_->actions()["edit.undo"]->trigger();
        drag(&view(), Qt::LeftButton, from, to, Qt::ControlModifier);
        const double snapped = placeOf(*window_, kBall).x;
        QVERIFY(isNear(snapped * 10, std::round(snapped * 10), 1e-9) &&
                std::abs(snapped - free) <= 0.05 + 1e-9);
        window_->actions()["edit.undo"]->trigger();
        drag(&view(), Qt::LeftButton, from, to, Qt::ShiftModifier);
        QVERIFY(isNear(placeOf(*window_, kBall).x, free / 10, free / 50));
    }
    void rotationAndScaleGoAboutThePivot() {
        open();
        window_->selection().set({kBall, kRight});
        window_->actions()["tool.rotate"]->trigger();
        ToolOptions options = view().tools();
        const auto turn = [&](Pivot pivot) {
            options.pivot = pivot;
            view().setTools(options);
            const QPoint origin = pixelOf(view().context().gizmoFrame()->origin);
            QTest::mousePress(&view(), Qt::LeftButton, {},
                              origin + QPoint(static_cast<int>(kGizmoLength), 0));
            QTest::keyClicks(&view(), "z180");
            QTest::keyClick(&view(), Qt::Key_Return);
            QTest::mouseRelease(&view(), Qt::LeftButton, {}, origin);
            const auto places = std::pair(placeOf(*window_, kBall), placeOf(*window_, kRight));
            window_->actions()["edit.undo"]->trigger();
            return places;
        };
        const auto near = [](const DVec3& a, const DVec3& b) { return glm::length(a - b) < 1e-9; };
        const auto median = turn(Pivot::Median), active = turn(Pivot::Active),
                   own = turn(Pivot::Individual);
        QVERIFY(near(median.first, {1.4, 0, 0}) && near(median.second, {0, 0, 0.5}));
        QVERIFY(near(active.first, {2.8, 0, 0}) && near(active.second, {1.4, 0, 0.5}));
        QVERIFY(near(own.first, {0, 0, 0}) && near(own.second, {1.4, 0, 0.5}));
    }
    void localAxesFollowTheObject() {
        Scene scene = threeThings();
        Object ball = scene.objects.at(ObjectId{1});
        ball.transform.rotateDegrees = {0, 0, 90};
        scene.objects.set(ObjectId{1}, ball);
        open(scene);
        useTool("tool.move", kBall);
        ToolOptions options = view().tools();
        options.localAxes = true;
        view().setTools(options);
        QTest::mousePress(&view(), Qt::LeftButton, {}, pixelOf({0, 0, 0}));
        QTest::keyClicks(&view(), "x2");
        QTest::keyClick(&view(), Qt::Key_Return);
        QVERIFY(glm::length(placeOf(*window_, kBall) - DVec3(0, 2, 0)) < 1e-9);
    }
    void theNumberIsShownWhileDragging() {
        open();
        useTool("tool.move", kBall);
        QSignalSpy readout(&view(), &RenderView::readoutChanged);
        QTest::mousePress(&view(), Qt::LeftButton, {}, pixelOf({0, 0, 0}));
        QTest::keyClicks(&view(), "y1.5");
        QVERIFY(readout.last().first().toString().contains("1.5"));
        QVERIFY(readout.last().first().toString().contains("Y"));
        QTest::keyClick(&view(), Qt::Key_Escape);
        QVERIFY(window_->document().undoStack().count() == 0);
    }
    void duplicateFollowsThePointerAndIsOneStep() {
        open();
        window_->selection().set({kBall});
        const Scene before = window_->document().scene();
        window_->actions()["edit.duplicate"]->trigger();
        if (view().isGesturing()) QTest::mouseClick(&view(), Qt::LeftButton, {}, QPoint(100, 100));
        QCOMPARE(window_->document().scene().objects.size(), std::size_t(4));
        QCOMPARE(window_->document().undoStack().count(), 1);
        window_->actions()["edit.undo"]->trigger();
        QVERIFY(window_->document().scene() == before);
    }

    // ---- Navigation ----

    void orbitKeepsThePointUnderThePointer() {
        open();
        const QPoint at = pixelOf({1.4, 0, 1.1});
        const auto before = view().context().surfaceAt(at);
        QVERIFY(before);
        drag(&view(), Qt::MiddleButton, at, at + QPoint(70, 30));
        QVERIFY(camera().position.x != 0);
        const QPointF after = *view().context().projection().project(before->position);
        QVERIFY2(QLineF(after, QPointF(at)).length() < 1,
                 qPrintable(QString::number(QLineF(after, QPointF(at)).length())));
    }
    void wheelKeepsThePointUnderThePointer() {
        open();
        const QPoint at = pixelOf({1.4, 0, 1.1});
        const auto before = view().context().surfaceAt(at);
        QWheelEvent wheel(at, view().mapToGlobal(QPointF(at)), {}, {0, 240}, Qt::NoButton, {},
                          Qt::NoScrollPhase, false);
        QApplication::sendEvent(&view(), &wheel);
        QVERIFY(glm::length(camera().position - before->position) < 4.5);
        QVERIFY(
            QLineF(*view().context().projection().project(before->position), QPointF(at)).length() <
            1);
    }
    void keysFrameAndLookAlongTheAxes() {
        open();
        window_->selection().set({kRight});
        QTest::keyClick(window_.get(), Qt::Key_F);
        QVERIFY(glm::length(camera().target - DVec3(1.4, 0, 0.5)) < 0.05);
        QTest::keyClick(window_.get(), Qt::Key_Home);
        QVERIFY(glm::length(camera().target) < 1.5);
        const auto forward = [&] { return glm::normalize(camera().target - camera().position); };
        const std::pair<Qt::Key, DVec3> views[] = {
            {Qt::Key_1, {0, 0, -1}}, {Qt::Key_3, {-1, 0, 0}}, {Qt::Key_7, {0, -1, 0}}};
        for (const auto& [key, direction] : views) {
            QTest::keyClick(window_.get(), key, Qt::KeypadModifier);
            QVERIFY(glm::length(forward() - direction) < 1e-9);
            QTest::keyClick(window_.get(), key, Qt::KeypadModifier | Qt::ControlModifier);
            QVERIFY(glm::length(forward() + direction) < 1e-9);
        }
        QTest::keyClick(window_.get(), Qt::Key_5, Qt::KeypadModifier);
        QCOMPARE(camera().projection, Projection::Orthographic);
        QVERIFY(!window_->document().isModified());
    }
    void altArrowsWalkTheViewHistory() {
        open();
        const Camera start = camera();
        QTest::keyClick(window_.get(), Qt::Key_1, Qt::KeypadModifier);
        drag(&view(), Qt::MiddleButton, {200, 200}, {260, 220});
        const Camera last = camera();
        QTest::keyClick(window_.get(), Qt::Key_Left, Qt::AltModifier);
        QTest::keyClick(window_.get(), Qt::Key_Left, Qt::AltModifier);
        QVERIFY(camera() == start);
        QTest::keyClick(window_.get(), Qt::Key_Right, Qt::AltModifier);
        QTest::keyClick(window_.get(), Qt::Key_Right, Qt::AltModifier);
        QVERIFY(camera() == last);
    }
    void ctrlClickFocusesOnTheSurface() {
        open();
        QTest::mouseClick(&view(), Qt::LeftButton, Qt::ControlModifier, pixelOf({0, 0, 1}));
        QVERIFY(camera().focusDistance);
        QVERIFY2(isNear(*camera().focusDistance, 5, 1e-3),
                 qPrintable(QString::number(*camera().focusDistance)));
        QCOMPARE(window_->document().undoStack().undoText(), QString("Focus"));
    }
    void camerasAreListedAndLookedThrough() {
        Scene scene = threeThings();
        Camera side;
        side.name = "Side";
        side.position = {6, 0, 0};
        side.target = {0, 0, 0};
        scene.cameras.add(side);
        open(scene);
        auto* menu = window_->findChild<QMenu*>("cameras");
        QVERIFY(menu);
        emit menu->aboutToShow();
        QCOMPARE(menu->actions().size(), 2);
        menu->actions().last()->trigger();
        QCOMPARE(window_->document().scene().activeCamera, CameraId{1});
        emit menu->aboutToShow();
        QVERIFY(menu->actions().last()->isChecked());
    }
    void copyWithNothingSelectedTakesThePicture() {
        open();
        QTRY_VERIFY_WITH_TIMEOUT(window_->renderer().frame()->spp > 0, kPatienceMs);
        QApplication::clipboard()->clear();
        QTest::keyClick(window_.get(), Qt::Key_C, Qt::ControlModifier);
        const QImage copied = QApplication::clipboard()->image();
        QCOMPARE(copied.size(), view().size() * view().devicePixelRatioF());
        window_->selection().set({kBall});
        QTest::keyClick(window_.get(), Qt::Key_C, Qt::ControlModifier);
        QVERIFY(QApplication::clipboard()->text().contains("\"Ball\""));
    }
};

}  // namespace glint

QTEST_MAIN(glint::ViewportTest)
#include "viewport_test.moc"
