#include "gui/widgets/sun_dial.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QtMath>
#include <algorithm>
#include <cmath>

namespace glint {

SunAngles sunAngles(const DVec3& direction) {
    const double flat = std::hypot(direction.x, direction.z);
    return {qRadiansToDegrees(std::atan2(direction.x, -direction.z)), qRadiansToDegrees(std::atan2(direction.y, flat))};
}

DVec3 sunDirection(const SunAngles& angles) {
    const double azimuth = qDegreesToRadians(angles.azimuth), elevation = qDegreesToRadians(angles.elevation);
    return {std::sin(azimuth) * std::cos(elevation), std::sin(elevation), -std::cos(azimuth) * std::cos(elevation)};
}

SunDial::SunDial(QWidget* parent) : QWidget(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setCursor(Qt::PointingHandCursor);
}

void SunDial::setValue(const SunAngles& angles) {
    value_ = angles;
    update();
}

QSize SunDial::sizeHint() const {
    const int side = fontMetrics().height() * 6;
    return {side, side};
}

double SunDial::radius() const { return std::min(width(), height()) / 2.0 - 8; }

SunAngles SunDial::anglesAt(const QPointF& at) const {
    const QPointF d = at - QRectF(rect()).center();
    const double away = std::min(1.0, std::hypot(d.x(), d.y()) / radius());
    const auto tenth = [](double v) { return std::round(v * 10) / 10; };
    return {tenth(qRadiansToDegrees(std::atan2(d.x(), -d.y()))), tenth(90 * (1 - away))};
}

void SunDial::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(QRectF(rect()).center());
    const double r = radius();
    QRadialGradient dome(QPointF(), r);
    dome.setColorAt(0, QColor(58, 96, 150));
    dome.setColorAt(1, QColor(176, 196, 214));
    painter.setPen(QPen(hasFocus() ? palette().highlight().color() : palette().mid().color(), 1.5));
    painter.setBrush(isEnabled() ? QBrush(dome) : palette().base());
    painter.drawEllipse(QPointF(), r, r);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QColor(255, 255, 255, 70), 1));
    for (const double elevation : {30.0, 60.0}) painter.drawEllipse(QPointF(), r * (1 - elevation / 90), r * (1 - elevation / 90));
    painter.drawLine(QPointF(-r, 0), QPointF(r, 0));
    painter.drawLine(QPointF(0, -r), QPointF(0, r));
    const double away = r * (1 - std::clamp(value_.elevation, 0.0, 90.0) / 90), a = qDegreesToRadians(value_.azimuth);
    const QPointF sun(std::sin(a) * away, -std::cos(a) * away);
    painter.setPen(QPen(QColor(60, 40, 0), 1));
    painter.setBrush(QColor(255, 214, 92));
    painter.drawEllipse(sun, 6, 6);
}

void SunDial::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    dragging_ = true;
    emit previewed(anglesAt(event->position()));
}

void SunDial::mouseMoveEvent(QMouseEvent* event) {
    if (dragging_) emit previewed(anglesAt(event->position()));
}

void SunDial::mouseReleaseEvent(QMouseEvent* event) {
    if (std::exchange(dragging_, false)) emit edited(anglesAt(event->position()));
}

void SunDial::keyPressEvent(QKeyEvent* event) {
    const double step = event->modifiers() & Qt::ShiftModifier ? 1 : 5;
    SunAngles next = value_;
    switch (event->key()) {
        case Qt::Key_Left: next.azimuth -= step; break;
        case Qt::Key_Right: next.azimuth += step; break;
        case Qt::Key_Up: next.elevation = std::min(90.0, next.elevation + step); break;
        case Qt::Key_Down: next.elevation = std::max(0.0, next.elevation - step); break;
        default: return QWidget::keyPressEvent(event);
    }
    emit edited(next);
}

}  // namespace glint
