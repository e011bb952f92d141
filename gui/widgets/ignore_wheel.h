// IgnoreWheel: an event filter for widgets in scrolled panels whose value must not change under a
// passing wheel.
#pragma once

#include <QEvent>
#include <QObject>

namespace glint {

class IgnoreWheel : public QObject {
  public:
    using QObject::QObject;

    bool eventFilter(QObject*, QEvent* event) override {
        if (event->type() != QEvent::Wheel) return false;
        event->ignore();
        return true;
    }
};

}  // namespace glint
