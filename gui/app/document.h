// Document: the scene that a window edits, a value, with its undo stack and file. Every view reads
// scene() and listens to changed(); none keeps scene data of its own. Edits come in as whole new
// values (see tracer/scene/edit.h).
#pragma once

#include <QObject>
#include <QString>
#include <QUndoStack>
#include <filesystem>
#include <optional>

#include "tracer/scene/scene.h"

namespace glint {

/// Edits pushed one after another with the same key become one undo step; an empty key never
/// merges.
using MergeKey = QString;

class Document : public QObject {
    Q_OBJECT

  public:
    explicit Document(QObject* parent = nullptr);
    ~Document() override;

    /// The scene as it is shown: with the preview of a running drag, if there is one.
    [[nodiscard]] const Scene& scene() const { return scene_; }
    /// The scene without a running preview.
    [[nodiscard]] const Scene& committed() const {
        return beforePreview_ ? *beforePreview_ : scene_;
    }
    [[nodiscard]] QUndoStack& undoStack() { return undoStack_; }
    /// What undo would bring back; null if there is nothing to undo. Valid until the next edit.
    [[nodiscard]] const Scene* sceneBefore() const;
    /// Empty while untitled.
    [[nodiscard]] const std::filesystem::path& file() const { return file_; }
    /// The folder that the scene's relative paths start at.
    [[nodiscard]] std::filesystem::path assetFolder() const;
    /// File name to show, "Untitled" if there is none.
    [[nodiscard]] QString title() const;
    [[nodiscard]] bool isModified() const { return !undoStack_.isClean(); }

    enum class Origin { Saved, Recovered };
    /// Replaces everything by a new document and empties the undo stack. A recovered one counts as
    /// modified.
    void replace(Scene scene, const std::filesystem::path& file, Origin origin = Origin::Saved);
    /// While changed() tells of a whole new document: nothing in it is an edit.
    [[nodiscard]] bool isReplacing() const { return replacing_; }
    /// The document now stands in `file` as it is. `scene` differs from scene() at most in relative
    /// paths.
    void setSaved(const std::filesystem::path& file, Scene scene);

    /// One undo step named `text`; nothing happens if `after` equals committed(). Ends a preview.
    void edit(Scene after, const QString& text, const MergeKey& key = {});
    /// Shows `scene` without an undo step until edit(), commitPreview() or cancelPreview().
    void preview(Scene scene);
    void commitPreview(const QString& text);
    void cancelPreview();
    [[nodiscard]] bool isPreviewing() const { return beforePreview_.has_value(); }

    /// Moves the active camera. Not an edit: no undo step, and the file stays unmodified.
    void navigate(const Camera& camera);

  signals:
    /// scene() is a new value; `before` is the one shown until now.
    void changed(const glint::Scene& before);
    /// replace() was called; follows changed().
    void replaced();
    /// title() or isModified() may have changed.
    void titleChanged();

  private:
    friend class SceneCommand;
    void show(Scene scene);

    Scene scene_;
    bool replacing_ = false;
    std::optional<Scene> beforePreview_;
    std::filesystem::path file_;
    QUndoStack undoStack_;
};

/// `scene` with its active camera replaced.
[[nodiscard]] Scene withViewCamera(Scene scene, const Camera& camera);

}  // namespace glint
