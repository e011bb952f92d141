// What the editor's tests share: small scenes, and finding and driving widgets as a person would.
#pragma once

#include <QtTest>

#include "gui/app/document.h"
#include "gui/app/main_window.h"
#include "gui/app/theme.h"
#include "gui/viewport/render_view.h"
#include "gui/widgets/drag_number.h"
#include "tracer/scene/edit.h"

namespace glint::test {

/// Tests that have a long form run it: under AddressSanitizer, and when GLINT_FULL is set.
inline bool isLongRun() {
#ifdef __SANITIZE_ADDRESS__
    return true;
#else
    return qEnvironmentVariableIsSet("GLINT_FULL");
#endif
}

/// How long a test waits for what must come: enough for a machine that does much else besides.
constexpr int kPatienceMs = 120000;

/// A scene with one object, one light and one material, with fixed ids 1.
inline Scene smallScene() {
    Scene scene;
    scene.materials.add({"White", Diffuse{}});
    Object ball;
    ball.name = "Ball";
    ball.shape = Sphere{};
    ball.material = MaterialId{1};
    scene.objects.add(ball);
    scene.lights.add({"Key", PointLight{}, true, {}});
    return scene;
}

inline const Item kBall = Item::of(ObjectId{1});

/// Types a value into a number field and presses Enter.
inline void type(DragNumber* number, const QString& text) {
    QVERIFY(number);
    QTest::mouseClick(number, Qt::LeftButton);
    number->selectAll();
    QTest::keyClicks(number, text);
    QTest::keyClick(number, Qt::Key_Return);
}

/// Presses at `from`, moves in steps to `to`, releases there.
inline void drag(QWidget* widget, Qt::MouseButton button, QPoint from, QPoint to,
                 Qt::KeyboardModifiers modifiers = {}) {
    QTest::mousePress(widget, button, modifiers, from);
    constexpr int kSteps = 5;
    for (int i = 1; i <= kSteps; ++i) {
        const QPointF at = from + (to - from) * i / kSteps;
        QMouseEvent move(QEvent::MouseMove, at, widget->mapToGlobal(at), Qt::NoButton, button,
                         modifiers);
        QApplication::sendEvent(widget, &move);
    }
    QTest::mouseRelease(widget, button, modifiers, to);
}

/// A shown window with the small scene, looking straight at the ball.
inline std::unique_ptr<MainWindow> openWindow(Scene scene = smallScene()) {
    applyTheme(Theme::Dark);
    auto window = std::make_unique<MainWindow>(Memory::None);
    window->resize(1200, 800);
    scene.camera.position = {0, 0, 6};
    scene.camera.target = {0, 0, 0};
    window->document().replace(std::move(scene), {});
    window->show();
    return window;
}

}  // namespace glint::test
