// Gizmo: the handles to move, turn and scale the selection, as pure math: where they are, which one
// is under the pointer, and what a drag from one point to another means. Painting is in
// gizmo_painter.h.
#pragma once

#include <QPointF>
#include <QPolygonF>
#include <optional>

#include "gui/viewport/projection.h"

namespace glint {

enum class Tool { Select, Move, Rotate, Scale };

/// What is dragged. Axis and plane handles go with the frame's axes; Free is the plane of the
/// screen (move), the ring around the view axis (rotate), or all axes alike (scale).
enum class Handle { None, X, Y, Z, YZ, ZX, XY, Free };

/// Where the gizmo stands.
struct GizmoFrame {
    DVec3 origin{0.0};
    DMat3 axes{1.0};  ///< unit columns
};

/// What a drag means; the identity at first. Only the part of the tool is set.
struct GizmoChange {
    DVec3 translation{0.0};  ///< world, metres
    DVec3 axis{0, 1, 0};     ///< world, unit
    double angle = 0;        ///< about `axis`, radians
    DVec3 scale{1.0};        ///< along the frame's axes
};

/// The change as a map from world to world, about `pivot`.
[[nodiscard]] Affine toAffine(const GizmoChange& change, const DVec3& pivot, const DMat3& axes);

/// Pixels from the origin to the end of an axis handle.
inline constexpr double kGizmoLength = 80;

/// The axis that a handle moves or turns along: column of the frame; none for planes and Free.
[[nodiscard]] std::optional<int> axisOf(Handle handle);
/// The axis across a plane handle.
[[nodiscard]] std::optional<int> planeNormalOf(Handle handle);
/// End of an axis handle on the screen.
[[nodiscard]] std::optional<QPointF> axisEnd(const ViewProjection& view, const GizmoFrame& frame,
                                             int axis);
/// The square of a plane handle on the screen; empty where it is seen edge on.
[[nodiscard]] QPolygonF planeSquare(const ViewProjection& view, const GizmoFrame& frame,
                                    Handle handle);
/// The half of a turning ring that faces the viewer, as points on the screen; Free is the whole
/// ring around all.
[[nodiscard]] QPolygonF ring(const ViewProjection& view, const GizmoFrame& frame, Handle handle);
/// The handle under the pointer.
[[nodiscard]] Handle handleAt(const ViewProjection& view, const GizmoFrame& frame, Tool tool,
                              const QPointF& at);

struct GizmoSnap {
    double metres = 0.1, degrees = 15, factor = 0.1;
};

/// One drag. Feed it pointer positions or typed numbers.
class GizmoDrag {
  public:
    GizmoDrag(Tool tool, Handle handle, const GizmoFrame& frame, const ViewProjection& view,
              const QPointF& start);

    [[nodiscard]] Handle handle() const { return handle_; }
    [[nodiscard]] Tool tool() const { return tool_; }
    /// Locks to another axis; the drag goes on from where it started.
    void setHandle(Handle handle) { handle_ = handle; }

    struct Input {
        QPointF at;
        bool snap = false;  ///< to the steps of GizmoSnap
        bool fine = false;  ///< a tenth of the motion
    };
    [[nodiscard]] GizmoChange change(const Input& input) const;
    /// The change for a typed number: metres, degrees or a factor. Free moves along the view's
    /// right.
    [[nodiscard]] GizmoChange typed(double number) const;

  private:
    [[nodiscard]] DVec3 translation(const QPointF& at) const;
    [[nodiscard]] double angle(const QPointF& at) const;
    [[nodiscard]] double factor(const QPointF& at) const;
    [[nodiscard]] GizmoChange scaledBy(double factor) const;
    [[nodiscard]] DVec3 rotationAxis() const;

    Tool tool_;
    Handle handle_;
    GizmoFrame frame_;
    ViewProjection view_;
    QPointF start_;
};

}  // namespace glint
