#include "gui/app/document.h"

#include "gui/app/scene_command.h"
#include "gui/app/text.h"

namespace glint {

Scene withViewCamera(Scene scene, const Camera& camera) {
    if (scene.activeCamera) {
        Camera named = camera;
        named.name = scene.cameras.at(scene.activeCamera).name;
        scene.cameras.set(scene.activeCamera, std::move(named));
    } else {
        scene.camera = camera;
    }
    return scene;
}

Document::Document(QObject* parent) : QObject(parent) {
    connect(&undoStack_, &QUndoStack::cleanChanged, this, &Document::titleChanged);
}

// The stack tells of its emptying, but who listens may be gone already.
Document::~Document() { undoStack_.blockSignals(true); }

std::filesystem::path Document::assetFolder() const {
    return file_.empty() ? std::filesystem::current_path()
                         : std::filesystem::absolute(file_).parent_path();
}

const Scene* Document::sceneBefore() const {
    if (!undoStack_.canUndo()) return nullptr;
    const auto* last =
        dynamic_cast<const SceneCommand*>(undoStack_.command(undoStack_.index() - 1));
    return last ? &last->before() : nullptr;
}

QString Document::title() const {
    return file_.empty() ? tr("Untitled") : pathText(file_.filename());
}

void Document::replace(Scene scene, const std::filesystem::path& file, Origin origin) {
    beforePreview_.reset();
    file_ = file;
    undoStack_.clear();
    if (origin == Origin::Recovered) undoStack_.resetClean();
    replacing_ = true;
    show(std::move(scene));
    replacing_ = false;
    emit replaced();
    emit titleChanged();
}

void Document::setSaved(const std::filesystem::path& file, Scene scene) {
    file_ = file;
    undoStack_.setClean();
    show(std::move(scene));
    emit titleChanged();
}

void Document::edit(Scene after, const QString& text, const MergeKey& key) {
    const bool previewed = isPreviewing();
    Scene before = previewed ? std::move(*beforePreview_) : scene_;
    beforePreview_.reset();
    if (before == after) {
        if (previewed) show(std::move(before));
        return;
    }
    undoStack_.push(new SceneCommand(*this, std::move(before), std::move(after), text, key));
}

void Document::preview(Scene scene) {
    if (!beforePreview_) beforePreview_ = scene_;
    show(std::move(scene));
}

void Document::commitPreview(const QString& text) {
    if (beforePreview_) edit(Scene(scene_), text);
}

void Document::cancelPreview() {
    if (!beforePreview_) return;
    Scene before = std::move(*beforePreview_);
    beforePreview_.reset();
    show(std::move(before));
}

void Document::navigate(const Camera& camera) {
    if (beforePreview_) *beforePreview_ = withViewCamera(std::move(*beforePreview_), camera);
    show(withViewCamera(scene_, camera));
}

void Document::show(Scene scene) {
    const Scene before = std::exchange(scene_, std::move(scene));
    emit changed(before);
}

}  // namespace glint
