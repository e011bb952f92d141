#include "gui/widgets/message_bar.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QStyle>
#include <QToolButton>

#include "gui/widgets/icons.h"

namespace glint {

MessageBar::MessageBar(QWidget* parent) : QFrame(parent) {
    setObjectName("messageBar");
    icon_ = new QLabel(this);
    label_ = new QLabel(this);
    label_->setWordWrap(true);
    label_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    progress_ = new QProgressBar(this);
    progress_->setMaximumWidth(fontMetrics().averageCharWidth() * 30);
    progress_->setTextVisible(false);
    choices_ = new QHBoxLayout;
    close_ = new QToolButton(this);
    close_->setIcon(icon("close"));
    close_->setAutoRaise(true);
    retranslate();
    connect(close_, &QToolButton::clicked, this, &MessageBar::dismiss);

    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(8, 4, 4, 4);
    layout->addWidget(icon_);
    layout->addWidget(label_, 1);
    layout->addWidget(progress_);
    layout->addLayout(choices_);
    layout->addWidget(close_);
    hide();
}

void MessageBar::retranslate() {
    close_->setToolTip(tr("Dismiss"));
    close_->setAccessibleName(close_->toolTip());
}

void MessageBar::changeEvent(QEvent* event) {
    QFrame::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) retranslate();
}

void MessageBar::show(Level level, const QString& text, const QString& details,
                      std::vector<Choice> choices) {
    const QString names[] = {"info", "warning", "error"};
    const auto name = names[static_cast<int>(level)];
    setProperty("level", name);
    style()->unpolish(this);
    style()->polish(this);
    icon_->setPixmap(icon(level == Level::Info ? "info" : "warning").pixmap(16, 16));
    label_->setText(text);
    setToolTip(details);
    progress_->hide();
    setChoices(std::move(choices));
    QFrame::show();
    emit shown(level, text, details);
}

void MessageBar::showProgress(const QString& text, double fraction, std::vector<Choice> choices) {
    if (progress_->isHidden() || isHidden()) show(Level::Info, text, {}, std::move(choices));
    label_->setText(text);
    progress_->setRange(0, fraction < 0 ? 0 : 1000);
    progress_->setValue(static_cast<int>(fraction * 1000));
    progress_->show();
}

void MessageBar::setChoices(std::vector<Choice> choices) {
    while (QLayoutItem* item = choices_->takeAt(0)) {
        item->widget()->deleteLater();
        delete item;
    }
    for (Choice& choice : choices) {
        auto* button = new QPushButton(choice.text, this);
        connect(button, &QPushButton::clicked, this, [this, run = std::move(choice.run)] {
            dismiss();
            run();
        });
        choices_->addWidget(button);
    }
}

void MessageBar::dismiss() {
    hide();
    progress_->hide();
}

QString MessageBar::text() const { return label_->text(); }

}  // namespace glint
