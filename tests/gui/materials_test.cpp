// The material panel, its previews and presets, with real events.
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QListView>
#include <QToolButton>
#include <cmath>
#include <fstream>

#include "gui/app/material_edits.h"
#include "gui/app/material_presets.h"
#include "gui/app/material_previews.h"
#include "gui/app/preview_scenes.h"
#include "gui/panels/material_panel.h"
#include "gui/panels/property_panel.h"
#include "gui/widgets/preview_ball.h"
#include "support.h"

namespace glint {

using namespace test;

namespace {

const MaterialPreset& presetNamed(const QString& name) {
    for (const MaterialPreset& preset : materialPresets())
        if (preset.name == name) return preset;
    qFatal("no such preset");
}

void sendDrop(RenderView& view, QEvent::Type type, const QPoint& at, const QMimeData* mime) {
    if (type == QEvent::Drop) {
        QDropEvent event(at, Qt::CopyAction | Qt::MoveAction, mime, Qt::LeftButton, {});
        QApplication::sendEvent(&view, &event);
    } else {
        QDragEnterEvent event(at, Qt::CopyAction | Qt::MoveAction, mime, Qt::LeftButton, {});
        QApplication::sendEvent(&view, &event);
    }
}

/// CIE 1931 colour matching functions, fits by C. Wyman, P.-P. Sloan, P. Shirley, JCGT 2 (2), 2013,
/// equation 4. Nanometres.
double lobe(double l, double peak, double below, double above) {
    const double t = (l - peak) * (l < peak ? below : above);
    return std::exp(-0.5 * t * t);
}
DVec3 matching(double l) {
    return {0.362 * lobe(l, 442, .0624, .0374) + 1.056 * lobe(l, 599.8, .0264, .0323) -
                0.065 * lobe(l, 501.1, .0490, .0382),
            0.821 * lobe(l, 568.8, .0213, .0247) + 0.286 * lobe(l, 530.9, .0613, .0322),
            1.217 * lobe(l, 437, .0845, .0278) + 0.681 * lobe(l, 459, .0385, .0725)};
}
/// CIE standard illuminant D65, 380 to 780 nm in steps of 10.
constexpr double kD65[] = {49.9755, 54.6482, 82.7549, 91.4860, 93.4318, 86.6823, 104.865,
                           117.008, 117.812, 114.861, 115.923, 108.811, 109.354, 107.802,
                           104.790, 107.689, 104.405, 104.046, 100.000, 96.3342, 95.7880,
                           88.6856, 90.0062, 89.5991, 87.6987, 83.2886, 83.6992, 80.0268,
                           80.2146, 82.2778, 78.2842, 69.7213, 71.6091, 74.3490, 61.6040,
                           69.8856, 75.0870, 63.5927, 46.4182, 66.8054, 63.3828};

/// Linear Rec.709 of a reflectance under D65, relative to a perfect white.
template <class Reflectance>
DVec3 rec709(Reflectance&& reflectance) {
    DVec3 xyz(0.0);
    for (int i = 0; i < 41; ++i)
        xyz += matching(380 + 10 * i) * (kD65[i] * reflectance(380 + 10 * i));
    return {3.2404542 * xyz.x - 1.5371385 * xyz.y - 0.4985314 * xyz.z,
            -0.9692660 * xyz.x + 1.8760108 * xyz.y + 0.0415560 * xyz.z,
            0.0556434 * xyz.x - 0.2040259 * xyz.y + 1.0572252 * xyz.z};
}

QJsonObject readObject(const char* file) {
    QFile in(QStringLiteral(GLINT_SOURCE_DIR "/resources/materials/") + file);
    if (!in.open(QIODevice::ReadOnly)) qFatal("cannot read %s", file);
    return QJsonDocument::fromJson(in.readAll()).object();
}

/// Reflectance at normal incidence, ((n-1)^2 + k^2) / ((n+1)^2 + k^2), of the table at a wavelength
/// in nanometres.
double reflectanceAt(const QJsonObject& metal, double nanometres) {
    const QJsonArray l = metal["wavelength_um"].toArray(), n = metal["n"].toArray(),
                     k = metal["k"].toArray();
    int i = 1;
    while (i + 1 < l.size() && l[i].toDouble() * 1000 < nanometres) ++i;
    const double t =
        (nanometres / 1000 - l[i - 1].toDouble()) / (l[i].toDouble() - l[i - 1].toDouble());
    const double nn = n[i - 1].toDouble() + t * (n[i].toDouble() - n[i - 1].toDouble());
    const double kk = k[i - 1].toDouble() + t * (k[i].toDouble() - k[i - 1].toDouble());
    return ((nn - 1) * (nn - 1) + kk * kk) / ((nn + 1) * (nn + 1) + kk * kk);
}

/// Shares of diffuse light that a layer sends back and lets through: Kubelka and Munk, with K = 2
/// sigma_a and S = 3/4 sigma_s' - 1/4 sigma_a (Star, Marijnissen, van Gemert, Phys. Med. Biol. 33,
/// 1988). Coefficients in 1/mm, thickness in mm.
struct TwoFlux {
    double back, through;
};
TwoFlux layerInDiffuseLight(double scattering, double absorption, double thickness) {
    const double s = 0.75 * scattering - 0.25 * absorption, a = 1 + 2 * absorption / s,
                 b = std::sqrt(a * a - 1);
    const double sine = std::sinh(b * s * thickness), cosine = std::cosh(b * s * thickness);
    return {sine / (a * sine + b * cosine), b / (a * sine + b * cosine)};
}

}  // namespace

class MaterialsTest : public QObject {
    Q_OBJECT

  private slots:
    void everyPresetIsSoundAndNamesItsSource() {
        QVERIFY(materialPresets().size() >= 30);
        for (const MaterialPreset& preset : materialPresets()) {
            QVERIFY2(preset.scene.materials.find(preset.material), qPrintable(preset.name));
            QVERIFY2(preset.source.size() > 20, qPrintable(preset.name));
            QVERIFY2(!preset.source.contains("by eye"), qPrintable(preset.name));
        }
    }
    void layersSendBackAndLetThroughWhatTheTwoFluxEquationsGive() {
        int checked = 0;
        for (const QJsonValue& value : readObject("presets.json")["presets"].toArray()) {
            const QJsonObject preset = value.toObject(), layer = preset["layer"].toObject(),
                              material = preset["material"].toObject();
            if (layer.isEmpty()) continue;
            for (int i = 0; i < 3; ++i) {
                const double scattering = layer["scattering"].toArray()[i].toDouble(),
                             absorption = layer["absorption"].toArray()[i].toDouble();
                const TwoFlux flux =
                    layerInDiffuseLight(scattering, absorption, layer["thickness"].toDouble());
                QVERIFY2(
                    std::abs(material["reflectance"].toArray()[i].toDouble() - flux.back) < 6e-4,
                    qPrintable(preset["name"].toString()));
                QVERIFY2(std::abs(material["transmittance"].toArray()[i].toDouble() -
                                  flux.through) < 6e-4,
                         qPrintable(preset["name"].toString()));
            }
            ++checked;
        }
        QCOMPARE(checked, 5);
    }
    void metalColoursAreWhatTheMeasuredConstantsGive() {
        const QJsonObject metals = readObject("metals.json");
        const DVec3 white = rec709([](double) { return 1.0; });
        int checked = 0;
        for (const QJsonValue& value : readObject("presets.json")["presets"].toArray()) {
            const QJsonObject preset = value.toObject();
            if (!preset.contains("metal")) continue;
            const QJsonObject metal = metals[preset["metal"].toString()].toObject();
            const DVec3 color = rec709([&](double l) { return reflectanceAt(metal, l); }) / white;
            const QJsonArray given = preset["material"].toObject()["color"].toArray();
            for (int i = 0; i < 3; ++i) {
                // Out of gamut is clipped: gold's red is a little above 1.
                const double expected = std::clamp(color[i], 0.0, 1.0);
                QVERIFY2(std::abs(given[i].toDouble() - expected) < 6e-4,
                         qPrintable(preset["name"].toString()));
            }
            ++checked;
        }
        QVERIFY(checked >= 9);
    }
    void previewComesInTheBackgroundAndFollowsAnEdit() {
        const auto window = openWindow();
        MaterialPreviews& previews = window->materialPreviews();
        QTRY_VERIFY_WITH_TIMEOUT(!previews.of(MaterialId{1}).isNull(), kPatienceMs);
        const QColor white =
            previews.of(MaterialId{1})
                .pixelColor(MaterialPreviews::kSide / 2, MaterialPreviews::kSide / 2);
        Scene scene = window->document().scene();
        scene.materials.set(MaterialId{1}, {"White", Diffuse{{Color{0.9, 0.02, 0.02}}}});
        window->document().edit(scene, "red");
        const auto isRed = [&] {
            const QColor c =
                previews.of(MaterialId{1})
                    .pixelColor(MaterialPreviews::kSide / 2, MaterialPreviews::kSide / 2);
            return c.red() > 2 * c.green() && c != white;
        };
        QTRY_VERIFY_WITH_TIMEOUT(isRed(), kPatienceMs);
    }
    void equalMaterialsShareAPictureWhateverTheirName() {
        Scene scene = smallScene();
        const MaterialId other = scene.materials.add({"Another name", Diffuse{}});
        QCOMPARE(previewKey(materialPreview(scene, MaterialId{1}, {64, 64})),
                 previewKey(materialPreview(scene, other, {64, 64})));
        scene.materials.set(other, {"Another name", Diffuse{{Color{0.1, 0.1, 0.1}}}});
        QVERIFY(previewKey(materialPreview(scene, MaterialId{1}, {64, 64})) !=
                previewKey(materialPreview(scene, other, {64, 64})));
    }
    void presetIsAddedAndGivenToTheSelectionInOneStep() {
        const auto window = openWindow();
        window->selection().set({kBall});
        const Scene before = window->document().scene();
        window->materials().addPreset(presetNamed("Gold"));
        const Object& ball = window->document().scene().objects.at(ObjectId{1});
        QCOMPARE(window->document().scene().materials.at(ball.material).name, std::string("Gold"));
        window->document().undoStack().undo();
        QVERIFY(window->document().scene() == before);
    }
    void draggedMaterialShowsWhileItHoversAndFallsOntoTheObject() {
        Scene scene = smallScene();
        const MaterialId red = scene.materials.add({"Red", Diffuse{{Color{0.9, 0.02, 0.02}}}});
        const auto window = openWindow(scene);
        RenderView& view = window->view();
        const QPoint middle = view.rect().center();
        QTRY_VERIFY_WITH_TIMEOUT(view.context().itemAt(middle).has_value(), kPatienceMs);
        const Scene before = window->document().scene();
        const std::unique_ptr<QMimeData> mime(materialMime(red));
        sendDrop(view, QEvent::DragEnter, middle, mime.get());
        QVERIFY(window->document().isPreviewing());
        QCOMPARE(window->document().scene().objects.at(ObjectId{1}).material, red);
        QDragLeaveEvent leave;
        QApplication::sendEvent(&view, &leave);
        QVERIFY(window->document().scene() == before);
        sendDrop(view, QEvent::DragEnter, middle, mime.get());
        sendDrop(view, QEvent::Drop, middle, mime.get());
        QCOMPARE(window->document().committed().objects.at(ObjectId{1}).material, red);
        QCOMPARE(window->document().undoStack().count(), 1);
    }
    void buttonsAssignDuplicateAndDelete() {
        Scene scene = smallScene();
        const MaterialId red = scene.materials.add({"Red", Diffuse{}});
        const auto window = openWindow(scene);
        MaterialPanel& panel = window->materials();
        window->selection().set({kBall});
        panel.list()->setCurrentIndex(panel.list()->model()->index(1, 0));
        QCOMPARE(panel.current(), red);
        QTest::mouseClick(panel.findChild<QToolButton*>("materials.assign"), Qt::LeftButton);
        QCOMPARE(window->document().scene().objects.at(ObjectId{1}).material, red);
        QTest::mouseClick(panel.findChild<QToolButton*>("materials.duplicate"), Qt::LeftButton);
        QCOMPARE(window->document().scene().materials.size(), 3u);
        panel.removeUnused();
        QCOMPARE(window->document().scene().materials.ids(), std::vector<MaterialId>{red});
        panel.list()->setCurrentIndex(panel.list()->model()->index(0, 0));
        QTest::mouseClick(panel.findChild<QToolButton*>("materials.remove"), Qt::LeftButton);
        QVERIFY(!window->document().scene().objects.at(ObjectId{1}).material);
    }
    void renameInPlaceRefusesATakenName() {
        Scene scene = smallScene();
        scene.materials.add({"Red", Diffuse{}});
        const auto window = openWindow(scene);
        QAbstractItemModel* model = window->materials().list()->model();
        QVERIFY(!model->setData(model->index(1, 0), "White", Qt::EditRole));
        QVERIFY(model->setData(model->index(1, 0), "Blue", Qt::EditRole));
        QCOMPARE(window->document().scene().materials.at(MaterialId{2}).name, std::string("Blue"));
    }
    void panelShowsTheMaterialWithItsBallWhileNothingIsSelected() {
        const auto window = openWindow();
        window->selection().clear();
        emit window->materials().chosen(MaterialId{1});
        QVERIFY(window->properties().findChild<PreviewBall*>());
        QVERIFY(window->properties().findChild<QWidget*>("material.color"));
    }
};

}  // namespace glint

QTEST_MAIN(glint::MaterialsTest)
#include "materials_test.moc"
