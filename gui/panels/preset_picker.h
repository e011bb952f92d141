// PresetPicker: a pop-up with a picture of each material preset, searched by name.
#pragma once

#include <QFrame>

class QLineEdit;
class QListWidget;
class QListWidgetItem;

namespace glint {

class MaterialPreviews;
struct MaterialPreset;

class PresetPicker : public QFrame {
    Q_OBJECT

  public:
    explicit PresetPicker(MaterialPreviews& previews, QWidget* parent = nullptr);

    void openAt(const QPoint& global);

  signals:
    void chosen(const glint::MaterialPreset& preset);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void fill();
    void filter(const QString& text);
    void choose(QListWidgetItem* item);
    void showPicture(const QString& slot);

    MaterialPreviews& previews_;
    QLineEdit* search_;
    QListWidget* list_;
};

}  // namespace glint
