// Dial: a round handle that turns by dragging or with the arrow keys. What it shows, and what a
// place on it means, is in the dials that derive from it: angle_dial.h, sun_dial.h. Like DragNumber
// it shows values and emits intents.
#pragma once

#include <QWidget>

namespace glint {

class Dial : public QWidget {
    Q_OBJECT

  public:
    [[nodiscard]] QSize sizeHint() const override;

  signals:
    /// A drag has been given up: what it previewed does not count.
    void canceled();

  protected:
    /// As high as so many lines of text.
    Dial(int lines, QWidget* parent);

    [[nodiscard]] QPointF center() const { return QRectF(rect()).center(); }
    /// Degrees clockwise from straight up, -180 to 180, at which a place lies about the centre.
    [[nodiscard]] double bearing(const QPointF& at) const;
    [[nodiscard]] QPen rimPen() const;

    /// A drag begins.
    virtual void grab(const QPointF& at) = 0;
    /// It goes on: tell what it would give.
    virtual void drag(const QPointF& at, bool fine) = 0;
    /// It ends: tell what it has given.
    virtual void drop() = 0;
    /// An arrow key, of so many degrees to the right and up.
    virtual void nudge(double right, double up) = 0;

    void mousePressEvent(QMouseEvent* event) final;
    void mouseMoveEvent(QMouseEvent* event) final;
    void mouseReleaseEvent(QMouseEvent* event) final;
    void keyPressEvent(QKeyEvent* event) final;

  private:
    int lines_;
    bool dragging_ = false;
};

}  // namespace glint
