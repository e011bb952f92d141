#include "gui/widgets/angle_dial.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

namespace glint {

namespace {

/// The angle between -180 and 180.
double wrapped(double degrees) { return std::remainder(degrees, 360.0); }

/// A drag's angle as it is told: in tenths.
double told(double degrees) { return std::round(wrapped(degrees) * 10) / 10; }

}  // namespace

AngleDial::AngleDial(QWidget* parent) : Dial(4, parent) {}

void AngleDial::setValue(double degrees) {
    value_ = degrees;
    update();
}

void AngleDial::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double radius = std::min(width(), height()) / 2.0 - 3;
    painter.translate(center());
    painter.setPen(rimPen());
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

void AngleDial::grab(const QPointF& at) {
    dragged_ = value_;
    last_ = bearing(at);
}

void AngleDial::drag(const QPointF& at, bool fine) {
    const double now = bearing(at);
    dragged_ += wrapped(now - last_) * (fine ? 0.1 : 1);
    last_ = now;
    emit previewed(told(dragged_));
}

void AngleDial::drop() { emit edited(told(dragged_)); }

void AngleDial::nudge(double right, double up) { emit edited(wrapped(value_ + right + up)); }

}  // namespace glint
