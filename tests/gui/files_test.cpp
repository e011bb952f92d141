// What stands on the disk: saving that fails, files that other programs change, drops, and unsaved
// work after a kill. Run with
// --victim FOLDER this program is the editor that gets killed.
#include <sys/resource.h>

#include <QApplication>
#include <QDateTime>
#include <QDialog>
#include <QMimeData>
#include <QProcess>
#include <QPushButton>
#include <QRandomGenerator>
#include <QTemporaryDir>
#include <csignal>
#include <fstream>

#include "gui/app/actions.h"
#include "gui/app/autosave.h"
#include "gui/app/file_controller.h"
#include "gui/app/preferences.h"
#include "gui/app/renderer.h"
#include "gui/app/text.h"
#include "gui/widgets/message_bar.h"
#include "support.h"
#include "tracer/io/image_file.h"
#include "tracer/io/scene_json.h"

namespace glint {

using namespace test;
using std::chrono::milliseconds;

namespace {

constexpr milliseconds kQuick{200};

Scene numbered(const Scene& scene, int number) {
    return renamed(scene, kBall, "Ball " + std::to_string(number));
}

/// The number of the last edit that a scene holds; 0 for none.
int numberIn(const Scene& scene) {
    const std::string name = nameOf(scene, kBall);
    return name.starts_with("Ball ") ? std::stoi(name.substr(5)) : 0;
}

Image evenPicture(float value) {
    Image image{8, 4, {}};
    image.rgb.assign(96, value);
    return image;
}

void dropOn(QWidget* widget, const std::filesystem::path& file) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(pathText(file))});
    const QPoint at(20, 60);
    QDragEnterEvent enter(at, Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(widget, &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent drop(QPointF(at), Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(widget, &drop);
}

void click(MessageBar& bar, const QString& text) {
    for (QPushButton* button : bar.findChildren<QPushButton*>())
        if (button->text() == text && button->isVisible())
            return QTest::mouseClick(button, Qt::LeftButton);
    QFAIL(qPrintable("no button " + text));
}

/// While it lives this process can write no file of more than a few bytes, as on a full disk.
class FullDisk {
  public:
    FullDisk() {
        std::signal(SIGXFSZ, SIG_IGN);
        getrlimit(RLIMIT_FSIZE, &before_);
        rlimit full = before_;
        full.rlim_cur = 16;
        setrlimit(RLIMIT_FSIZE, &full);
    }
    ~FullDisk() { setrlimit(RLIMIT_FSIZE, &before_); }
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;

  private:
    rlimit before_{};
};

void keepCopies(MainWindow& window, const std::filesystem::path& folder, milliseconds delay) {
    window.autosave().setDelay(delay);
    window.autosave().begin(folder);
}

/// Of scenes with unsaved work, in a folder that need not be there yet.
std::ptrdiff_t copiesIn(const std::filesystem::path& recovery) {
    std::error_code none;
    const std::filesystem::directory_iterator files(recovery, none);
    return std::count_if(begin(files), end(files),
                         [](const auto& file) { return file.path().extension() == ".json"; });
}

/// Edits without end, saves now and then, and reports each edit with its time.
int beVictim(const std::filesystem::path& folder) {
    const auto window = openWindow();
    window->files().saveTo(folder / "scene.json");
    keepCopies(*window, folder / "recovery", kQuick);
    QTimer timer;
    int number = 0;
    QObject::connect(&timer, &QTimer::timeout, [&] {
        Document& document = window->document();
        document.edit(numbered(document.committed(), ++number), "Rename");
        constexpr int kEditsASave = 150;
        if (number % kEditsASave == 0) window->files().saveTo(folder / "scene.json");
        std::printf("%d %lld\n", number,
                    static_cast<long long>(QDateTime::currentMSecsSinceEpoch()));
        std::fflush(stdout);
    });
    timer.start(5);
    return QApplication::exec();
}

}  // namespace

class FilesTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    [[nodiscard]] std::filesystem::path file(const char* name) const {
        return toPath(folder_.filePath(name));
    }

    /// A recovery folder with the copy of a window that ended without a word.
    [[nodiscard]] std::filesystem::path abandonedWork(const std::filesystem::path& original) const {
        static int count = 0;
        const auto recovery = file(("recovery" + std::to_string(++count)).c_str());
        const auto window = openWindow();
        if (!original.empty()) window->files().saveTo(original);
        keepCopies(*window, recovery, milliseconds(0));
        window->document().edit(numbered(window->document().committed(), 7), "Rename");
        [&] { QTRY_COMPARE_WITH_TIMEOUT(copiesIn(recovery), 1, kPatienceMs); }();
        return recovery;
    }

  private slots:
    void killedProcessLosesLittleAndNeverTheFile() {
        QRandomGenerator random(20);
        for (int round = 0; round < 4; ++round) {
            const auto folder = file(("victim" + std::to_string(round)).c_str());
            std::filesystem::create_directory(folder);
            QProcess victim;
            victim.start(QCoreApplication::applicationFilePath(), {"--victim", pathText(folder)});
            QByteArray told;
            const auto isUnderWay = [&] {
                told += victim.readAllStandardOutput();
                return told.count('\n') > 20 && copiesIn(folder / "recovery") > 0;
            };
            QTRY_VERIFY_WITH_TIMEOUT(isUnderWay(), kPatienceMs);
            QTest::qWait(200 + static_cast<int>(random.bounded(1400)));
            victim.kill();
            QVERIFY(victim.waitForFinished());
            std::map<int, qint64> times;
            int last = 0;
            for (const QByteArray& line : (told + victim.readAllStandardOutput()).split('\n'))
                if (const auto words = line.split(' '); words.size() == 2)
                    times[last = words[0].toInt()] = words[1].toLongLong();
            QVERIFY(last > 10);

            const auto saved = loadScene(folder / "scene.json");
            QVERIFY2(saved.ok(), qPrintable(pathText(folder / "scene.json")));
            int kept = numberIn(saved.value());
            Document document;
            Autosave autosave(document);
            autosave.begin(folder / "recovery");
            const auto leftovers = autosave.leftovers();
            if (!leftovers.empty()) {
                QCOMPARE(leftovers.size(), std::size_t(1));
                QCOMPARE(leftovers.front().original, folder / "scene.json");
                QVERIFY(autosave.recover(leftovers.front()).ok());
                QVERIFY(document.isModified());
                kept = std::max(kept, numberIn(document.scene()));
            }
            QVERIFY(kept > 0);
            // The editor's own delay is 20 s where this one is kQuick: what comes on top must fit
            // into the other 10.
            constexpr qint64 kWriting = 5000;
            const qint64 lost = kept < last ? times.at(last) - times.at(kept)
                                            : 0;  // The last edit may not have been reported.
            QVERIFY2(lost <= kQuick.count() + kWriting,
                     qPrintable(QString("%1 ms lost").arg(lost)));
        }
        QVERIFY(PreferenceValues{}.autosaveSeconds + 5 <= 30);
    }
    void leftWorkIsOfferedAndRecovered() {
        const auto original = file("original.json");
        const auto recovery = abandonedWork(original);
        const auto window = openWindow();
        window->autosave().begin(recovery);
        window->offerRecovery();
        QVERIFY(window->recoveryBar().isVisible());
        QVERIFY(window->recoveryBar().text().contains("original.json"));
        click(window->recoveryBar(), "Recover");
        QCOMPARE(numberIn(window->document().scene()), 7);
        QCOMPARE(window->document().file(), original);
        QVERIFY(window->windowTitle().contains("*"));
        QCOMPARE(numberIn(loadScene(original).value()), 0);
        // The old copy goes once this window has its own.
        QTRY_VERIFY_WITH_TIMEOUT(window->autosave().leftovers().empty(), kPatienceMs);
        window->actions()["file.save"]->trigger();
        QCOMPARE(numberIn(loadScene(original).value()), 7);
        QTRY_COMPARE_WITH_TIMEOUT(copiesIn(recovery), 0, kPatienceMs);
    }
    void leftWorkCanBeDiscarded() {
        const auto recovery = abandonedWork({});
        const auto window = openWindow();
        window->autosave().begin(recovery);
        window->offerRecovery();
        QVERIFY(window->recoveryBar().text().contains("untitled"));
        click(window->recoveryBar(), "Discard");
        QVERIFY(window->autosave().leftovers().empty());
        QVERIFY(!window->recoveryBar().isVisible());
    }
    void theCopyOfALivingWindowIsNotOffered() {
        const auto recovery = file("living");
        const auto first = openWindow(), second = openWindow();
        keepCopies(*first, recovery, milliseconds(0));
        keepCopies(*second, recovery, milliseconds(0));
        QVERIFY(second->autosave().leftovers().empty());
        first->document().edit(numbered(first->document().committed(), 1), "Rename");
        const auto copies = [&] {
            return std::distance(std::filesystem::directory_iterator(recovery),
                                 std::filesystem::directory_iterator());
        };
        QTRY_COMPARE_WITH_TIMEOUT(copies(), 4, kPatienceMs);  // Two locks, a copy and its origin.
        QVERIFY(second->autosave().leftovers().empty());
        // Undone: nothing to keep.
        first->document().undoStack().undo();
        QTRY_COMPARE_WITH_TIMEOUT(copies(), 2, kPatienceMs);
    }
    void assetsOfACopyStandWhereTheyAre() {
        QVERIFY(saveLinear(file("sky.exr"), evenPicture(1), {}).ok());
        const auto recovery = file("assets");
        {
            const auto window = openWindow();
            QVERIFY(window->files().saveTo(file("assets.json")));
            keepCopies(*window, recovery, milliseconds(0));
            Scene scene = window->document().committed();
            scene.environment.image = "sky.exr";
            window->document().edit(scene, "Environment");
            QTest::qWait(50);
        }
        Document document;
        Autosave autosave(document);
        autosave.begin(recovery);
        QCOMPARE(autosave.leftovers().size(), std::size_t(1));
        const auto copy = loadScene(autosave.leftovers().front().copy);
        QCOMPARE(std::filesystem::path(copy.value().environment.image), file("sky.exr"));
        QVERIFY(autosave.recover(autosave.leftovers().front()).ok());
        QCOMPARE(document.scene().environment.image, std::string("sky.exr"));
    }
    void fullDiskKeepsTheOldFile() {
        const auto window = openWindow();
        QVERIFY(window->files().saveTo(file("full.json")));
        const std::string before = formatScene(loadScene(file("full.json")).value());
        window->document().edit(numbered(window->document().committed(), 1), "Rename");
        {
            const FullDisk full;
            window->actions()["file.save"]->trigger();
        }
        QVERIFY(window->messages().isVisible());
        QVERIFY2(window->messages().text().contains("Not saved"),
                 qPrintable(window->messages().text()));
        QVERIFY(window->document().isModified());
        QCOMPARE(formatScene(loadScene(file("full.json")).value()), before);
        click(window->messages(), "Save elsewhere…");
        QTRY_VERIFY_WITH_TIMEOUT(window->findChild<QDialog*>(), kPatienceMs);
        window->findChild<QDialog*>()->close();
        QVERIFY(window->files().saveTo(file("elsewhere.json")));
        QVERIFY(!window->document().isModified());
        QCOMPARE(numberIn(loadScene(file("elsewhere.json")).value()), 1);
    }
    void lostFolderIsSaid() {
        const auto window = openWindow();
        QVERIFY(!window->files().saveTo(file("nowhere/scene.json")));
        QVERIFY(window->messages().text().contains("nowhere"));
    }
    void changedPictureIsDrawnAgain() {
        QVERIFY(saveLinear(file("env.exr"), evenPicture(0.1F), {}).ok());
        Scene scene = smallScene();
        scene.environment.image = pathText(file("env.exr")).toStdString();
        const auto window = openWindow(scene);
        const auto corner = [&] {
            const SessionFrame* frame = window->renderer().frame();
            return frame && frame->spp > 0 ? frame->pixels.front() & 0xffU : 0U;
        };
        QTRY_VERIFY_WITH_TIMEOUT(corner() > 0 && corner() < 128, kPatienceMs);
        QTest::qWait(300);  // The list of watched files is made in a quiet moment.
        QVERIFY(saveLinear(file("env.exr"), evenPicture(0.9F), {}).ok());
        QTRY_VERIFY_WITH_TIMEOUT(corner() > 200, kPatienceMs);
        QVERIFY(!window->document().isModified());
    }
    void sceneChangedByAnotherProgramCanBeReloaded() {
        const auto window = openWindow();
        QVERIFY(window->files().saveTo(file("watched.json")));
        QTest::qWait(500);
        QVERIFY(!window->messages().isVisible());  // Its own save is no news.
        QVERIFY(saveScene(numbered(window->document().scene(), 5), file("watched.json")).ok());
        QTRY_VERIFY_WITH_TIMEOUT(window->messages().isVisible(), kPatienceMs);
        click(window->messages(), "Reload");
        QTRY_COMPARE_WITH_TIMEOUT(numberIn(window->document().scene()), 5, kPatienceMs);
    }
    void droppedSceneOpens() {
        QVERIFY(saveScene(numbered(smallScene(), 3), file("dropped.json")).ok());
        const auto window = openWindow();
        dropOn(window.get(), file("dropped.json"));
        QTRY_COMPARE_WITH_TIMEOUT(window->document().file(), file("dropped.json"), kPatienceMs);
        QCOMPARE(window->files().recent().first(), pathText(file("dropped.json")));
    }
    void droppedPictureBecomesTheEnvironment() {
        QVERIFY(saveLinear(file("dropped.exr"), evenPicture(1), {}).ok());
        const auto window = openWindow();
        dropOn(window.get(), file("dropped.exr"));
        QTRY_VERIFY_WITH_TIMEOUT(
            window->document().scene().environment.image.ends_with("dropped.exr"), kPatienceMs);
        QCOMPARE(window->document().undoStack().count(), 1);
    }
    void aMissingEnvironmentIsNamedAndCanBeLeftOut() {
        Scene scene = smallScene();
        scene.environment.image = "nowhere/sky.exr";
        const auto window = openWindow(scene);
        QTRY_VERIFY_WITH_TIMEOUT(window->messages().text().contains("nowhere/sky.exr"),
                                 kPatienceMs);
        QPushButton* leave = nullptr;
        for (auto* button : window->messages().findChildren<QPushButton*>())
            if (button->text() == "Leave it out") leave = button;
        QVERIFY(leave);
        QTest::mouseClick(leave, Qt::LeftButton);
        QVERIFY(window->document().scene().environment.image.empty());
        QVERIFY(window->document().undoStack().canUndo());
        QVERIFY(!window->messages().isVisible());
        // Back in the scene it is missed again, even if no picture without it was seen.
        window->document().undoStack().undo();
        QTRY_VERIFY_WITH_TIMEOUT(window->messages().isVisible(), kPatienceMs);
        QVERIFY(window->messages().text().contains("nowhere/sky.exr"));
        // Told once: an edit after the message was closed does not bring it back.
        window->messages().dismiss();
        window->document().edit(numbered(window->document().scene(), 1), "Rename");
        QTest::qWait(300);
        QVERIFY(!window->messages().isVisible());
    }
};

}  // namespace glint

int main(int argc, char** argv) {
    QApplication app(argc, argv);
    if (argc == 3 && std::string_view(argv[1]) == "--victim") return glint::beVictim(argv[2]);
    glint::FilesTest tests;
    return QTest::qExec(&tests, argc, argv);
}

#include "files_test.moc"
