#include "gui/viewport/region_gesture.h"

#include <QCoreApplication>

namespace glint {

QRectF RegionGesture::region() const {
    const QRectF view = context_.widget.rect();
    const QRectF box = QRectF(start_, last_).normalized() & view;
    return {box.x() / view.width(), box.y() / view.height(), box.width() / view.width(),
            box.height() / view.height()};
}

void RegionGesture::finish(const Pointer& pointer) {
    last_ = pointer.at;
    constexpr double kLeast = 4;  // logical pixels: less is a click
    const bool dragged = (last_ - start_).manhattanLength() >= kLeast && region().width() > 0 &&
                         region().height() > 0;
    context_.renderer.setRegion(dragged ? std::optional(region()) : std::nullopt);
}

void RegionGesture::paint(QPainter& painter) const {
    paintRegion(painter, region(), context_.widget.rect());
}

QString RegionGesture::readout() const {
    const double scale = context_.widget.devicePixelRatioF();
    const QRectF r = region();
    return QCoreApplication::translate("RegionGesture", "Region %1 × %2 px")
        .arg(qRound(r.width() * context_.widget.width() * scale))
        .arg(qRound(r.height() * context_.widget.height() * scale));
}

void paintRegion(QPainter& painter, const QRectF& region, const QRectF& view) {
    const QRectF box(region.x() * view.width(), region.y() * view.height(),
                     region.width() * view.width(), region.height() * view.height());
    painter.setBrush(Qt::NoBrush);
    // Dark below light, so that it is seen on everything.
    painter.setPen(QPen(QColor(0, 0, 0, 160), 3));
    painter.drawRect(box);
    painter.setPen(QPen(QColor(245, 245, 245), 1, Qt::DashLine));
    painter.drawRect(box);
}

}  // namespace glint
