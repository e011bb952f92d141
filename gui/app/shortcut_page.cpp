#include "gui/app/shortcut_page.h"

#include <QAction>
#include <QFormLayout>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include "gui/app/actions.h"

namespace glint {

ShortcutPage::ShortcutPage(Actions& actions, QWidget* parent) : QWidget(parent), actions_(actions) {
    auto* table = new QWidget(this);
    auto* form = new QFormLayout(table);
    form->setContentsMargins(16, 12, 16, 12);
    form->setHorizontalSpacing(24);
    form->setVerticalSpacing(4);
    for (QAction* action : actions.all()) {
        const QString name = Actions::plainText(action);
        auto* edit = new QKeySequenceEdit(action->shortcut(), table);
        edit->setObjectName("keys." + action->objectName());
        edit->setAccessibleName(name);
        edit->setToolTip(action->statusTip());
        edit->setClearButtonEnabled(true);
        connect(edit, &QKeySequenceEdit::editingFinished, this,
                [this, action, edit] { change(action, edit); });
        form->addRow(Actions::groupOf(action) + QStringLiteral(" › ") + name, edit);
    }
    auto* scroll = new QScrollArea(this);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidget(table);
    note_ = new QLabel(tr("Click a field and press the new keys. They count at once."), this);
    note_->setContentsMargins(16, 0, 16, 0);
    auto* reset = new QPushButton(tr("Reset all keys"), this);
    connect(reset, &QPushButton::clicked, this, [this, table] {
        actions_.resetKeys();
        for (QAction* action : actions_.all())
            table->findChild<QKeySequenceEdit*>("keys." + action->objectName())
                ->setKeySequence(action->shortcut());
    });
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 8, 0, 8);
    layout->addWidget(note_);
    layout->addWidget(scroll, 1);
    layout->addWidget(reset, 0, Qt::AlignRight);
}

void ShortcutPage::change(QAction* action, QKeySequenceEdit* edit) {
    const QKeySequence keys = edit->keySequence();
    if (keys == action->shortcut()) return;
    if (const QAction* other = actions_.userOf(keys); other && other != action) {
        note_->setText(
            tr("%1 belongs to \"%2\" already.")
                .arg(keys.toString(QKeySequence::NativeText), Actions::plainText(other)));
        edit->setKeySequence(action->shortcut());
        return;
    }
    actions_.setKeys(action, keys);
}

}  // namespace glint
