// ColorPopup: the editor that a ColorButton opens. Colours are linear; the square and the hex
// digits are as the screen shows them, with "brightness" as the factor above 1.
#pragma once

#include <QFrame>

#include "tracer/color/rgb.h"

class QLineEdit;

namespace glint {

class DragNumber;
class HueSquare;

class ColorPopup : public QFrame {
    Q_OBJECT

  public:
    ColorPopup(double min, double max, QWidget* parent);

    void setValue(const Color& color);

  signals:
    void previewed(const glint::Color& color);
    void edited(const glint::Color& color);
    void canceled();
    /// The next click on the picture is to give the colour.
    void dropperRequested();

  private:
    void buildNumbers(double min, double max);
    void onHex();
    /// `color` from the square, made as bright as the present value.
    [[nodiscard]] Color withBrightness(const QColor& color) const;

    Color value_;
    double max_;
    HueSquare* square_;
    DragNumber* channels_[3] = {};
    DragNumber* brightness_ = nullptr;
    QLineEdit* hex_ = nullptr;
};

}  // namespace glint
