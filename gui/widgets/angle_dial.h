// AngleDial: a compass that turns by dragging.
#pragma once

#include "gui/widgets/dial.h"

namespace glint {

class AngleDial : public Dial {
    Q_OBJECT

  public:
    explicit AngleDial(QWidget* parent = nullptr);

    /// Degrees, any number of turns; 0 points up, growing clockwise.
    void setValue(double degrees);

  signals:
    void previewed(double degrees);
    void edited(double degrees);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void grab(const QPointF& at) override;
    void drag(const QPointF& at, bool fine) override;
    void drop() override;
    void nudge(double right, double up) override;

  private:
    double value_ = 0, dragged_ = 0, last_ = 0;
};

}  // namespace glint
