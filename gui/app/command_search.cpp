#include "gui/app/command_search.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "gui/app/actions.h"

namespace glint {

namespace {

constexpr int kNoMatch = 5;

/// All letters of `wanted` stand in `text` in this order.
bool holdsLetters(const QString& text, const QString& wanted) {
    qsizetype at = 0;
    for (const QChar c : wanted) {
        if (c.isSpace()) continue;
        at = text.indexOf(c, at, Qt::CaseInsensitive) + 1;
        if (at == 0) return false;
    }
    return true;
}

/// How well a command answers to the text: its name begins with it, a word of its name does, its
/// name holds it, its explanation does, its name holds the letters; or kNoMatch.
int rankOf(const QAction* action, const QString& text) {
    const QString name = Actions::plainText(action);
    if (name.startsWith(text, Qt::CaseInsensitive)) return 0;
    if (name.contains(' ' + text, Qt::CaseInsensitive)) return 1;
    if (name.contains(text, Qt::CaseInsensitive)) return 2;
    if ((Actions::groupOf(action) + ' ' + action->statusTip()).contains(text, Qt::CaseInsensitive))
        return 3;
    return holdsLetters(name, text) ? 4 : kNoMatch;
}

/// So that the names of commands without one stand under the others.
QIcon emptyIcon(const QSize& size) {
    QPixmap picture(size);
    picture.fill(Qt::transparent);
    return picture;
}

}  // namespace

CommandSearch::CommandSearch(const Actions& actions, QWidget* parent)
    : QFrame(parent, Qt::Popup), actions_(actions) {
    setFrameShape(QFrame::StyledPanel);
    line_ = new QLineEdit(this);
    line_->setPlaceholderText(tr("Find a command"));
    line_->installEventFilter(this);
    list_ = new QListWidget(this);
    list_->setFocusPolicy(Qt::NoFocus);
    const int side = fontMetrics().height() + 2;
    list_->setIconSize({side, side});
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 6, 6, 6);
    layout->addWidget(line_);
    layout->addWidget(list_);
    connect(line_, &QLineEdit::textChanged, this, &CommandSearch::filter);
    connect(line_, &QLineEdit::returnPressed, this, &CommandSearch::run);
    connect(list_, &QListWidget::itemClicked, this, &CommandSearch::run);
}

void CommandSearch::open() {
    resize(fontMetrics().averageCharWidth() * 56, fontMetrics().height() * 20);
    const QWidget* over = parentWidget();
    move(over->mapToGlobal(QPoint((over->width() - width()) / 2, over->height() / 6)));
    line_->clear();
    filter({});
    show();
    line_->setFocus();
}

void CommandSearch::filter(const QString& text) {
    list_->clear();
    std::vector<QAction*> found;
    for (QAction* action : actions_.all())
        if (action->isEnabled() && rankOf(action, text) != kNoMatch) found.push_back(action);
    std::stable_sort(found.begin(), found.end(), [&](const QAction* a, const QAction* b) {
        return rankOf(a, text) < rankOf(b, text);
    });
    const QIcon none = emptyIcon(list_->iconSize());
    for (QAction* action : found) {
        const QString name = Actions::plainText(action);
        const QString keys = action->shortcut().toString(QKeySequence::NativeText);
        auto* item = new QListWidgetItem(
            action->icon().isNull() ? none : action->icon(),
            keys.isEmpty() ? name : QStringLiteral("%1   (%2)").arg(name, keys), list_);
        item->setToolTip(action->statusTip());
        item->setData(Qt::UserRole, QVariant::fromValue(action));
    }
    list_->setCurrentRow(0);
}

void CommandSearch::run() {
    const QListWidgetItem* item = list_->currentItem();
    hide();
    if (item) item->data(Qt::UserRole).value<QAction*>()->trigger();
}

bool CommandSearch::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Down || key == Qt::Key_Up) {
            const int step = key == Qt::Key_Down ? 1 : -1;
            list_->setCurrentRow(qBound(0, list_->currentRow() + step, list_->count() - 1));
            return true;
        }
    }
    return QFrame::eventFilter(watched, event);
}

}  // namespace glint
