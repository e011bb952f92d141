// Exports: the dialog's fields, the queue with pause and cancel, sequences, and that glint-render
// finds the same bits.
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QProcess>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QToolButton>
#include <cmath>

#include "gui/app/actions.h"
#include "gui/app/export_dialog.h"
#include "gui/app/export_queue.h"
#include "gui/app/file_controller.h"
#include "gui/app/renderer.h"
#include "hand.h"
#include "tracer/io/image_file.h"

namespace glint {

using namespace test;

namespace {

using State = ExportQueue::State;

Scene lit() {
    Scene scene = smallScene();
    scene.environment.color = Color{0.5, 0.6, 0.7};
    scene.film = {.width = 64, .height = 48};
    scene.render.spp = 4;
    return scene;
}

}  // namespace

class ExportTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    std::unique_ptr<MainWindow> window_;
    ExportDialog* dialog_ = nullptr;

    [[nodiscard]] std::filesystem::path file(const char* name) const {
        return toPath(folder_.filePath(name));
    }
    ExportQueue& queue() { return window_->exports(); }
    [[nodiscard]] State stateOf(std::size_t index) const {
        return window_->exports().entries().at(index).state;
    }

    template <class W>
    W* field(const char* name) {
        W* found = dialog_->findChild<W*>(QString("export.") + name);
        if (!found) QTest::qFail(name, __FILE__, __LINE__);
        return found;
    }
    void openDialog() {
        window_->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(window_.get()));
        QTest::keyClick(window_.get(), Qt::Key_F12);
        dialog_ = window_->findChild<ExportDialog*>();
        QVERIFY(dialog_);
        QVERIFY(dialog_->isVisible());
        QVERIFY(!dialog_->isModal());
    }
    void write(const char* name, const QString& text) {
        auto* line = field<QLineEdit>(name);
        line->selectAll();
        QTest::keyClicks(line, text);
    }
    void choose(const char* name, int index) {
        auto* combo = field<QComboBox>(name);
        combo->setCurrentIndex(index);
        emit combo->activated(index);
    }
    void press(const char* name) {
        auto* box = field<QCheckBox>(name);
        QTest::mouseClick(box, Qt::LeftButton, {}, {8, box->height() / 2});
    }
    /// A request that does not end by itself.
    ExportRequest endless(const char* name) {
        ExportRequest request{lit(), {}, file(name), {}, {}};
        request.scene.render.spp = 1 << 24;
        return request;
    }
    void waitUntilIdle() { QTRY_VERIFY_WITH_TIMEOUT(queue().isIdle(), kPatienceMs); }

  private slots:
    void init() {
        window_ = openWindow(lit());
        window_->renderer().setPaused(true);
    }
    void cleanup() { window_.reset(); }

    void ratioPercentAndPresetsMakeTheSize() {
        openDialog();
        type(field<DragNumber>("width"), "128");
        QCOMPARE(field<DragNumber>("height")->value(), 96.0);
        type(field<DragNumber>("percent"), "50");
        QCOMPARE(dialog_->request().scene.film.width, 64);
        QCOMPARE(dialog_->request().scene.film.height, 48);
        QTest::mouseClick(field<QToolButton>("lock"), Qt::LeftButton);
        type(field<DragNumber>("width"), "200");
        QCOMPARE(field<DragNumber>("height")->value(), 96.0);
        QTest::mouseClick(field<QToolButton>("lock"), Qt::LeftButton);
        type(field<DragNumber>("height"), "48");
        QCOMPARE(field<DragNumber>("width")->value(), 100.0);
        type(field<DragNumber>("percent"), "100");
        choose("preset", 2);
        QCOMPARE(dialog_->request().scene.film.width, 1920);
        QCOMPARE(dialog_->request().scene.film.height, 1080);
        QVERIFY(field<QLabel>("hint")->text().contains("1920"));
        QCOMPARE(window_->document().scene().film.width, 64);  // The scene keeps its own.
    }
    void theFormatSaysWhatIsPossible() {
        openDialog();
        write("path", folder_.filePath("a.jpg"));
        QVERIFY(!field<QCheckBox>("transparent")->isEnabled());
        QVERIFY(!field<QCheckBox>("layers")->isEnabled());
        QCOMPARE(field<QComboBox>("bits")->count(), 1);
        choose("format", field<QComboBox>("format")->findData(".exr"));
        QVERIFY(field<QLineEdit>("path")->text().endsWith("a.exr"));
        QVERIFY(field<QCheckBox>("layers")->isEnabled());
        QCOMPARE(field<QComboBox>("bits")->count(), 2);
        write("path", folder_.filePath("a.gif"));
        QVERIFY(!field<QPushButton>("start")->isEnabled());
        QVERIFY(field<QLabel>("hint")->text().contains(".png"));
        write("path", folder_.filePath("nowhere/a.png"));
        QVERIFY(!field<QPushButton>("start")->isEnabled());
        write("path", folder_.filePath("a.png"));
        QVERIFY(field<QPushButton>("start")->isEnabled());
        press("region");
        type(field<DragNumber>("region.x"), "60");
        QVERIFY(!field<QPushButton>("start")->isEnabled());
    }
    void everyChoiceReachesTheFileAndVerifies() {
        QVERIFY(window_->files().saveTo(file("scene.json")));
        openDialog();
        write("path", folder_.filePath("part.png"));
        choose("bits", 1);
        type(field<DragNumber>("spp"), "6");
        press("transparent");
        press("region");
        type(field<DragNumber>("region.x"), "10");
        type(field<DragNumber>("region.width"), "30");
        QTest::mouseClick(field<QPushButton>("start"), Qt::LeftButton);
        waitUntilIdle();
        QVERIFY(window_->findChild<QDockWidget*>("exports")->isVisible());
        const auto raw = loadRaw(file("part.png"));
        QVERIFY(raw.ok());
        QCOMPARE(raw.value().channels.size(), std::size_t(4));
        QCOMPARE(raw.value().metadata.at("glint:bits"), std::string("16"));
        QCOMPARE(raw.value().metadata.at("glint:spp"), std::string("6"));
        QCOMPARE(raw.value().metadata.at("glint:crop"), std::string("10,0,30,48"));
        const auto& alpha = raw.value().channels.at("A");
        QCOMPARE(alpha[24 * 64 + 32], 1.0f);
        QCOMPARE(alpha[24 * 64 + 50], 0.0f);
        QProcess verify;
        verify.start(GLINT_RENDER_PATH,
                     {"--verify", pathText(file("part.png")), pathText(file("scene.json"))});
        QVERIFY(verify.waitForFinished(kPatienceMs));
        const QByteArray said = verify.readAllStandardError();
        QVERIFY2(verify.exitCode() == 0 && said.contains("bit for bit"), said);
    }
    void editedSceneWithLayersVerifiesOnceSaved() {
        // Ids with gaps, as editing leaves them: the file has none.
        Document& document = window_->document();
        document.edit(duplicated(document.committed(), {kBall}).scene, "Duplicate");
        document.edit(removed(document.committed(), {kBall}), "Delete");
        QVERIFY(window_->files().saveTo(file("edited.json")));
        queue().add({document.committed(),
                     document.assetFolder(),
                     file("edited.exr"),
                     {.bits = 16, .layers = true},
                     {}});
        waitUntilIdle();
        QProcess verify;
        verify.start(GLINT_RENDER_PATH,
                     {"--verify", pathText(file("edited.exr")), pathText(file("edited.json"))});
        QVERIFY(verify.waitForFinished(kPatienceMs));
        const QByteArray said = verify.readAllStandardError();
        QVERIFY2(verify.exitCode() == 0 && said.contains("with layers"), said);
    }
    void turntableWritesNumberedPicturesFromAllAround() {
        openDialog();
        write("path", folder_.filePath("turn.png"));
        type(field<DragNumber>("spp"), "1");
        press("turntable");
        type(field<DragNumber>("turntable.frames"), "4");
        QVERIFY(field<QLabel>("hint")->text().contains("turn_0001.png"));
        QTest::mouseClick(field<QPushButton>("start"), Qt::LeftButton);
        waitUntilIdle();
        for (const char* name :
             {"turn_0001.png", "turn_0002.png", "turn_0003.png", "turn_0004.png"})
            QVERIFY2(std::filesystem::exists(file(name)), name);
        QVERIFY(!std::filesystem::exists(file("turn.png")));
        QVERIFY(!std::filesystem::exists(file("turn_0005.png")));
    }
    void turntableGoesAroundTheTarget() {
        Camera camera;
        camera.position = {0, 1, 6};
        camera.target = {0, 1, 0};
        const Turntable turntable{4, 1, 360};
        QVERIFY(cameraOf(turntable, camera, 0) == camera);
        QVERIFY(glm::length(cameraOf(turntable, camera, 1).position - DVec3(6, 1, 0)) < 1e-9);
        QVERIFY(glm::length(cameraOf(turntable, camera, 2).position - DVec3(0, 1, -6)) < 1e-9);
        const Camera over = cameraOf({4, 0, 360}, camera, 1);
        QVERIFY(glm::length(over.up - DVec3(0, 0, 1)) < 1e-9);
        QCOMPARE(numbered("a/b.exr", 11).string(), std::string("a/b_0012.exr"));
        QCOMPARE(numbered("b.exr", 12345).string(), std::string("b_12346.exr"));
    }
    void aPausedExportKeepsStillAndLetsTheNextGoOn() {
        queue().add(endless("first.exr"));
        queue().add({lit(), {}, file("second.exr"), {}, {}});
        const int first = queue().entries().front().id;
        QCOMPARE(stateOf(0), State::Running);
        QCOMPARE(stateOf(1), State::Waiting);
        QTRY_VERIFY_WITH_TIMEOUT(queue().entries().front().progress.spp > 0, kPatienceMs);
        auto* dock = window_->findChild<QDockWidget*>("exports");
        dock->show();
        dock->raise();
        QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<QToolButton*>("exports.clear"), kPatienceMs);
        auto* pause =
            window_->findChild<QToolButton*>(QStringLiteral("exports.pause.%1").arg(first));
        QVERIFY(pause);
        QTest::mouseClick(pause, Qt::LeftButton);
        QCOMPARE(stateOf(0), State::Paused);
        QTRY_COMPARE_WITH_TIMEOUT(stateOf(1), State::Done, kPatienceMs);
        QTest::qWait(1200);  // The pass that ran has ended.
        const int samples = queue().entries().front().progress.spp;
        QTest::qWait(300);
        QCOMPARE(queue().entries().front().progress.spp, samples);
        QTest::mouseClick(pause, Qt::LeftButton);
        QCOMPARE(stateOf(0), State::Running);
        QTRY_VERIFY_WITH_TIMEOUT(queue().entries().front().progress.spp > samples, kPatienceMs);
        QVERIFY(queue().entries().front().progress.error < kInfinity);
        QTest::mouseClick(
            window_->findChild<QToolButton*>(QStringLiteral("exports.cancel.%1").arg(first)),
            Qt::LeftButton);
        waitUntilIdle();
        QCOMPARE(stateOf(0), State::Canceled);
        QVERIFY(!std::filesystem::exists(file("first.exr")));
        QVERIFY(std::filesystem::exists(file("second.exr")));
        QTest::mouseClick(window_->findChild<QToolButton*>("exports.clear"), Qt::LeftButton);
        QVERIFY(queue().entries().empty());
    }
    void aWaitingExportCanBeCanceled() {
        queue().add(endless("running.exr"));
        queue().add(endless("waiting.exr"));
        queue().cancel(queue().entries().back().id);
        QCOMPARE(stateOf(1), State::Canceled);
        QCOMPARE(stateOf(0), State::Running);
        queue().cancelAll();
        waitUntilIdle();
        QVERIFY(!std::filesystem::exists(file("waiting.exr")));
    }
    void editingGoesOnWhileExporting() {
        queue().add(endless("background.exr"));
        QTRY_VERIFY_WITH_TIMEOUT(queue().entries().front().progress.spp > 0, kPatienceMs);
        window_->selection().set({kBall});
        window_->actions()["edit.delete"]->trigger();
        QVERIFY(window_->document().scene().objects.empty());
        QCOMPARE(stateOf(0), State::Running);
        window_.reset();  // Ends at once.
    }
};

}  // namespace glint

QTEST_MAIN(glint::ExportTest)
#include "export_test.moc"
