#include "gui/widgets/sun_dial.h"

#include <QPainter>
#include <QtMath>
#include <algorithm>
#include <cmath>

namespace glint {

SunAngles sunAngles(const DVec3& direction) {
    const double flat = std::hypot(direction.x, direction.z);
    return {qRadiansToDegrees(std::atan2(direction.x, -direction.z)),
            qRadiansToDegrees(std::atan2(direction.y, flat))};
}

DVec3 sunDirection(const SunAngles& angles) {
    const double azimuth = qDegreesToRadians(angles.azimuth),
                 elevation = qDegreesToRadians(angles.elevation);
    return {std::sin(azimuth) * std::cos(elevation), std::sin(elevation),
            -std::cos(azimuth) * std::cos(elevation)};
}

SunDial::SunDial(QWidget* parent) : Dial(6, parent) {}

void SunDial::setValue(const SunAngles& angles) {
    value_ = angles;
    update();
}

double SunDial::radius() const { return std::min(width(), height()) / 2.0 - 8; }

SunAngles SunDial::anglesAt(const QPointF& at) const {
    const QPointF d = at - center();
    const double away = std::min(1.0, std::hypot(d.x(), d.y()) / radius());
    const auto tenth = [](double v) { return std::round(v * 10) / 10; };
    return {tenth(bearing(at)), tenth(90 * (1 - away))};
}

void SunDial::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(center());
    const double r = radius();
    QRadialGradient dome(QPointF(), r);
    dome.setColorAt(0, QColor(58, 96, 150));
    dome.setColorAt(1, QColor(176, 196, 214));
    painter.setPen(rimPen());
    painter.setBrush(isEnabled() ? QBrush(dome) : palette().base());
    painter.drawEllipse(QPointF(), r, r);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QColor(255, 255, 255, 70), 1));
    for (const double elevation : {30.0, 60.0})
        painter.drawEllipse(QPointF(), r * (1 - elevation / 90), r * (1 - elevation / 90));
    painter.drawLine(QPointF(-r, 0), QPointF(r, 0));
    painter.drawLine(QPointF(0, -r), QPointF(0, r));
    const double away = r * (1 - std::clamp(value_.elevation, 0.0, 90.0) / 90),
                 a = qDegreesToRadians(value_.azimuth);
    const QPointF sun(std::sin(a) * away, -std::cos(a) * away);
    painter.setPen(QPen(QColor(60, 40, 0), 1));
    painter.setBrush(QColor(255, 214, 92));
    painter.drawEllipse(sun, 6, 6);
}

void SunDial::grab(const QPointF& at) { drag(at, false); }

void SunDial::drag(const QPointF& at, bool) {
    dragged_ = anglesAt(at);
    emit previewed(dragged_);
}

void SunDial::drop() { emit edited(dragged_); }

void SunDial::nudge(double right, double up) {
    emit edited({value_.azimuth + right, std::clamp(value_.elevation + up, 0.0, 90.0)});
}

}  // namespace glint
