// ColorButton: a swatch for a linear colour, also one brighter than 1. A click opens a small editor
// beside it: hue and saturation, brightness, linear numbers and hex. Like DragNumber it shows a
// value and emits intents.
#pragma once

#include <QAbstractButton>
#include <optional>

#include "tracer/color/rgb.h"

namespace glint {

class ColorPopup;

class ColorButton : public QAbstractButton {
    Q_OBJECT

  public:
    explicit ColorButton(QWidget* parent = nullptr);

    /// Limits of each channel; `max` infinite for light.
    void setRange(double min, double max);
    void setValue(const Color& color);
    /// Shows "—": many values that differ.
    void setMixed();
    void refuse(const QString& reason);
    [[nodiscard]] QSize sizeHint() const override;
    /// The editor, made at first use.
    [[nodiscard]] ColorPopup& popup();

  signals:
    void previewed(const glint::Color& color);
    void edited(const glint::Color& color);
    void canceled();

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    void openPopup();
    void pickFromPicture();

    double min_ = 0, max_ = 1;
    std::optional<Color> value_;
    ColorPopup* popup_ = nullptr;
};

/// The colour as the screen shows it, scaled down where a channel is above 1.
[[nodiscard]] QColor screenColor(const Color& linear);

}  // namespace glint
