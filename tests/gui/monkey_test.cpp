// A person who presses everything: random clicks, drags, keys and commands on whatever is visible.
// It must not crash, and the document stays sound. 5 000 actions under AddressSanitizer and with
// GLINT_FULL=1, else 250.
#include <QAbstractButton>
#include <QApplication>
#include <QDesktopServices>
#include <QDialog>
#include <QDir>
#include <QElapsedTimer>
#include <QFileDialog>
#include <QInputMethodEvent>
#include <QMenu>
#include <QPointer>
#include <QTemporaryDir>
#include <QWheelEvent>
#include <random>

#include "gui/app/actions.h"
#include "gui/app/export_queue.h"
#include "gui/app/file_controller.h"
#include "gui/app/text.h"
#include "support.h"
#include "tracer/io/scene_check.h"
#include "tracer/io/scene_json.h"

namespace glint {

using namespace test;

namespace {

class Monkey {
  public:
    Monkey(MainWindow& window, unsigned seed) : window_(window), random_(seed) {
        // A menu of a button and a drag out of the list are event loops of their own, which end
        // only by what comes while they run.
        QObject::connect(&rescue_, &QTimer::timeout, &rescue_, [this] {
            constexpr int kStuckMs = 300;
            if (!acting_ || since_.elapsed() < kStuckMs) return;
            if (QWidget* popup = QApplication::activePopupWidget())
                popup->close();
            else
                QTest::keyClick(&window_, Qt::Key_Escape);
        });
        rescue_.start(100);
    }

    void act() {
        acting_ = true;
        since_.start();
        switch (below(10)) {
            case 0:
            case 1:
            case 2:
                press();
                break;
            case 3:
                dragSomewhere();
                break;
            case 4:
                turnWheel();
                break;
            case 5:
            case 6:
                pressKey();
                break;
            case 7:
                typeText();
                break;
            default:
                command();
                break;
        }
        QCoreApplication::processEvents();
        // File dialogs can delete: they go at once.
        for (QWidget* widget : QApplication::topLevelWidgets())
            if (auto* dialog = qobject_cast<QFileDialog*>(widget)) dialog->reject();
        if (below(3) == 0) closeOthers();
        acting_ = false;
    }
    [[nodiscard]] const QString& last() const { return last_; }

  private:
    int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
    template <class T>
    T& pick(std::vector<T>& from) {
        return from[static_cast<std::size_t>(below(static_cast<int>(from.size())))];
    }

    /// What input would go to: a popup, a dialog that bars the rest, or any window.
    QWidget* root() {
        if (QWidget* popup = QApplication::activePopupWidget()) return popup;
        if (QWidget* modal = QApplication::activeModalWidget()) return modal;
        std::vector<QWidget*> windows;
        for (QWidget* widget : QApplication::topLevelWidgets())
            if (widget->isVisible()) windows.push_back(widget);
        return windows.empty() || below(4) ? &window_ : pick(windows);
    }
    QWidget* target() {
        QWidget* from = root();
        std::vector<QWidget*> candidates{from};
        for (QWidget* child : from->findChildren<QWidget*>())
            if (child->isVisible() && child->isEnabled() && !child->visibleRegion().isEmpty())
                candidates.push_back(child);
        QWidget* out = pick(candidates);
        last_ +=
            QStringLiteral(" %1 \"%2\"").arg(out->metaObject()->className(), out->objectName());
        return out;
    }
    QPoint somewhere(const QWidget* widget) {
        return {below(std::max(1, widget->width())), below(std::max(1, widget->height()))};
    }
    Qt::KeyboardModifiers modifiers() {
        const Qt::KeyboardModifier all[] = {Qt::NoModifier, Qt::NoModifier, Qt::ShiftModifier,
                                            Qt::ControlModifier, Qt::AltModifier};
        return all[below(5)];
    }
    Qt::MouseButton button() {
        const Qt::MouseButton all[] = {Qt::LeftButton, Qt::LeftButton, Qt::LeftButton,
                                       Qt::RightButton, Qt::MiddleButton};
        return all[below(5)];
    }

    void press() {
        last_ = "click";
        QWidget* widget = target();
        if (below(8))
            QTest::mouseClick(widget, button(), modifiers(), somewhere(widget));
        else
            QTest::mouseDClick(widget, Qt::LeftButton, {}, somewhere(widget));
    }
    void dragSomewhere() {
        last_ = "drag";
        QPointer<QWidget> widget = target();
        const QPoint from = somewhere(widget), to = somewhere(widget);
        const Qt::MouseButton with = button();
        const auto held = modifiers();
        QTest::mousePress(widget, with, held, from);
        for (int i = 1; i <= 4 && widget; ++i) {
            const QPoint at = from + (to - from) * i / 4;
            QMouseEvent move(QEvent::MouseMove, at, widget->mapToGlobal(at), Qt::NoButton, with,
                             held);
            QApplication::sendEvent(widget, &move);
            if (below(6) == 0) pressKey();
        }
        if (widget) QTest::mouseRelease(widget, with, held, to);
    }
    void turnWheel() {
        last_ = "wheel";
        QWidget* widget = target();
        const QPointF at = somewhere(widget);
        QWheelEvent wheel(at, widget->mapToGlobal(at), {}, {0, below(2) ? 120 : -120}, Qt::NoButton,
                          modifiers(), Qt::NoScrollPhase, false);
        QApplication::sendEvent(widget, &wheel);
    }
    void pressKey() {
        static const Qt::Key keys[] = {
            Qt::Key_Escape, Qt::Key_Return,   Qt::Key_Tab,    Qt::Key_Up,    Qt::Key_Down,
            Qt::Key_Left,   Qt::Key_Right,    Qt::Key_Delete, Qt::Key_Space, Qt::Key_F2,
            Qt::Key_F3,     Qt::Key_Home,     Qt::Key_W,      Qt::Key_E,     Qt::Key_R,
            Qt::Key_Q,      Qt::Key_X,        Qt::Key_Y,      Qt::Key_Z,     Qt::Key_1,
            Qt::Key_5,      Qt::Key_A,        Qt::Key_G,      Qt::Key_H,     Qt::Key_D,
            Qt::Key_Period, Qt::Key_Backspace};
        QWidget* focus = QApplication::focusWidget();
        const Qt::Key key = keys[below(static_cast<int>(std::size(keys)))];
        last_ += QStringLiteral(" key %1").arg(QKeySequence(key).toString());
        QTest::keyClick(focus ? focus : &window_, key, modifiers());
    }
    void typeText() {
        static const char* texts[] = {"1.5",      "-2",      "ball", "2*3", "",
                                      "99999999", "#ff8800", "",     "0"};
        last_ = "type";
        QWidget* focus = QApplication::focusWidget();
        const char* text = texts[below(static_cast<int>(std::size(texts)))];
        if (*text) return QTest::keyClicks(focus ? focus : &window_, QString::fromLatin1(text));
        // As an input method gives what has no key.
        QInputMethodEvent typed;
        typed.setCommitString(QStringLiteral("äß中"));
        if (focus) QApplication::sendEvent(focus, &typed);
    }
    void command() {
        const auto& all = window_.actions().all();
        QAction* action = all[static_cast<std::size_t>(below(static_cast<int>(all.size())))];
        last_ = action->objectName();
        if (action->isEnabled()) action->trigger();
    }
    void closeOthers() {
        while (QWidget* popup = QApplication::activePopupWidget()) popup->close();
        for (QWidget* widget : QApplication::topLevelWidgets())
            if (auto* dialog = qobject_cast<QDialog*>(widget); dialog && dialog->isVisible())
                dialog->reject();
        QCoreApplication::processEvents();
    }

    MainWindow& window_;
    std::mt19937 random_;
    QTimer rescue_;
    QElapsedTimer since_;
    bool acting_ = false;
    QString last_;
};

}  // namespace

class MonkeyTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

  public slots:
    /// Takes the place of the desktop's own programs.
    void openNothing(const QUrl&) {}

  private slots:
    void nothingBreaks() {
        const int actions = isLongRun() ? 5000 : 250;
        constexpr unsigned kSeed = 11;
        QDir::setCurrent(folder_.path());
        for (const char* scheme : {"file", "http", "https"})
            QDesktopServices::setUrlHandler(scheme, this, "openNothing");
        const auto window = openWindow();
        window->resize(900, 600);
        window->actions()["file.quit"]->setEnabled(false);
        Monkey monkey(*window, kSeed);
        for (int i = 0; i < actions; ++i) {
            monkey.act();
            // Demos are opened from the start page, and must not be saved as what becomes of them.
            if (Document& document = window->document();
                document.file().string().starts_with(GLINT_SOURCE_DIR))
                document.replace(Scene(document.scene()), toPath(folder_.filePath("demo.json")));
            if (i % 20 == 0) window->exports().cancelAll();
            if (!window->isVisible()) window->show();
            const Scene& scene = window->document().committed();
            const auto where =
                QStringLiteral("seed %1, action %2: %3").arg(kSeed).arg(i).arg(monkey.last());
            QVERIFY2(sceneProblems(scene).empty(), qPrintable(where));
            for (const Item item : window->selection().items())
                QVERIFY2(exists(window->document().scene(), item), qPrintable(where));
            if (i % 50 == 0) {
                const auto again = parseScene(formatScene(scene), "scene");
                QVERIFY2(
                    again.ok(),
                    qPrintable(where + ": " +
                               QString::fromStdString(again.ok() ? "" : again.error().text())));
            }
            constexpr std::size_t kMost = 300;
            if (scene.objects.size() > kMost) window->document().replace(smallScene(), {});
            if ((i + 1) % 250 == 0) {
                std::printf("%d actions\n", i + 1);
                std::fflush(stdout);
            }
        }
        while (window->document().undoStack().canUndo()) window->document().undoStack().undo();
        for (const char* scheme : {"file", "http", "https"})
            QDesktopServices::unsetUrlHandler(scheme);
    }
};

}  // namespace glint

QTEST_MAIN(glint::MonkeyTest)
#include "monkey_test.moc"
