#include "gui/widgets/section.h"

#include <QFormLayout>
#include <QToolButton>
#include <QVBoxLayout>

namespace glint {

Section::Section(const QString& title, QWidget* parent) : QWidget(parent) {
    header_ = new QToolButton(this);
    header_->setText(title);
    header_->setObjectName("sectionHeader");
    header_->setCheckable(true);
    header_->setChecked(true);
    header_->setArrowType(Qt::DownArrow);
    header_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    header_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);

    body_ = new QWidget(this);
    form_ = new QFormLayout(body_);
    form_->setContentsMargins(12, 2, 4, 6);
    form_->setHorizontalSpacing(8);
    form_->setVerticalSpacing(4);
    form_->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    form_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(header_);
    layout->addWidget(body_);
    connect(header_, &QToolButton::toggled, this, [this](bool open) {
        body_->setVisible(open);
        header_->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
    });
}

void Section::addRow(QWidget* label, QWidget* editor) { form_->addRow(label, editor); }
void Section::addWide(QWidget* editor) { form_->addRow(editor); }
void Section::addHead(QWidget* widget) { form_->insertRow(0, widget); }
QString Section::title() const { return header_->text(); }

}  // namespace glint
