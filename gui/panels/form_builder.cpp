#include "gui/panels/form_builder.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QToolTip>
#include <QVBoxLayout>

#include "gui/widgets/drag_number.h"
#include "gui/widgets/icons.h"

namespace glint {

namespace {

/// "Radius. In m, above 0."
QString explanation(const FieldMeta& meta) {
    QString out = meta.doc.empty() ? QString() : explanationOf(meta.doc);
    const NumberRange range{meta.min, meta.max, meta.exclusiveMin, false};
    if (!meta.unit.empty())
        out += "\n" + QCoreApplication::translate("FormBuilder", "Unit: %1")
                          .arg(shownUnit(toQString(meta.unit)));
    if (std::isfinite(meta.min) || std::isfinite(meta.max))
        out += "\n" + QCoreApplication::translate("FormBuilder", "Takes %1").arg(range.text());
    return out;
}

}  // namespace

FormBuilder::FormBuilder(Document& document, Targets targets, QWidget* parent)
    : document_(document), targets_(std::move(targets)), parent_(parent) {
    layout_ =
        parent->layout() ? static_cast<QVBoxLayout*>(parent->layout()) : new QVBoxLayout(parent);
    layout_->setContentsMargins(0, 0, 0, 0);
    layout_->setSpacing(1);
}

Section* FormBuilder::addSection(const QString& title) {
    auto* section = new Section(title, parent_);
    layout_->addWidget(section);
    return section;
}

FieldEditor FormBuilder::makeSwitch(QWidget* content, const QString& path,
                                    std::function<bool(const Scene&)> isSet,
                                    std::function<QString(bool)> set, QWidget* parent) {
    auto* box = new QWidget(parent);
    auto* row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    auto* check = new QCheckBox(box);
    check->setObjectName(path + ".set");
    check->setToolTip(
        QCoreApplication::translate("FormBuilder", "Set it, or leave it to the default"));
    row->addWidget(check, 0, Qt::AlignTop);
    if (content) row->addWidget(content, 1);
    row->addStretch();
    QObject::connect(check, &QCheckBox::clicked, check, [set, check](bool on) {
        const QString reason = set(on);
        if (reason.isEmpty()) return;
        check->setChecked(!on);
        QToolTip::showText(check->mapToGlobal(QPoint(0, check->height())), reason, check);
    });
    return {box, [check, content, isSet](const Scene& scene) {
                const bool on = isSet(scene);
                check->setChecked(on);
                if (content) content->setVisible(on);
            }};
}

void FormBuilder::placeRow(Section* section, const QString& label, const FieldMeta& meta,
                           FieldEditor editor, const Reset& reset) {
    auto* title = new QLabel(label, section);
    title->setFixedWidth(title->fontMetrics().averageCharWidth() * 22);
    title->setToolTip(explanation(meta));
    editor.widget->setToolTip(explanation(meta));
    if (auto* check = editor.widget->findChild<QCheckBox*>(QString(), Qt::FindDirectChildrenOnly))
        check->setAccessibleName(label);

    auto* box = new QWidget(section);
    auto* row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(2);
    row->addWidget(editor.widget, 1);
    auto* button = new QToolButton(box);
    button->setIcon(icon("reset"));
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::NoFocus);
    button->setToolTip(QCoreApplication::translate("FormBuilder", "Reset to the default"));
    button->setAccessibleName(button->toolTip());
    button->setObjectName("reset");
    QSizePolicy policy = button->sizePolicy();
    policy.setRetainSizeWhenHidden(true);
    button->setSizePolicy(policy);
    button->setVisible(false);
    row->addWidget(button);
    section->addRow(title, box);

    if (reset.run) QObject::connect(button, &QToolButton::clicked, button, reset.run);
    addRefresh([editor, button, reset](const Scene& scene) {
        editor.refresh(scene);
        button->setVisible(reset.differs && reset.differs(scene));
    });
}

}  // namespace glint
