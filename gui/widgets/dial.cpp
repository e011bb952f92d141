#include "gui/widgets/dial.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPen>
#include <QtMath>
#include <cmath>
#include <utility>

namespace glint {

Dial::Dial(int lines, QWidget* parent) : QWidget(parent), lines_(lines) {
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setCursor(Qt::PointingHandCursor);
}

QSize Dial::sizeHint() const {
    const int side = fontMetrics().height() * lines_;
    return {side, side};
}

double Dial::bearing(const QPointF& at) const {
    const QPointF d = at - center();
    return qRadiansToDegrees(std::atan2(d.x(), -d.y()));
}

QPen Dial::rimPen() const {
    return {hasFocus() ? palette().highlight().color() : palette().mid().color(), 1.5};
}

void Dial::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    dragging_ = true;
    grab(event->position());
}

void Dial::mouseMoveEvent(QMouseEvent* event) {
    if (dragging_) drag(event->position(), event->modifiers() & Qt::ShiftModifier);
}

void Dial::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton && std::exchange(dragging_, false)) drop();
}

void Dial::keyPressEvent(QKeyEvent* event) {
    const double step = event->modifiers() & Qt::ShiftModifier ? 1 : 5;
    switch (event->key()) {
        case Qt::Key_Left:
            return nudge(-step, 0);
        case Qt::Key_Right:
            return nudge(step, 0);
        case Qt::Key_Up:
            return nudge(0, step);
        case Qt::Key_Down:
            return nudge(0, -step);
        case Qt::Key_Escape:
            if (std::exchange(dragging_, false)) return emit canceled();
            break;
        default:
            break;
    }
    QWidget::keyPressEvent(event);
}

}  // namespace glint
