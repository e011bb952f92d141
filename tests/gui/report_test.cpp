// The picture of scenes/report.json made anew from an empty window, with mouse and keyboard alone;
// then saved, opened again and exported. What is typed comes from the file, how it is typed is
// Hand's.
#include <QFileDialog>
#include <QTemporaryDir>
#include <set>

#include "gui/app/export_queue.h"
#include "gui/app/file_controller.h"
#include "gui/app/renderer.h"
#include "gui/panels/environment_picker.h"
#include "hand.h"
#include "tracer/compile/compiler.h"
#include "tracer/io/image_file.h"
#include "tracer/io/scene_json.h"
#include "tracer/render/render.h"

namespace glint {

using namespace test;

namespace {

const std::filesystem::path kReport =
    std::filesystem::path(GLINT_SOURCE_DIR) / "scenes/report.json";

/// Builds what a scene holds, one thing after another.
class Rebuild {
  public:
    Rebuild(MainWindow& window, const Scene& wanted)
        : window_(window), wanted_(wanted), hand_(window) {}

    QStringList run() {
        hand_.key(Qt::Key_N, Qt::ControlModifier);
        window_.view().setFocus();
        hand_.key(Qt::Key_A, Qt::ControlModifier);
        hand_.key(Qt::Key_Delete);
        if (!document().objects.empty() || !document().lights.empty())
            hand_.fault("the window is not empty");
        wanted_.objects.forEach([&](ObjectId, const Object& object) { buildObject(object); });
        wanted_.lights.forEach([&](LightId, const Light& light) { buildLight(light); });
        buildEnvironment();
        buildSettings();
        return hand_.faults();
    }

  private:
    const Scene& document() const { return window_.document().scene(); }
    const Object& object() const {
        return document().objects.at(ObjectId{window_.selection().items().back().id});
    }

    void buildObject(const Object& wanted) {
        hand_.add("add." + toQString(kindOf(wanted.shape)));
        if (window_.selection().items().size() != 1 ||
            window_.selection().items().back().kind != ItemKind::Object)
            return hand_.fault("nothing was added");
        if (kindOf(object().shape) != kindOf(wanted.shape))
            return hand_.fault("added " + toQString(kindOf(object().shape)) + " for " +
                               toQString(wanted.name));
        hand_.write("object.name", toQString(wanted.name));
        std::visit(
            [&]<class S>(const S& shape) {
                hand_.fill("object.shape", shape, std::get<S>(object().shape));
            },
            wanted.shape);
        hand_.fill("object.transform", wanted.transform, Transform(object().transform));
        if (!(wanted.emission == Color{})) hand_.set("object.emission", wanted.emission);
        wanted.material ? useMaterial(wanted.material)
                        : hand_.choose("object.material", "None (black)");
    }

    /// Chooses the material for the selected object; makes it first if it is not there.
    void useMaterial(MaterialId id) {
        const Material& wanted = wanted_.materials.at(id);
        const auto* mix = std::get_if<Mix>(&wanted.value);
        if (mix && mix->b.material)
            useMaterial(mix->b.material);  // Made on the same object, and kept.
        bool isThere = false;
        document().materials.forEach(
            [&](MaterialId, const Material& m) { isThere = isThere || m.name == wanted.name; });
        if (!isThere) {
            hand_.choose("object.material", "New material");
            hand_.write("material.name", toQString(wanted.name));
        } else {
            hand_.choose("object.material", toQString(wanted.name));
        }
        if (made_.contains(wanted.name)) return;
        made_.insert(wanted.name);
        hand_.choose("material.type", labelOf(kindOf(wanted.value)));
        if (mix) return fillMix(*mix);
        if (!object().material)
            return hand_.fault("no material was taken for " + toQString(wanted.name));
        std::visit(
            [&]<class M>(const M& material) {
                const auto* present =
                    std::get_if<M>(&document().materials.at(object().material).value);
                present ? hand_.fill("material", material, M(*present))
                        : hand_.fault("the type was not taken");
            },
            wanted.value);
    }
    void fillMix(const Mix& mix) {
        // The second first: at most one part may be clear, and the new mix has it there.
        hand_.choose("material.b", toQString(wanted_.materials.at(mix.b.material).name));
        hand_.choose("material.a", "Clear");
        hand_.set("material.amount", mix.amount.value);
    }

    void buildLight(const Light& wanted) {
        hand_.add("add.light." + toQString(kindOf(wanted.value)));
        const Item added = window_.selection().items().back();
        if (added.kind != ItemKind::Light) return hand_.fault("no light was added");
        hand_.write("light.name", toQString(wanted.name));
        const LightId id{added.id};
        std::visit(
            [&]<class L>(const L& light) {
                hand_.fill("light", light, L(std::get<L>(document().lights.at(id).value)));
            },
            wanted.value);
    }
    void buildEnvironment() {
        const auto stem = std::filesystem::path(wanted_.environment.image).stem();
        hand_.clickThumbnail(window_.environment().thumbnails(), pathText(stem));
        // The starter's colour tints the picture: off.
        if (document().environment.color) hand_.press("environment.color.set");
        hand_.set("environment.intensity", wanted_.environment.intensity);
    }
    void buildSettings() {
        hand_.clickRow("Camera");
        hand_.fill("camera", wanted_.camera, Camera(document().camera));
        hand_.openTab("Render");
        hand_.fill("film", wanted_.film, FilmSettings(document().film));
        hand_.fill("render", wanted_.render, RenderSettings(document().render));
    }

    MainWindow& window_;
    const Scene& wanted_;
    Hand hand_;
    std::set<std::string> made_;
};

Image pictureOf(Scene scene, const std::filesystem::path& folder, int spp) {
    scene.film.width = 96;
    scene.film.height = 54;
    scene.render.spp = spp;
    AssetCache assets;
    return render(compile(scene, folder, assets).value().scene, {}).beauty;
}

}  // namespace

class ReportTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

  private slots:
    void reportIsRebuiltSavedReloadedAndExported() {
        const Scene report = loadScene(kReport).value();
        const auto window = openWindow();
        window->renderer().setPaused(true);
        const QStringList faults = Rebuild(*window, report).run();
        QVERIFY2(faults.isEmpty(), qPrintable(faults.join('\n')));

        // The same picture, bit for bit.
        constexpr int kSpp = 4;
        const Scene& rebuilt = window->document().scene();
        const Image wanted = pictureOf(report, kReport.parent_path(), kSpp);
        QCOMPARE(pictureOf(rebuilt, window->document().assetFolder(), kSpp).rgb, wanted.rgb);

        // Saved by Ctrl+S and a name.
        const auto file = toPath(folder_.filePath("rebuilt.glint.json"));
        Hand hand(*window);
        hand.key(Qt::Key_S, Qt::ControlModifier);
        auto* save = window->findChild<QFileDialog*>();
        QVERIFY(save);
        auto* name = save->findChild<QLineEdit*>("fileNameEdit");
        QVERIFY(name);
        name->selectAll();
        QTest::keyClicks(name, pathText(file));
        QTest::keyClick(name, Qt::Key_Return);
        QTRY_COMPARE_WITH_TIMEOUT(window->document().file(), file, kPatienceMs);
        QVERIFY(!window->document().isModified());

        // Opened again: equal, but for the ids, which a file does not hold.
        const std::string text = formatScene(window->document().scene());
        window->files().load(file);
        QTRY_VERIFY_WITH_TIMEOUT(!window->document().undoStack().canUndo(), kPatienceMs);
        QCOMPARE(formatScene(window->document().scene()), text);
        QVERIFY(loadScene(file).value() == window->document().scene());

        exportAndCompare(report, hand);
    }

  private:
    void exportAndCompare(const Scene& report, Hand& hand) {
        hand.key(Qt::Key_F12);
        const auto picture = toPath(folder_.filePath("report.exr"));
        hand.set("export.width", 96.0);
        auto* height = hand.find<DragNumber>("export.height");
        QVERIFY2(height, qPrintable(hand.faults().join('\n')));
        QCOMPARE(height->value(), 54.0);  // The ratio is locked.
        hand.set("export.spp", 4.0);
        hand.write("export.path", pathText(picture));  // Enter starts it.
        QVERIFY2(hand.faults().isEmpty(), qPrintable(hand.faults().join('\n')));
        QTRY_VERIFY_WITH_TIMEOUT(std::filesystem::exists(picture), kPatienceMs);
        const auto exported = loadImage(picture);
        QVERIFY(exported.ok());
        QCOMPARE(exported.value()->rgb, pictureOf(report, kReport.parent_path(), 4).rgb);
    }
};

}  // namespace glint

QTEST_MAIN(glint::ReportTest)
#include "report_test.moc"
