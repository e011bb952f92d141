#include "gui/app/file_controller.h"

#include <QFileDialog>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <QtConcurrent>
#include <memory>
#include <optional>

#include "gui/app/asset_paths.h"
#include "gui/app/document.h"
#include "gui/app/text.h"
#include "gui/widgets/message_bar.h"
#include "tracer/io/scene_json.h"
#include "tracer/scene/edit.h"

namespace glint {

/// A file as far as it could be read.
struct LoadedFile {
    Result<Scene> scene;
    std::optional<PartialScene> part;  ///< of a file with bad entries
};

namespace {

constexpr qsizetype kMostRecent = 12;
const QString kRecentKey = QStringLiteral("recentFiles");

std::shared_ptr<LoadedFile> readFile(const std::filesystem::path& file) {
    auto loaded = std::make_shared<LoadedFile>(LoadedFile{loadScene(file), std::nullopt});
    if (loaded->scene.ok()) return loaded;
    if (auto part = loadSceneInPart(file); part.ok()) loaded->part = std::move(part).value();
    return loaded;
}

QString listOf(const std::vector<Error>& errors) {
    constexpr std::size_t kMost = 20;
    QStringList lines;
    for (std::size_t i = 0; i < std::min(errors.size(), kMost); ++i) lines << toQString(errors[i]);
    if (errors.size() > kMost) lines << QStringLiteral("…");
    return lines.join('\n');
}

}  // namespace

FileReading readInBackground(const std::filesystem::path& file) {
    return {file, QtConcurrent::run([file] { return readFile(file); })};
}

Scene starterScene() {
    Scene scene;
    const MaterialId floor = scene.materials.add({"Floor", Diffuse{{Color{0.5, 0.5, 0.5}}}});
    const MaterialId white = scene.materials.add({"White", Diffuse{}});
    Object ground;
    ground.name = "Floor";
    ground.shape = Plane{};
    ground.material = floor;
    scene.objects.add(ground);
    Object ball;
    ball.name = "Ball";
    ball.shape = Sphere{};
    ball.material = white;
    ball.transform.translate = {0, 1, 0};
    scene.objects.add(ball);
    Object lamp;
    lamp.name = "Lamp";
    lamp.shape = Sphere{0.5};
    lamp.emission = {40, 38, 34};
    lamp.transform.translate = {-3, 4, 3};
    scene.objects.add(lamp);
    scene.environment.color = Color{0.25, 0.27, 0.3};
    return scene;
}

FileController::FileController(Document& document, MessageBar& messages, Memory memory,
                               QWidget* window)
    : QObject(window), document_(document), messages_(messages), memory_(memory), window_(window) {
    settingsWriter_.setMaxThreadCount(1);
    if (memory_ == Memory::Settings) recent_ = QSettings().value(kRecentKey).toStringList();
}

void FileController::remember(const std::filesystem::path& file) {
    const QString path = pathText(std::filesystem::absolute(file));
    recent_.removeAll(path);
    recent_.prepend(path);
    recent_ = recent_.mid(0, kMostRecent);
    // On a thread: written settings wait for the disk.
    if (memory_ == Memory::Settings)
        settingsWriter_.start([recent = recent_] { QSettings().setValue(kRecentKey, recent); });
    emit recentChanged();
}

void FileController::newScene() {
    whenSafe([this] { document_.replace(starterScene(), {}); });
}

void FileController::newFrom(const std::filesystem::path& file) {
    whenSafe([this, file] {
        const auto scene = loadScene(file);
        if (!scene.ok())
            return messages_.show(MessageBar::Level::Error,
                                  tr("Not opened: %1").arg(toQString(scene.error())));
        document_.replace(
            withAssetsFrom(scene.value(), std::filesystem::absolute(file).parent_path(), {}), {});
    });
}

void FileController::browse() {
    auto* dialog = new QFileDialog(window_, tr("Open a scene"), pathText(document_.assetFolder()));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    dialog->setNameFilter(tr("Scenes (*.json)"));
    connect(dialog, &QFileDialog::fileSelected, this,
            [this](const QString& file) { open(toPath(file)); });
    dialog->open();
}

void FileController::open(const std::filesystem::path& file) {
    whenSafe([this, file] { load(file); });
}

void FileController::load(FileReading reading) {
    const int number = ++loads_;
    reading.content.then(this, [this, file = reading.file,
                                number](const std::shared_ptr<LoadedFile>& loaded) {
        if (number != loads_) return;
        if (loaded->scene.ok()) {
            messages_.dismiss();
            document_.replace(std::move(loaded->scene).value(), file);
            remember(file);
            return;
        }
        std::vector<MessageBar::Choice> choices;
        QString details;
        if (loaded->part) {
            details = listOf(loaded->part->leftOut);
            const auto count = static_cast<int>(loaded->part->leftOut.size());
            choices.push_back(
                {tr("Open without %n bad part(s)", nullptr, count), [this, file, loaded] {
                     // Untitled, so that saving cannot destroy the original.
                     Scene kept = withAssetsFrom(loaded->part->scene,
                                                 std::filesystem::absolute(file).parent_path(), {});
                     document_.replace(std::move(kept), {}, Document::Origin::Recovered);
                     messages_.show(MessageBar::Level::Warning,
                                    tr("Opened in part, as an untitled scene. Left out:\n%1")
                                        .arg(listOf(loaded->part->leftOut)));
                 }});
        }
        messages_.show(MessageBar::Level::Error,
                       tr("Not opened: %1").arg(toQString(loaded->scene.error())), details,
                       std::move(choices));
    });
}

bool FileController::saveTo(const std::filesystem::path& file) {
    Scene scene = document_.committed();
    if (file != document_.file())
        scene = withAssetsFrom(std::move(scene), document_.assetFolder(), file);
    const Status status = saveScene(scene, file);
    if (!status.ok()) {
        messages_.show(MessageBar::Level::Error, tr("Not saved: %1").arg(toQString(status.error())),
                       {}, {{tr("Save elsewhere…"), [this] { saveAs(); }}});
        return false;
    }
    document_.setSaved(file, std::move(scene));
    emit saved();
    remember(file);
    return true;
}

void FileController::saveThen(std::function<void()> then) {
    if (document_.file().empty()) return saveAsThen(std::move(then));
    if (saveTo(document_.file()) && then) then();
}

void FileController::saveAsThen(std::function<void()> then) {
    auto* dialog =
        new QFileDialog(window_, tr("Save the scene"), pathText(document_.assetFolder()));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setNameFilter(tr("Scenes (*.json)"));
    dialog->setDefaultSuffix("glint.json");
    dialog->selectFile(document_.file().empty() ? tr("scene.glint.json") : document_.title());
    connect(dialog, &QFileDialog::fileSelected, this,
            [this, then = std::move(then)](const QString& file) {
                if (saveTo(toPath(file)) && then) then();
            });
    dialog->open();
}

void FileController::whenSafe(std::function<void()> then) {
    if (!document_.isModified()) return then();
    auto* box =
        new QMessageBox(QMessageBox::Warning, tr("Unsaved changes"),
                        tr("\"%1\" has changes that are not saved.").arg(document_.title()),
                        QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, window_);
    box->setObjectName("unsavedChanges");
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setDefaultButton(QMessageBox::Save);
    connect(box, &QMessageBox::finished, this, [this, then = std::move(then)](int choice) {
        if (choice == QMessageBox::Save) saveThen(then);
        if (choice == QMessageBox::Discard) then();
    });
    box->open();
}

}  // namespace glint
