// ExportDialog: what to export: file and format, size, when to stop, layers, region, turntable. Not
// modal; the work is an ExportJob's.
#pragma once

#include <QDialog>
#include <functional>
#include <vector>

#include "gui/app/export_job.h"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QHBoxLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QToolButton;

namespace glint {

class Document;
class DragNumber;
struct NumberRange;

class ExportDialog : public QDialog {
    Q_OBJECT

  public:
    explicit ExportDialog(const Document& document, QWidget* parent = nullptr);

    /// What the fields ask for.
    [[nodiscard]] ExportRequest request() const;

  signals:
    void requested(const glint::ExportRequest& request);

  private:
    void buildFile(QFormLayout* form);
    void buildSize(QFormLayout* form);
    void buildStop(QFormLayout* form);
    void buildContent(QFormLayout* form);
    void buildRegion(QFormLayout* form);
    void buildTurntable(QFormLayout* form);
    DragNumber* makeNumber(const QString& name, const QString& label, double value,
                           const NumberRange& range, const QString& unit);
    /// A row of fields that a check box in front of them switches on.
    QCheckBox* addSwitched(QFormLayout* form, const QString& name, const QString& label,
                           const std::vector<QWidget*>& fields);

    void browse();
    void takeFormat();
    void takePreset(int index);
    void takeSide(DragNumber* changed, DragNumber* other, double ratio);
    void start();
    /// Fields that the format or other fields rule out are switched off; what is wrong is said.
    void refresh();
    [[nodiscard]] QString problem(const ExportRequest& request) const;

    const Document& document_;
    QLineEdit* path_ = nullptr;
    QComboBox *format_ = nullptr, *preset_ = nullptr, *bits_ = nullptr, *axis_ = nullptr;
    QToolButton* lock_ = nullptr;
    DragNumber *width_ = nullptr, *height_ = nullptr, *percent_ = nullptr;
    DragNumber *spp_ = nullptr, *time_ = nullptr, *error_ = nullptr;
    DragNumber *x_ = nullptr, *y_ = nullptr, *regionWidth_ = nullptr, *regionHeight_ = nullptr;
    DragNumber *frames_ = nullptr, *degrees_ = nullptr;
    QCheckBox *transparent_ = nullptr, *layers_ = nullptr, *region_ = nullptr,
              *turntable_ = nullptr;
    QLabel* hint_ = nullptr;
    QPushButton* start_ = nullptr;
    double aspect_ = 1;  ///< width / height that the lock keeps
};

}  // namespace glint
