#include "gui/widgets/color_button.h"

#include <QPainter>
#include <QScreen>
#include <QToolTip>
#include <algorithm>

#include "gui/widgets/color_popup.h"
#include "gui/widgets/drag_number.h"
#include "gui/widgets/eyedropper.h"
#include "tracer/color/display.h"

namespace glint {

QColor screenColor(const Color& linear) {
    const double scale = std::max({1.0, linear.r, linear.g, linear.b});
    const auto channel = [&](double v) { return srgbFromLinear(static_cast<float>(v / scale)); };
    return QColor::fromRgbF(channel(linear.r), channel(linear.g), channel(linear.b));
}

ColorButton::ColorButton(QWidget* parent) : QAbstractButton(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setFocusPolicy(Qt::StrongFocus);
    connect(this, &QAbstractButton::clicked, this, &ColorButton::openPopup);
}

void ColorButton::setRange(double min, double max) {
    min_ = min;
    max_ = max;
}

void ColorButton::setValue(const Color& color) {
    value_ = color;
    if (popup_) popup_->setValue(color);
    update();
}

void ColorButton::setMixed() {
    value_.reset();
    update();
}

void ColorButton::refuse(const QString& reason) {
    if (value_ && popup_) popup_->setValue(*value_);
    QToolTip::showText(mapToGlobal(QPoint(0, height())), reason, this);
}

QSize ColorButton::sizeHint() const {
    return {fontMetrics().horizontalAdvance("0.000 0.000") + 24, fontMetrics().height() + 8};
}

ColorPopup& ColorButton::popup() {
    if (!popup_) {
        popup_ = new ColorPopup(min_, max_, this);
        connect(popup_, &ColorPopup::previewed, this, &ColorButton::previewed);
        connect(popup_, &ColorPopup::edited, this, &ColorButton::edited);
        connect(popup_, &ColorPopup::canceled, this, &ColorButton::canceled);
        connect(popup_, &ColorPopup::dropperRequested, this, &ColorButton::pickFromPicture);
    }
    popup_->setValue(value_.value_or(Color{0.5, 0.5, 0.5}));
    return *popup_;
}

void ColorButton::pickFromPicture() {
    popup_->hide();
    auto* dropper = new Eyedropper(this);
    connect(dropper, &Eyedropper::picked, this, [this](const Color& picked) {
        const auto allowed = [this](double v) { return std::clamp(v, min_, max_); };
        emit edited({allowed(picked.r), allowed(picked.g), allowed(picked.b)});
    });
}

void ColorButton::openPopup() {
    ColorPopup& editor = popup();
    editor.adjustSize();
    const QRect space = screen()->availableGeometry();
    QPoint at = mapToGlobal(QPoint(width() - editor.width(), height() + 2));
    if (at.y() + editor.height() > space.bottom())
        at.setY(mapToGlobal(QPoint()).y() - editor.height() - 2);
    at.setX(
        std::clamp(at.x(), space.left(), std::max(space.left(), space.right() - editor.width())));
    editor.move(at);
    editor.show();
}

void ColorButton::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF frame = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
    painter.setPen(hasFocus() ? palette().highlight().color() : palette().mid().color());
    painter.setBrush(value_ ? QBrush(screenColor(*value_)) : palette().base());
    painter.drawRoundedRect(frame, 3, 3);
    if (!value_) {
        painter.setPen(palette().text().color());
        painter.drawText(rect(), Qt::AlignCenter, QStringLiteral("—"));
        return;
    }
    const double peak = std::max({value_->r, value_->g, value_->b});
    if (peak <= 1) return;
    const bool bright = qGray(screenColor(*value_).rgb()) > 140;
    painter.setPen(bright ? Qt::black : Qt::white);
    painter.drawText(rect(), Qt::AlignCenter, QStringLiteral("× %1").arg(shortNumber(peak)));
}

}  // namespace glint
