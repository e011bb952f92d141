// Gesture: what the pointer is doing in the viewport, from press to release. One at a time.
// finish() keeps what was done, cancel() takes it back.
#pragma once

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QString>

#include "gui/viewport/view_context.h"

namespace glint {

/// Where the pointer is and which keys are held.
struct Pointer {
    QPointF at;
    Qt::KeyboardModifiers modifiers;
};

class Gesture {
  public:
    explicit Gesture(ViewContext& context) : context_(context) {}
    virtual ~Gesture() = default;
    Gesture(const Gesture&) = delete;
    Gesture& operator=(const Gesture&) = delete;

    virtual void move(const Pointer& pointer) = 0;
    virtual void finish(const Pointer& pointer) = 0;
    virtual void cancel() = 0;
    /// True if the key is for this gesture; then no shortcut sees it.
    virtual bool keyPressed(const QKeyEvent&) { return false; }
    virtual void keyReleased(const QKeyEvent&) {}
    virtual bool wheel(double) { return false; }
    virtual void paint(QPainter&) const {}
    /// One line about what is going on.
    [[nodiscard]] virtual QString readout() const { return {}; }

  protected:
    ViewContext& context_;
};

}  // namespace glint
