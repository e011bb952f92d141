#include "gui/widgets/angle_dial.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QtMath>
#include <cmath>

namespace glint {

namespace {

/// The angle between -180 and 180.
double wrapped(double degrees) { return std::remainder(degrees, 360.0); }

}  // namespace

AngleDial::AngleDial(QWidget* parent) : QWidget(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setCursor(Qt::PointingHandCursor);
}

void AngleDial::setValue(double degrees) {
    value_ = degrees;
    update();
}

QSize AngleDial::sizeHint() const {
    const int side = fontMetrics().height() * 4;
    return {side, side};
}

double AngleDial::angleAt(const QPointF& at) const {
    const QPointF d = at - QRectF(rect()).center();
    return qRadiansToDegrees(std::atan2(d.x(), -d.y()));
}

void AngleDial::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double radius = std::min(width(), height()) / 2.0 - 3;
    painter.translate(QRectF(rect()).center());
    painter.setPen(QPen(hasFocus() ? palette().highlight().color() : palette().mid().color(), 1.5));
    painter.setBrush(palette().base());
    painter.drawEllipse(QPointF(), radius, radius);
    painter.setPen(QPen(palette().placeholderText().color(), 1));
    for (int tick = 0; tick < 360; tick += 30) {
        painter.save();
        painter.rotate(tick);
        painter.drawLine(QPointF(0, -radius + 2), QPointF(0, -radius + (tick % 90 ? 5 : 8)));
        painter.restore();
    }
    painter.rotate(value_);
    painter.setPen(QPen(palette().highlight().color(), 2.5, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(QPointF(0, 0), QPointF(0, -radius + 7));
    painter.setBrush(palette().highlight());
    painter.drawEllipse(QPointF(0, -radius + 7), 3.5, 3.5);
}

void AngleDial::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    dragging_ = true;
    dragged_ = value_;
    last_ = angleAt(event->position());
}

void AngleDial::mouseMoveEvent(QMouseEvent* event) {
    if (!dragging_) return;
    const double now = angleAt(event->position());
    dragged_ += wrapped(now - last_) * (event->modifiers() & Qt::ShiftModifier ? 0.1 : 1);
    last_ = now;
    emit previewed(std::round(wrapped(dragged_) * 10) / 10);
}

void AngleDial::mouseReleaseEvent(QMouseEvent* event) {
    if (!std::exchange(dragging_, false) || event->button() != Qt::LeftButton) return;
    emit edited(std::round(wrapped(dragged_) * 10) / 10);
}

void AngleDial::keyPressEvent(QKeyEvent* event) {
    const double step = event->modifiers() & Qt::ShiftModifier ? 1 : 5;
    if (event->key() == Qt::Key_Right || event->key() == Qt::Key_Up) emit edited(wrapped(value_ + step));
    else if (event->key() == Qt::Key_Left || event->key() == Qt::Key_Down) emit edited(wrapped(value_ - step));
    else QWidget::keyPressEvent(event);
}

}  // namespace glint
