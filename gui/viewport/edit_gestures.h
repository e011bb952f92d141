// Gestures that select and change items: a drag of the gizmo, and a selection box.
#pragma once

#include <vector>

#include "gui/viewport/gesture.h"

namespace glint {

/// Moves, turns or scales the selected items. X Y Z lock to an axis, digits type a number, Enter
/// ends, Escape takes back.
class GizmoGesture : public Gesture {
  public:
    GizmoGesture(ViewContext& context, Handle handle, const GizmoFrame& frame,
                 const QPointF& start);
    /// Changes items of `base`, which is previewed: new ones that shall stay with the same undo
    /// step, named `text`.
    GizmoGesture(ViewContext& context, const GizmoFrame& frame, const QPointF& start, Scene base,
                 const QString& text);

    void move(const Pointer& pointer) override;
    void finish(const Pointer& pointer) override;
    void cancel() override;
    bool keyPressed(const QKeyEvent& event) override;
    [[nodiscard]] QString readout() const override;
    [[nodiscard]] const GizmoDrag& drag() const { return drag_; }

  private:
    void show();
    [[nodiscard]] GizmoChange change() const;

    GizmoDrag drag_;
    GizmoFrame frame_;
    Scene base_;
    std::vector<Item> items_;
    QString text_, typed_;
    Pointer pointer_;
};

/// A box on empty ground selects what lies in it; a click selects what is under it.
class SelectGesture : public Gesture {
  public:
    SelectGesture(ViewContext& context, const Pointer& start);

    void move(const Pointer& pointer) override;
    void finish(const Pointer& pointer) override;
    void cancel() override {}
    void paint(QPainter& painter) const override;

  private:
    [[nodiscard]] QRectF box() const { return QRectF(start_.at, last_).normalized(); }
    [[nodiscard]] bool isBox() const;

    Pointer start_;
    QPointF last_;
};

}  // namespace glint
