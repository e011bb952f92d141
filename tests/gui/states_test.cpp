// The window's main states as pictures, checked for what must be seen in them, at several sizes;
// the build also runs this at 200 % scale. GLINT_SCREENSHOTS=FOLDER keeps the pictures.
#include <QAbstractButton>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QMenuBar>
#include <set>

#include "gui/app/actions.h"
#include "gui/app/export_dialog.h"
#include "gui/app/renderer.h"
#include "gui/app/text.h"
#include "gui/panels/property_panel.h"
#include "gui/viewport/overlay.h"
#include "gui/viewport/selection_outline.h"
#include "gui/widgets/message_bar.h"
#include "gui/widgets/status_line.h"
#include "support.h"

namespace glint {

using namespace test;

namespace {

Scene litBall() {
    Scene scene = smallScene();
    scene.environment.color = Color{0.3, 0.3, 0.3};
    scene.render.spp = 4;
    return scene;
}

/// Pixels of a widget's picture that are near a colour.
int countNear(const QImage& image, const QColor& color) {
    constexpr int kTolerance = 12;
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const QColor pixel = image.pixelColor(x, y);
            count += std::abs(pixel.red() - color.red()) <= kTolerance &&
                     std::abs(pixel.green() - color.green()) <= kTolerance &&
                     std::abs(pixel.blue() - color.blue()) <= kTolerance;
        }
    return count;
}

int shadesIn(const QImage& image) {
    std::set<QRgb> shades;
    for (int y = 0; y < image.height(); y += 3)
        for (int x = 0; x < image.width(); x += 3) shades.insert(image.pixel(x, y));
    return static_cast<int>(shades.size());
}

QImage pictureOf(QWidget& widget, const QString& name) {
    const QImage image = widget.grab().toImage();
    if (const QString folder = qEnvironmentVariable("GLINT_SCREENSHOTS"); !folder.isEmpty())
        image.save(folder + '/' + name + ".png");
    return image;
}

/// Texts that do not fit into their widgets.
QStringList cutTexts(const QWidget& root) {
    QStringList out;
    for (const QWidget* widget : root.findChildren<QWidget*>()) {
        if (!widget->isVisible() || widget->visibleRegion().isEmpty()) continue;
        const auto* label = qobject_cast<const QLabel*>(widget);
        const auto* button = qobject_cast<const QAbstractButton*>(widget);
        QString text = label ? label->text() : button ? button->text() : QString();
        if (text.isEmpty() || (label && label->wordWrap())) continue;
        const QSize needed = widget->minimumSizeHint();
        if (widget->width() + 1 < needed.width() || widget->height() + 1 < needed.height())
            out << QStringLiteral("%1 \"%2\": %3 of %4")
                       .arg(widget->metaObject()->className(), text)
                       .arg(widget->width())
                       .arg(needed.width());
    }
    return out;
}

}  // namespace

class StatesTest : public QObject {
    Q_OBJECT

    std::unique_ptr<MainWindow> window_;
    RenderView& view() { return window_->view(); }
    QImage viewPicture(const QString& name) {
        view().repaint();
        return pictureOf(view(), name);
    }
    void waitForPicture() {
        QTRY_VERIFY_WITH_TIMEOUT(window_->renderer().frame() &&
                                     window_->renderer().frame()->state == SessionState::Converged,
                                 kPatienceMs);
    }

    /// What is cut in the property panel while each entry of the list is chosen in turn.
    QString cutInFormsOf(const QString& list) {
        QStringList out;
        const int count = find<QComboBox>(list)->count();
        for (int i = 0; i < count; ++i) {
            auto* kinds = find<QComboBox>(list);
            kinds->setCurrentIndex(i);
            emit kinds->activated(i);
            QTest::qWait(30);
            out << cutTexts(window_->properties());
        }
        return out.join('\n');
    }
    template <class W>
    W* find(const QString& name) {
        W* found = nullptr;
        for (W* candidate : window_->properties().findChildren<W*>(name))
            if (!found || candidate->isVisible()) found = candidate;
        return found;
    }

  private slots:
    void init() { window_ = openWindow(litBall()); }
    void cleanup() { window_.reset(); }

    void thePictureFillsTheMiddle() {
        waitForPicture();
        QVERIFY(shadesIn(viewPicture("picture")) > 20);
        QVERIFY(window_->status().text().contains("spp"));
    }
    void theSelectionStandsOut() {
        waitForPicture();
        const OverlayColors colors;
        QCOMPARE(countNear(viewPicture("nothing_selected"), colors.active), 0);
        window_->selection().set({kBall});
        view().repaint();
        QTRY_VERIFY_WITH_TIMEOUT(!view().outline().image(view().context()).isNull(), kPatienceMs);
        QVERIFY(countNear(viewPicture("selected"), colors.active) > 200);
    }
    void toolsShowTheirHandles() {
        window_->selection().set({kBall});
        const OverlayColors colors;
        for (const char* tool : {"tool.move", "tool.rotate", "tool.scale"}) {
            window_->actions()[tool]->trigger();
            const QImage picture = viewPicture(tool);
            for (int axis = 0; axis < 2; ++axis)
                QVERIFY2(countNear(picture, colors.axes[axis]) > 60, tool);
        }
    }
    void aClampedPictureSaysThatItIsBiased() {
        waitForPicture();
        QVERIFY(!window_->status().text().contains("biased"));
        window_->findChild<QDockWidget*>("render")->raise();
        QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<DragNumber*>("render.clamp"), kPatienceMs);
        auto* clamp = window_->findChild<DragNumber*>("render.clamp");
        type(clamp, "10");
        QTRY_VERIFY_WITH_TIMEOUT(window_->status().text().contains("biased"), kPatienceMs);
        type(clamp, "0");
        QTRY_VERIFY_WITH_TIMEOUT(!window_->status().text().contains("biased"), kPatienceMs);
    }
    void pauseSaysSo() {
        waitForPicture();
        const QImage running = viewPicture("converged");
        window_->actions()["render.pause"]->trigger();
        const QImage paused = viewPicture("paused");
        // A dark plate with text at the top.
        const QRect plate(paused.width() / 2 - 40, 0, 80, 60);
        QVERIFY(running.copy(plate) != paused.copy(plate));
        QVERIFY(countNear(paused.copy(plate), QColor(235, 235, 235)) > 10);
    }
    void anEmptySceneSaysWhatToDo() {
        window_->document().replace({}, {});
        QTest::qWait(100);
        const QImage picture = viewPicture("empty");
        QVERIFY(countNear(picture.copy(0, 0, picture.width(), 80), QColor(235, 235, 235)) > 50);
    }
    void aRefusedNumberIsRed() {
        window_->selection().set({kBall});
        auto* radius = window_->properties().findChild<DragNumber*>("object.shape.radius");
        QVERIFY(radius);
        const QImage good = pictureOf(*radius, "number");
        type(radius, "-1");
        QVERIFY(radius->isRefused());
        const QImage refused = pictureOf(*radius, "number_refused");
        int redder = 0;
        for (int y = 0; y < good.height(); ++y)
            for (int x = 0; x < good.width(); ++x)
                redder += refused.pixelColor(x, y).red() > refused.pixelColor(x, y).green() + 40;
        QVERIFY(redder > 20);
    }
    void messagesStandAboveThePicture() {
        window_->messages().show(MessageBar::Level::Error, "Not saved: the disk is full", {},
                                 {{"Save elsewhere…", [] {}}});
        QTest::qWait(50);
        QVERIFY(window_->messages().geometry().bottom() < view().geometry().bottom());
        QVERIFY(shadesIn(pictureOf(window_->messages(), "message")) > 5);
        QVERIFY2(cutTexts(window_->messages()).isEmpty(),
                 qPrintable(cutTexts(window_->messages()).join('\n')));
    }
    void nothingIsCut_data() {
        QTest::addColumn<QSize>("size");
        QTest::newRow("usual") << QSize(1440, 900);
        QTest::newRow("small") << QSize(1024, 640);
    }
    void nothingIsCut() {
        QFETCH(QSize, size);
        window_->resize(size);
        window_->selection().set({kBall});
        for (QDockWidget* dock : window_->findChildren<QDockWidget*>()) {
            if (!dock->isVisibleTo(window_.get())) continue;
            dock->raise();
            QTest::qWait(30);
            const QStringList cut = cutTexts(*dock);
            QVERIFY2(cut.isEmpty(), qPrintable(dock->windowTitle() + ": " + cut.join('\n')));
        }
        QString cut = cutInFormsOf("object.shape.type");
        cut += cutInFormsOf("material.type");
        window_->selection().set({Item::of(LightId{1})});
        cut += cutInFormsOf("light.type");
        window_->selection().set({Item::of(CameraId{0})});
        cut += cutTexts(window_->properties()).join('\n');
        QVERIFY2(cut.isEmpty(), qPrintable(cut));
        pictureOf(*window_, QStringLiteral("window_%1").arg(size.width()));
    }
    void theExportDialogIsWhole() {
        window_->actions()["file.export"]->trigger();
        auto* dialog = window_->findChild<ExportDialog*>();
        QVERIFY(dialog);
        QTest::qWait(50);
        pictureOf(*dialog, "export");
        QVERIFY2(cutTexts(*dialog).isEmpty(), qPrintable(cutTexts(*dialog).join('\n')));
    }
};

}  // namespace glint

QTEST_MAIN(glint::StatesTest)
#include "states_test.moc"
