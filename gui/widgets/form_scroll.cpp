#include "gui/widgets/form_scroll.h"

#include <QEvent>
#include <QScrollBar>

namespace glint {

FormScroll::FormScroll(QWidget* parent) : QScrollArea(parent) {
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
}

void FormScroll::setForm(QWidget* form) {
    // The old form may be in the middle of an event of one of its editors.
    if (QWidget* old = takeWidget()) {
        old->hide();
        old->deleteLater();
    }
    setWidget(form);
    form->installEventFilter(this);
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
