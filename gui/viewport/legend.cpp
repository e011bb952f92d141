#include "gui/viewport/legend.h"

#include <QCoreApplication>
#include <QLinearGradient>
#include <cmath>

#include "tracer/color/false_color.h"

namespace glint {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("Legend", text); }

/// A value of the channel with its unit.
QString valueText(Channel channel, double value) {
    switch (channel) {
        case Channel::Depth:
            return tr("%1 m").arg(value, 0, 'g', 3);
        case Channel::Error:
            return tr("%1 %").arg(100 * value, 0, 'g', 3);
        case Channel::Luminance:
            return tr("%1 EV").arg(value, 0, 'f', 0);
        default:
            return QString::number(value, 'f', 0);
    }
}

double valueAt(const Legend& legend, double place) {
    if (!legend.logarithmic) return legend.low + place * (legend.high - legend.low);
    return legend.low * std::pow(legend.high / legend.low, place);
}

/// What the colours mean where they are no scale.
QString explanation(Channel channel) {
    switch (channel) {
        case Channel::Normal:
            return tr("red x, green y, blue z: −1 to 1");
        case Channel::Position:
            return tr("red x, green y, blue z: from the least to the largest in view");
        case Channel::Object:
        case Channel::Material:
            return tr("one colour each");
        default:
            return {};
    }
}

void paintScale(QPainter& painter, const SessionFrame& frame, const QRectF& bar) {
    QLinearGradient gradient(bar.topLeft(), bar.topRight());
    constexpr int kStops = 16;
    for (int i = 0; i <= kStops; ++i) {
        const double place = static_cast<double>(i) / kStops;
        // Near is bright.
        const double shown = frame.channel == Channel::Depth ? 1 - place : place;
        gradient.setColorAt(place, QColor::fromRgb(falseColor(static_cast<float>(shown))));
    }
    painter.setPen(QColor(235, 235, 235));
    painter.setBrush(gradient);
    painter.drawRect(bar);
    const double line = painter.fontMetrics().height();
    constexpr int kMarks = 2;  // ends and middle
    for (int i = 0; i <= kMarks; ++i) {
        const double place = static_cast<double>(i) / kMarks;
        const int align = i == 0 ? Qt::AlignLeft : i == kMarks ? Qt::AlignRight : Qt::AlignHCenter;
        const double x = bar.x() + place * bar.width(), half = bar.width() / 2;
        const double left = i == 0 ? x : i == kMarks ? x - 2 * half : x - half;
        painter.drawText(QRectF(left, bar.bottom() + 2, 2 * half, line), align,
                         valueText(frame.channel, valueAt(*frame.legend, place)));
    }
}

}  // namespace

QString channelName(Channel channel) {
    switch (channel) {
        case Channel::Beauty:
            return tr("Beauty");
        case Channel::Albedo:
            return tr("Albedo");
        case Channel::Normal:
            return tr("Normal");
        case Channel::Depth:
            return tr("Depth");
        case Channel::Position:
            return tr("Position");
        case Channel::Object:
            return tr("Objects");
        case Channel::Material:
            return tr("Materials");
        case Channel::Samples:
            return tr("Samples a pixel");
        case Channel::Error:
            return tr("Error (95 % bound)");
        case Channel::Luminance:
            return tr("Luminance, stops from middle grey");
    }
    return {};
}

void paintLegend(QPainter& painter, const SessionFrame& frame, const QRectF& view) {
    const QFontMetricsF metrics(painter.font());
    const double line = metrics.height(), gap = line / 2;
    const QString title = channelName(frame.channel), below = explanation(frame.channel);
    const double width = std::min(
        view.width() - 2 * gap,
        std::max({line * 14, metrics.horizontalAdvance(title), metrics.horizontalAdvance(below)}) +
            2 * gap);
    const double height = gap * 2 + line +
                          (frame.legend      ? line * 2 + 6
                           : below.isEmpty() ? 0
                                             : line);
    const QRectF box(gap, view.height() - height - gap, width, height);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(0, 0, 0, 170));
    painter.drawRoundedRect(box, 4, 4);
    painter.setPen(QColor(235, 235, 235));
    const QRectF inner = box.adjusted(gap, gap, -gap, -gap);
    painter.drawText(QRectF(inner.x(), inner.y(), inner.width(), line), Qt::AlignLeft, title);
    const QRectF second(inner.x(), inner.y() + line + 2, inner.width(), line);
    if (frame.legend)
        paintScale(painter, frame, second.adjusted(0, 2, 0, -2));
    else
        painter.drawText(second, Qt::AlignLeft,
                         metrics.elidedText(below, Qt::ElideRight, second.width()));
}

}  // namespace glint
