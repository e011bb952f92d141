#include "gui/widgets/hue_square.h"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>

namespace glint {

HueSquare::HueSquare(QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("Hue, saturation and value"));
}

QSize HueSquare::sizeHint() const {
    const int side = fontMetrics().height() * 9;
    return {side + side / 6, side};
}

void HueSquare::setColor(const QColor& color) {
    if (dragging_ != Part::None) return;
    // Greys have no hue and black no saturation: keep the last, so that the marks do not jump.
    if (color.hsvHueF() >= 0 && color.hsvSaturationF() > 0)
        hue_ = std::min(color.hsvHueF(), 0.9999f);
    if (color.valueF() > 0) saturation_ = color.hsvSaturationF();
    value_ = color.valueF();
    update();
}

QRectF HueSquare::squareRect() const { return QRectF(0, 0, width() - width() / 7.0 - 4, height()); }
QRectF HueSquare::stripRect() const {
    return QRectF(width() - width() / 7.0, 0, width() / 7.0, height());
}

void HueSquare::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF square = squareRect(), strip = stripRect();
    QLinearGradient across(square.topLeft(), square.topRight());
    across.setColorAt(0, Qt::white);
    across.setColorAt(1, QColor::fromHsvF(hue_, 1, 1));
    painter.fillRect(square, across);
    QLinearGradient down(square.topLeft(), square.bottomLeft());
    down.setColorAt(0, QColor(0, 0, 0, 0));
    down.setColorAt(1, Qt::black);
    painter.fillRect(square, down);
    QLinearGradient hues(strip.topLeft(), strip.bottomLeft());
    for (int i = 0; i <= 6; ++i)
        hues.setColorAt(i / 6.0, QColor::fromHsvF(static_cast<float>(i % 6) / 6.0f, 1, 1));
    painter.fillRect(strip, hues);

    const QPointF mark(square.left() + saturation_ * square.width(),
                       square.top() + (1 - value_) * square.height());
    painter.setPen(QPen(value_ > 0.5f ? Qt::black : Qt::white, 1.5));
    painter.drawEllipse(mark, 5, 5);
    const double y = strip.top() + hue_ * strip.height();
    painter.setPen(QPen(Qt::black, 1.5));
    painter.drawRect(QRectF(strip.left() + 0.75, y - 2, strip.width() - 1.5, 4));
}

void HueSquare::pickAt(const QPointF& at) {
    if (dragging_ == Part::Strip) {
        const QRectF strip = stripRect();
        hue_ = static_cast<float>(std::clamp((at.y() - strip.top()) / strip.height(), 0.0, 0.9999));
    } else {
        const QRectF square = squareRect();
        saturation_ =
            static_cast<float>(std::clamp((at.x() - square.left()) / square.width(), 0.0, 1.0));
        value_ =
            static_cast<float>(std::clamp(1 - (at.y() - square.top()) / square.height(), 0.0, 1.0));
    }
    update();
    emit picked(color());
}

void HueSquare::mousePressEvent(QMouseEvent* event) {
    dragging_ =
        stripRect().adjusted(-3, 0, 0, 0).contains(event->position()) ? Part::Strip : Part::Square;
    pickAt(event->position());
}

void HueSquare::mouseMoveEvent(QMouseEvent* event) {
    if (dragging_ != Part::None) pickAt(event->position());
}

void HueSquare::mouseReleaseEvent(QMouseEvent*) {
    dragging_ = Part::None;
    emit released(color());
}

}  // namespace glint
