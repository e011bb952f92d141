// The colour editor with real events: hex digits, light above 1 and the eyedropper on the picture.
#include <QLineEdit>
#include <QPushButton>

#include "gui/app/renderer.h"
#include "gui/panels/property_panel.h"
#include "gui/widgets/color_button.h"
#include "gui/widgets/color_popup.h"
#include "support.h"

namespace glint {

using namespace test;

class ColorTest : public QObject {
    Q_OBJECT

    std::unique_ptr<MainWindow> window_;
    [[nodiscard]] Color albedo() const {
        return std::get<Diffuse>(window_->document().scene().materials.at(MaterialId{1}).value)
            .color.value;
    }
    ColorPopup& popupOf(const QString& field) {
        auto* button = window_->properties().findChild<ColorButton*>(field);
        QTest::mouseClick(button, Qt::LeftButton);
        return button->popup();
    }
    void typeHex(const QString& text) {
        auto* hex = popupOf("material.color").findChild<QLineEdit*>("hex");
        hex->selectAll();
        QTest::keyClicks(hex, text);
        QTest::keyClick(hex, Qt::Key_Return);
    }
    void clickDropper() {
        QTest::mouseClick(popupOf("material.color").findChild<QPushButton*>("dropper"),
                          Qt::LeftButton);
    }

  private slots:
    void init() {
        Scene scene = smallScene();
        scene.environment.color = Color{0.3, 0.2, 0.1};
        scene.render.spp = 4;
        window_ = openWindow(scene);
        window_->selection().set({kBall});
    }
    void cleanup() { window_.reset(); }

    void hexIsOfTheScreen() {
        typeHex("#ff8000");
        // sRGB's 128 of 255 is 0.2159 of the light (IEC 61966-2-1).
        QVERIFY(std::abs(albedo().r - 1) < 1e-6 && std::abs(albedo().g - 0.21586) < 1e-4 &&
                std::abs(albedo().b) < 1e-6);
        typeHex("00FF00");
        QVERIFY((albedo() == Color{0, 1, 0}));
        typeHex("no colour");
        QVERIFY((albedo() == Color{0, 1, 0}));
    }
    void lightMayBeBrighterThanOne() {
        for (DragNumber* number : popupOf("object.emission").findChildren<DragNumber*>())
            if (number->accessibleName() == "Brightness") type(number, "12");
        QVERIFY(
            (window_->document().scene().objects.at(ObjectId{1}).emission == Color{12, 12, 12}));
    }
    void theEyedropperTakesThePicturesLight() {
        QTRY_VERIFY_WITH_TIMEOUT(window_->renderer().frame() &&
                                     window_->renderer().frame()->state == SessionState::Converged,
                                 kPatienceMs);
        RenderView& view = window_->view();
        const QPoint sky(view.width() / 2, view.height() / 2 - view.height() / 3);
        const Color before = albedo();
        clickDropper();
        QTest::keyClick(&view, Qt::Key_Escape);
        QTest::mouseClick(&view, Qt::LeftButton, {}, sky);
        QVERIFY(window_->selection().isEmpty());  // The click was the picture's own again.
        QVERIFY(albedo() == before);
        window_->selection().set({kBall});
        QTest::qWait(1);  // The form of before goes with the next events.
        clickDropper();
        QTest::mouseClick(&view, Qt::LeftButton, {}, sky);
        const auto isSky = [](const Color& c) {
            return std::abs(c.r - 0.3) < 1e-6 && std::abs(c.g - 0.2) < 1e-6 &&
                   std::abs(c.b - 0.1) < 1e-6;
        };
        QTRY_VERIFY_WITH_TIMEOUT(isSky(albedo()), kPatienceMs);
        QVERIFY(window_->selection().contains(kBall));
    }
};

}  // namespace glint

QTEST_MAIN(glint::ColorTest)
#include "color_test.moc"
