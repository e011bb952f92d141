// HueSquare: the area of a colour editor in which one drags saturation and value, with a strip of
// hues beside it.
#pragma once

#include <QColor>
#include <QWidget>

namespace glint {

class HueSquare : public QWidget {
    Q_OBJECT

  public:
    explicit HueSquare(QWidget* parent = nullptr);

    void setColor(const QColor& color);
    [[nodiscard]] QSize sizeHint() const override;

  signals:
    void picked(const QColor& color);
    void released(const QColor& color);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;

  private:
    [[nodiscard]] QRectF squareRect() const;
    [[nodiscard]] QRectF stripRect() const;
    void pickAt(const QPointF& at);
    [[nodiscard]] QColor color() const { return QColor::fromHsvF(hue_, saturation_, value_); }

    enum class Part { None, Square, Strip };
    Part dragging_ = Part::None;
    float hue_ = 0, saturation_ = 0, value_ = 1;
};

}  // namespace glint
