#include "gui/app/export_dialog.h"

#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>

#include "gui/app/document.h"
#include "gui/app/text.h"
#include "gui/widgets/drag_number.h"
#include "tracer/io/image_file.h"

namespace glint {

ExportDialog::ExportDialog(const Document& document, QWidget* parent) : QDialog(parent), document_(document) {
    setWindowTitle(tr("Export picture"));
    setAttribute(Qt::WA_DeleteOnClose);
    auto* form = new QFormLayout(this);
    path_ = new QLineEdit(this);
    path_->setObjectName("export.path");
    path_->setMinimumWidth(fontMetrics().averageCharWidth() * 40);
    const auto stem = document.file().empty() ? std::filesystem::path("picture") : document.file().stem().stem();
    path_->setText(pathText(document.assetFolder() / (stem.string() + ".png")));
    QStringList endings;
    for (const std::string& ending : writableEndings()) endings << toQString(ending);
    path_->setToolTip(tr("The ending chooses the format: %1").arg(endings.join(' ')));
    auto* browseButton = new QPushButton(tr("Browse…"), this);
    connect(browseButton, &QPushButton::clicked, this, &ExportDialog::browse);
    auto* row = new QHBoxLayout;
    row->addWidget(path_, 1);
    row->addWidget(browseButton);
    form->addRow(tr("File"), row);

    const Scene& scene = document.scene();
    width_ = addNumber(tr("Width"), "export.width", scene.film.width, 65536, "px");
    height_ = addNumber(tr("Height"), "export.height", scene.film.height, 65536, "px");
    spp_ = addNumber(tr("Samples a pixel"), "export.spp", scene.render.spp, 16777216, {});

    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    QPushButton* exportButton = buttons->addButton(tr("Export"), QDialogButtonBox::AcceptRole);
    exportButton->setObjectName("export.start");
    exportButton->setDefault(true);
    connect(buttons, &QDialogButtonBox::accepted, this, &ExportDialog::start);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    form->addRow(buttons);
}

DragNumber* ExportDialog::addNumber(const QString& label, const QString& name, int value, double max, const QString& unit) {
    auto* number = new DragNumber(this);
    number->setObjectName(name);
    number->setRange({.min = 1, .max = max, .integer = true});
    number->setUnit(unit);
    number->setValue(value);
    connect(number, &DragNumber::edited, number, &DragNumber::setValue);
    connect(number, &DragNumber::previewed, number, &DragNumber::setValue);
    static_cast<QFormLayout*>(layout())->addRow(label, number);
    return number;
}

void ExportDialog::browse() {
    auto* dialog = new QFileDialog(this, tr("Export picture"), path_->text());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    QStringList patterns;
    for (const std::string& ending : writableEndings()) patterns << "*" + toQString(ending);
    dialog->setNameFilter(tr("Pictures (%1)").arg(patterns.join(' ')));
    connect(dialog, &QFileDialog::fileSelected, path_, &QLineEdit::setText);
    dialog->open();
}

void ExportDialog::start() {
    ExportRequest request{document_.committed(), document_.assetFolder(), toPath(path_->text())};
    request.scene.film.width = static_cast<int>(width_->value().value_or(1));
    request.scene.film.height = static_cast<int>(height_->value().value_or(1));
    request.scene.render.spp = static_cast<int>(spp_->value().value_or(1));
    emit requested(request);
    accept();
}

}  // namespace glint
