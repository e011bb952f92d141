// The property panel: every field of every type is set through its widget and read from the
// document.
#include "gui/panels/property_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QToolButton>
#include <QVBoxLayout>

#include "gui/app/selection.h"
#include "gui/app/text.h"
#include "gui/panels/form_builder.h"
#include "gui/panels/render_panel.h"
#include "gui/widgets/color_button.h"
#include "gui/widgets/color_popup.h"
#include "support.h"
#include "tracer/io/scene_check.h"

namespace glint {

using namespace test;

namespace {

/// A number within the field's range that differs from `current`.
double otherNumber(double current, const FieldMeta& meta) {
    for (const double candidate : {0.625, 0.375, 2.0, 7.0, 1.0})
        if (candidate != current && candidate >= meta.min && candidate <= meta.max)
            return candidate;
    return current;
}

/// Drives the editors of one struct, found by their paths, and checks each against the document.
class FieldDriver {
  public:
    FieldDriver(Document& document, QWidget& panel) : document_(document), panel_(panel) {}

    int driven() const { return driven_; }
    /// Fields that did not do what was asked.
    const QStringList& faults() const { return faults_; }

    template <class T>
    void drive(const QString& path, const Lens<T>& lens) {
        std::apply(
            [&](const auto&... field) {
                (driveField(path + '.' + toQString(field.name), memberOf(lens, field.member),
                            field.meta),
                 ...);
            },
            T::fields());
    }

  private:
    template <class W>
    W* find(const QString& path) {
        W* widget = panel_.findChild<W*>(path);
        if (!widget) faults_ << "no editor " + path;
        return widget;
    }
    template <class T>
    T value(const Lens<T>& lens) {
        return *lens.get(document_.scene(), target);
    }
    /// One step that undoes and redoes, whatever it changed.
    template <class T, class Set>
    void check(const QString& path, const Lens<T>& lens, const T& wanted, Set&& set) {
        const Scene before = document_.scene();
        set();
        const Scene after = document_.scene();
        if (!(value(lens) == wanted)) faults_ << path + " did not take the value";
        if (Scene expected = before; lens.set(expected, target, wanted), !(after == expected))
            faults_ << path + " changed something else";
        document_.undoStack().undo();
        if (!(document_.scene() == before)) faults_ << path + " does not undo";
        document_.undoStack().redo();
        if (!(document_.scene() == after)) faults_ << path + " does not redo";
        document_.undoStack().undo();
        ++driven_;
    }
    static QString exact(double v) {
        return QString::number(v, 'g', QLocale::FloatingPointShortest);
    }

    void driveField(const QString& path, const Lens<double>& lens, const FieldMeta& meta) {
        const double wanted = otherNumber(value(lens), meta);
        check(path, lens, wanted, [&] { type(find<DragNumber>(path), exact(wanted)); });
    }
    void driveField(const QString& path, const Lens<int>& lens, const FieldMeta&) {
        const int wanted = value(lens) + 3;
        check(path, lens, wanted, [&] { type(find<DragNumber>(path), QString::number(wanted)); });
    }
    void driveField(const QString& path, const Lens<bool>& lens, const FieldMeta&) {
        check(path, lens, !value(lens), [&] {
            QTest::mouseClick(find<QCheckBox>(path), Qt::LeftButton, {}, {6, 8});
        });
    }
    void driveField(const QString& path, const Lens<std::string>& lens, const FieldMeta&) {
        check(path, lens, std::string("Other"), [&] {
            auto* line = find<QLineEdit>(path);
            line->selectAll();
            QTest::keyClicks(line, "Other");
            QTest::keyClick(line, Qt::Key_Return);
        });
    }
    template <class Vector>
    void driveVector(const QString& path, const Lens<Vector>& lens, const FieldMeta& meta,
                     std::size_t count) {
        for (std::size_t i = 0; i < count; ++i)
            driveField(path + QStringLiteral(".%1").arg(i), componentOf(lens, i), meta);
    }
    void driveField(const QString& path, const Lens<DVec2>& lens, const FieldMeta& meta) {
        driveVector(path, lens, meta, 2);
    }
    void driveField(const QString& path, const Lens<DVec3>& lens, const FieldMeta& meta) {
        driveVector(path, lens, meta, 3);
    }
    void driveField(const QString& path, const Lens<Color>& lens, const FieldMeta&) {
        double Color::*const channels[] = {&Color::r, &Color::g, &Color::b};
        for (int i = 0; i < 3; ++i) {
            Color wanted = value(lens);
            wanted.*channels[i] = 0.125;
            check(path, lens, wanted, [&] {
                type(find<ColorButton>(path)->popup().findChild<DragNumber*>(
                         QStringLiteral("channel%1").arg(i)),
                     "0.125");
            });
        }
    }
    template <class Enum>
    requires std::is_enum_v<Enum>
    void driveField(const QString& path, const Lens<Enum>& lens, const FieldMeta&) {
        const auto wanted = static_cast<Enum>((static_cast<std::size_t>(value(lens)) + 1) %
                                              enumNames(Enum{}).size());
        if (wanted == value(lens)) return;  // Only one choice so far.
        check(path, lens, wanted, [&] { choose(find<QComboBox>(path), static_cast<int>(wanted)); });
    }
    template <class T>
    void driveField(const QString& path, const Lens<Textured<T>>& lens, const FieldMeta& meta) {
        driveField(path, memberOf(lens, &Textured<T>::value), meta);
    }
    template <class T>
    void driveField(const QString& path, const Lens<std::optional<T>>& lens, const FieldMeta&) {
        const Scene before = document_.scene();
        QTest::mouseClick(find<QCheckBox>(path + ".set"), Qt::LeftButton, {}, {6, 8});
        if (!value(lens)) faults_ << path + " was not switched on";
        QTest::mouseClick(find<QCheckBox>(path + ".set"), Qt::LeftButton, {}, {6, 8});
        if (value(lens)) faults_ << path + " was not switched off";
        document_.undoStack().undo();
        document_.undoStack().undo();
        if (!(document_.scene() == before)) faults_ << path + " does not undo";
        ++driven_;
    }
    void driveField(const QString& path, const Lens<MaterialId>& lens, const FieldMeta&) {
        check(path, lens, MaterialId{}, [&] { choose(find<QComboBox>(path), 0); });
    }
    /// No group and no second material in the small scene: nothing else to choose.
    void driveField(const QString& path, const Lens<GroupId>&, const FieldMeta&) {
        find<QComboBox>(path);
    }
    void driveField(const QString& path, const Lens<MixPart>&, const FieldMeta&) {
        find<QComboBox>(path);
    }
    template <class T>
    requires HasFields<T>
    void driveField(const QString& path, const Lens<T>& lens, const FieldMeta&) {
        drive(path, lens);
    }
    template <class... Ts>
    void driveField(const QString&, const Lens<std::variant<Ts...>>&, const FieldMeta&) {}

    static void choose(QComboBox* combo, int index) {
        combo->setCurrentIndex(index);
        emit combo->activated(index);
    }

    Document& document_;
    QWidget& panel_;
    int driven_ = 0;
    QStringList faults_;

  public:
    std::uint32_t target = 1;
};

}  // namespace

class PropertyPanelTest : public QObject {
    Q_OBJECT

    /// A panel for the selected ball or light, driven through all fields of `drive`.
    template <class Prepare, class Drive>
    void withPanel(Item item, Prepare&& prepare, Drive&& drive) {
        Document document;
        Selection selection(document);
        Scene scene = smallScene();
        prepare(scene);
        document.replace(scene, {});
        PropertyPanel panel(document, selection);
        panel.resize(400, 900);
        panel.show();
        selection.set({item});
        FieldDriver driver(document, panel);
        driver.target = item.id;
        drive(driver, document, panel);
        QVERIFY2(driver.faults().isEmpty(), qPrintable(driver.faults().join('\n')));
    }

  private slots:
    void objectFieldsRoundTrip() {
        withPanel(
            kBall, [](Scene&) {},
            [](FieldDriver& driver, Document&, PropertyPanel&) {
                driver.drive("object", entryOf(&Scene::objects));
                QVERIFY(driver.driven() > 15);
            });
    }
    void everyShapesFieldsRoundTrip() {
        AllShapes::forEach([&]<class Shape>(const Shape& shape) {
            withPanel(
                kBall,
                [&](Scene& scene) {
                    Object object = scene.objects.at(ObjectId{1});
                    object.shape = shape;
                    scene.objects.set(ObjectId{1}, object);
                },
                [](FieldDriver& driver, Document&, PropertyPanel&) {
                    driver.drive("object.shape", alternativeOf<Shape>(memberOf(
                                                     entryOf(&Scene::objects), &Object::shape)));
                });
        });
    }
    void everyMaterialsFieldsRoundTrip() {
        AllMaterials::forEach([&]<class M>(const M& material) {
            withPanel(
                kBall,
                [&](Scene& scene) {
                    scene.materials.set(MaterialId{1}, {"White", material});
                },
                [](FieldDriver& driver, Document&, PropertyPanel&) {
                    driver.drive("material", alternativeOf<M>(memberOf(entryOf(&Scene::materials),
                                                                       &Material::value)));
                });
        });
    }
    void everyLightsFieldsRoundTrip() {
        AllLights::forEach([&]<class L>(const L& light) {
            withPanel(
                Item::of(LightId{1}),
                [&](Scene& scene) {
                    scene.lights.set(LightId{1}, {"Key", light, true, {}});
                },
                [](FieldDriver& driver, Document&, PropertyPanel&) {
                    driver.drive("light", alternativeOf<L>(
                                              memberOf(entryOf(&Scene::lights), &Light::value)));
                });
        });
    }
    void groupFieldsRoundTrip() {
        withPanel(
            Item::of(GroupId{1}),
            [](Scene& scene) {
                scene.groups.add({"G", {}, {}});
            },
            [](FieldDriver& driver, Document&, PropertyPanel&) {
                driver.drive("group", entryOf(&Scene::groups));
            });
    }
    void cameraFieldsRoundTrip() {
        withPanel(
            Item::of(CameraId{1}),
            [](Scene& scene) {
                Camera camera;
                camera.name = "Side";
                scene.cameras.add(camera);
            },
            [](FieldDriver& driver, Document&, PropertyPanel&) {
                driver.drive("camera", entryOf(&Scene::cameras));
            });
    }
    void settingsRoundTrip() {
        Document document;
        document.replace(smallScene(), {});
        RenderPanel panel(document);
        panel.show();
        FieldDriver driver(document, panel);
        driver.drive("render", partOf(&Scene::render));
        driver.drive("film", partOf(&Scene::film));
        driver.drive("display", partOf(&Scene::display));
        QVERIFY2(driver.faults().isEmpty(), qPrintable(driver.faults().join('\n')));
    }

    void aWrongSetterIsFound() {
        Document document;
        Scene scene = smallScene();
        Object object = scene.objects.at(ObjectId{1});
        object.shape = Cylinder{};
        scene.objects.set(ObjectId{1}, object);
        document.replace(scene, {});
        const Lens<Cylinder> right =
            alternativeOf<Cylinder>(memberOf(entryOf(&Scene::objects), &Object::shape));
        // Sets the height where the radius is meant, and the other way round.
        const Lens<Cylinder> swapped{
            right.get, [right](Scene& to, std::uint32_t target, const Cylinder& value) {
                return right.set(to, target, Cylinder{value.height, value.radius});
            }};
        const auto faultsOf = [&](const Lens<Cylinder>& lens) {
            QWidget panel;
            new QVBoxLayout(&panel);
            FormBuilder form(
                document,
                std::make_shared<const std::vector<std::uint32_t>>(std::vector<std::uint32_t>{1}),
                &panel);
            form.addStruct("Cylinder", "cylinder", lens);
            const auto refreshes = form.takeRefreshes();
            const auto refresh = [&] {
                for (const auto& run : refreshes) run(document.scene());
            };
            const auto connection =
                QObject::connect(&document, &Document::changed, &document, refresh);
            refresh();
            panel.show();
            FieldDriver driver(document, panel);
            driver.drive("cylinder", right);
            QObject::disconnect(connection);
            return driver.faults();
        };
        QVERIFY(faultsOf(right).isEmpty());
        QVERIFY(!faultsOf(swapped).isEmpty());
    }

    void outOfRangeIsRefusedWithAReasonAndKeepsTheValue() {
        withPanel(
            kBall, [](Scene&) {},
            [](FieldDriver&, Document& document, PropertyPanel& panel) {
                auto* radius = panel.findChild<DragNumber*>("object.shape.radius");
                type(radius, "-1");
                QVERIFY(radius->isRefused());
                QVERIFY(radius->toolTip().contains("above 0"));
                QCOMPARE(document.undoStack().count(), 0);
                QTest::keyClick(radius, Qt::Key_Escape);
                QVERIFY(!radius->isRefused());
                QCOMPARE(radius->value(), 1.0);
            });
    }
    void aRuleAcrossFieldsIsRefusedWithItsReason() {
        withPanel(
            kBall, [](Scene&) {},
            [](FieldDriver&, Document& document, PropertyPanel& panel) {
                auto* scale = panel.findChild<DragNumber*>("object.transform.scale.0");
                type(scale, "0");
                QVERIFY(scale->isRefused());
                QVERIFY(sceneProblems(document.scene()).empty());
            });
    }
    void aTakenNameIsRefused() {
        withPanel(
            kBall,
            [](Scene& scene) {
                scene = withObject(scene, Object{"Other", Sphere{}}).scene;
            },
            [](FieldDriver&, Document& document, PropertyPanel& panel) {
                auto* name = panel.findChild<QLineEdit*>("object.name");
                name->selectAll();
                QTest::keyClicks(name, "Other");
                QTest::keyClick(name, Qt::Key_Return);
                QCOMPARE(nameOf(document.scene(), kBall), std::string("Ball"));
                QCOMPARE(name->text(), QString("Ball"));
            });
    }
    void draggingIsOneStepAndEscapeTakesItBack() {
        withPanel(
            kBall, [](Scene&) {},
            [](FieldDriver&, Document& document, PropertyPanel& panel) {
                auto* radius = panel.findChild<DragNumber*>("object.shape.radius");
                const Scene before = document.scene();
                drag(radius, Qt::LeftButton, {10, 5}, {60, 5});
                QCOMPARE(document.undoStack().count(), 1);
                QVERIFY(radius->value() > 1.0);
                document.undoStack().undo();
                QVERIFY(document.scene() == before);

                QTest::mousePress(radius, Qt::LeftButton, {}, {10, 5});
                QMouseEvent move(QEvent::MouseMove, QPointF(80, 5),
                                 radius->mapToGlobal(QPointF(80, 5)), Qt::NoButton, Qt::LeftButton,
                                 {});
                QApplication::sendEvent(radius, &move);
                QVERIFY(!(document.scene() == before));
                QTest::keyClick(radius, Qt::Key_Escape);
                QVERIFY(document.scene() == before);
                QTest::mouseRelease(radius, Qt::LeftButton, {}, {80, 5});
                QCOMPARE(document.undoStack().index(), 0);
            });
    }
    void manyWithDifferentValuesShowADashAndTakeOne() {
        Document document;
        Selection selection(document);
        auto [scene, second] = withObject(smallScene(), Object{"Second", Sphere{2}});
        document.replace(scene, {});
        PropertyPanel panel(document, selection);
        panel.show();
        selection.set({kBall, Item::of(second)});
        auto* radius = panel.findChild<DragNumber*>("object.shape.radius");
        QCOMPARE(radius->text(), QStringLiteral("—"));
        type(radius, "0.5");
        QCOMPARE(std::get<Sphere>(document.scene().objects.at(ObjectId{1}).shape).radius, 0.5);
        QCOMPARE(std::get<Sphere>(document.scene().objects.at(second).shape).radius, 0.5);
        QCOMPARE(document.undoStack().count(), 1);
    }
    void changingTheShapeTypeShowsItsFields() {
        withPanel(
            kBall, [](Scene&) {},
            [](FieldDriver&, Document& document, PropertyPanel& panel) {
                auto* kind = panel.findChild<QComboBox*>("object.shape.type");
                emit kind->activated(1);
                QVERIFY(
                    std::holds_alternative<Box>(document.scene().objects.at(ObjectId{1}).shape));
                QVERIFY(panel.findChild<DragNumber*>("object.shape.size.2"));
            });
    }
    void aMaterialThatBecomesAMixKeepsItsLook() {
        withPanel(
            kBall, [](Scene&) {},
            [](FieldDriver&, Document& document, PropertyPanel& panel) {
                auto* kind = panel.findChild<QComboBox*>("material.type");
                emit kind->activated(static_cast<int>(AllMaterials::kinds.size()) - 1);
                const auto& mix = std::get<Mix>(document.scene().materials.at(MaterialId{1}).value);
                QVERIFY(std::holds_alternative<Diffuse>(
                    document.scene().materials.at(mix.a.material).value));
                QVERIFY(mix.b.clear);
                QVERIFY(sceneProblems(document.scene()).empty());
            });
    }
    void newMaterialIsMadeAndUsed() {
        withPanel(
            kBall, [](Scene&) {},
            [](FieldDriver&, Document& document, PropertyPanel& panel) {
                auto* chooser = panel.findChild<QComboBox*>("object.material");
                emit chooser->activated(chooser->count() - 1);
                QCOMPARE(document.scene().materials.size(), std::size_t(2));
                QCOMPARE(document.scene().objects.at(ObjectId{1}).material, MaterialId{2});
                QCOMPARE(document.undoStack().count(), 1);
            });
    }
    void resetGoesBackToTheDefault() {
        withPanel(
            kBall, [](Scene&) {},
            [](FieldDriver&, Document& document, PropertyPanel& panel) {
                auto* radius = panel.findChild<DragNumber*>("object.shape.radius");
                type(radius, "3");
                auto* reset = radius->parentWidget()->findChild<QToolButton*>("reset");
                QVERIFY(reset->isVisible());
                QTest::mouseClick(reset, Qt::LeftButton);
                QCOMPARE(std::get<Sphere>(document.scene().objects.at(ObjectId{1}).shape).radius,
                         1.0);
                QVERIFY(!reset->isVisible());
            });
    }
};

}  // namespace glint

QTEST_MAIN(glint::PropertyPanelTest)
#include "property_panel_test.moc"
