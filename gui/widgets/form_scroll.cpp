#include "gui/widgets/form_scroll.h"

#include <QEvent>
#include <QScrollBar>
#include <QVBoxLayout>

namespace glint {

FormScroll::FormScroll(QWidget* parent) : QScrollArea(parent), layout_(new QVBoxLayout) {
    auto* holder = new QWidget(this);
    layout_->setContentsMargins(0, 0, 0, 0);
    holder->setLayout(layout_);
    holder->installEventFilter(this);
    setWidget(holder);
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
}

QWidget* FormScroll::newForm() {
    if (form_) {
        // The old form may be in the middle of an event of one of its editors. It keeps its place
        // in the tree of widgets: to take it out would set the style of each of its parts anew.
        layout_->removeWidget(form_);
        form_->hide();
        form_->deleteLater();
    }
    form_ = new QWidget(widget());
    return form_;
}

void FormScroll::showForm() {
    layout_->addWidget(form_);
    form_->show();
    fitWidth();
}

bool FormScroll::eventFilter(QObject* watched, QEvent* event) {
    if (watched == widget() && event->type() == QEvent::LayoutRequest) fitWidth();
    return QScrollArea::eventFilter(watched, event);
}

void FormScroll::fitWidth() {
    setMinimumWidth(widget()->minimumSizeHint().width() + verticalScrollBar()->sizeHint().width());
}

}  // namespace glint
