// MaterialPanel: the materials of the scene with traced balls: add, assign, rename, duplicate,
// delete, drag onto an object.
#pragma once

#include <QWidget>

#include "tracer/scene/ids.h"

class QListView;
class QToolButton;

namespace glint {

class Document;
class MaterialModel;
class MaterialPreviews;
class PresetPicker;
class Selection;
struct MaterialPreset;

class MaterialPanel : public QWidget {
    Q_OBJECT

  public:
    MaterialPanel(Document& document, const Selection& selection, MaterialPreviews& previews,
                  QWidget* parent = nullptr);

    [[nodiscard]] QListView* list() const { return list_; }
    [[nodiscard]] MaterialId current() const;
    /// Adds the preset under a free name, as one step, and gives it to the selected objects.
    void addPreset(const MaterialPreset& preset);
    void assignCurrent();
    void duplicateCurrent();
    /// Objects that had it are black then.
    void removeCurrent();
    void removeUnused();

  signals:
    void refused(const QString& reason);
    /// The person chose a material in the list.
    void chosen(glint::MaterialId material);

  private:
    void buildList(MaterialPreviews& previews);
    void buildButtons();
    QToolButton* addButton(const QString& icon, const QString& name, const QString& tip);
    void openPresets();
    void openMenu(const QPoint& at);
    void select(MaterialId material);
    void followSelection();
    void updateButtons();

    Document& document_;
    const Selection& selection_;
    MaterialModel* model_;
    QListView* list_;
    PresetPicker* presets_;
    QToolButton* add_ = nullptr;
    QToolButton* assign_ = nullptr;
    QToolButton* duplicate_ = nullptr;
    QToolButton* remove_ = nullptr;
};

}  // namespace glint
