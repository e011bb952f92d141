// AngleDial: a compass that turns by dragging. Shows a value and emits intents, like DragNumber.
#pragma once

#include <QWidget>

namespace glint {

class AngleDial : public QWidget {
    Q_OBJECT

  public:
    explicit AngleDial(QWidget* parent = nullptr);

    /// Degrees, any number of turns; 0 points up, growing clockwise.
    void setValue(double degrees);
    [[nodiscard]] QSize sizeHint() const override;

  signals:
    void previewed(double degrees);
    void edited(double degrees);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    [[nodiscard]] double angleAt(const QPointF& at) const;

    double value_ = 0, dragged_ = 0, last_ = 0;
    bool dragging_ = false;
};

}  // namespace glint
