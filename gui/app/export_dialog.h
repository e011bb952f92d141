// ExportDialog: what to export: file, size, samples. Not modal; the work is an ExportJob's.
#pragma once

#include <QDialog>

#include "gui/app/export_job.h"

class QDialogButtonBox;
class QLineEdit;

namespace glint {

class Document;
class DragNumber;

class ExportDialog : public QDialog {
    Q_OBJECT

  public:
    explicit ExportDialog(const Document& document, QWidget* parent = nullptr);

  signals:
    void requested(const glint::ExportRequest& request);

  private:
    DragNumber* addNumber(const QString& label, const QString& name, int value, double max, const QString& unit);
    void browse();
    void start();

    const Document& document_;
    QLineEdit* path_;
    DragNumber *width_, *height_, *spp_;
};

}  // namespace glint
