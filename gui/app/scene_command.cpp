#include "gui/app/scene_command.h"

namespace glint {

namespace {

/// `target`, but with the cameras of `current` wherever the step between `from` and `target` leaves
/// them alone: undo must not throw the person's view back to where it was at the time of the edit.
Scene keepingView(Scene target, const Scene& from, const Scene& current) {
    if (target.camera == from.camera) target.camera = current.camera;
    for (const CameraId id : target.cameras.ids()) {
        const Camera* old = from.cameras.find(id);
        const Camera* now = current.cameras.find(id);
        const Camera& aimed = target.cameras.at(id);
        if (old && now && *old == aimed && *now != aimed) target.cameras.set(id, Camera(*now));
    }
    return target;
}

}  // namespace

SceneCommand::SceneCommand(Document& document, Scene before, Scene after, const QString& text,
                           const MergeKey& key)
    : QUndoCommand(text),
      document_(document),
      before_(std::move(before)),
      after_(std::move(after)),
      key_(key) {}

void SceneCommand::undo() {
    document_.beforePreview_.reset();
    document_.show(keepingView(before_, after_, document_.scene()));
}

void SceneCommand::redo() {
    document_.beforePreview_.reset();
    document_.show(keepingView(after_, before_, document_.scene()));
}

int SceneCommand::id() const { return key_.isEmpty() ? -1 : 1; }

bool SceneCommand::mergeWith(const QUndoCommand* newer) {
    const auto* next = dynamic_cast<const SceneCommand*>(newer);
    if (!next || next->key_ != key_) return false;
    after_ = next->after_;
    setObsolete(before_ == after_);
    return true;
}

}  // namespace glint
