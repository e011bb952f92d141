// SceneCommand: the one undo command. It keeps the scene before and after; both share what the edit
// did not touch.
#pragma once

#include <QUndoCommand>

#include "gui/app/document.h"

namespace glint {

class SceneCommand : public QUndoCommand {
  public:
    SceneCommand(Document& document, Scene before, Scene after, const QString& text,
                 const MergeKey& key);

    void undo() override;
    void redo() override;
    [[nodiscard]] int id() const override;
    bool mergeWith(const QUndoCommand* newer) override;

    [[nodiscard]] const Scene& before() const { return before_; }

  private:
    Document& document_;
    Scene before_, after_;
    MergeKey key_;
};

}  // namespace glint
