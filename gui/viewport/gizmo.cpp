#include "gui/viewport/gizmo.h"

#include <QLineF>
#include <algorithm>
#include <array>
#include <cmath>

namespace glint {

namespace {

constexpr double kReach = 8;         // Pixels from a handle within which it is hit.
constexpr double kPlaneFrom = 0.28;  // Plane squares span this part of the axes
constexpr double kPlaneTo = 0.5;     // to this part.
constexpr double kRingScale = 1.0, kFreeRingScale = 1.2;
constexpr int kRingPoints = 72;
/// Axes nearer to the view than this (cosine) have no direction on the screen.
constexpr double kAlongView = 0.995;
/// Rings seen flatter than this (sine) are dragged along their tangent instead of around.
constexpr double kFlatRing = 0.2;

double worldLength(const ViewProjection& view, const GizmoFrame& frame) {
    return kGizmoLength * view.metresPerPixel(frame.origin);
}

double distanceToSegment(const QPointF& p, const QPointF& a, const QPointF& b) {
    const QPointF d = b - a;
    const double squared = QPointF::dotProduct(d, d);
    const double t =
        squared > 0 ? std::clamp(QPointF::dotProduct(p - a, d) / squared, 0.0, 1.0) : 0;
    return QLineF(p, a + d * t).length();
}

double distanceToPolyline(const QPointF& p, const QPolygonF& line) {
    double best = kInfinity;
    for (qsizetype i = 0; i + 1 < line.size(); ++i)
        best = std::min(best, distanceToSegment(p, line[i], line[i + 1]));
    return best;
}

/// Parameter along origin + t * axis of the point nearest to the ray.
double nearestOnAxis(const ViewRay& ray, const DVec3& origin, const DVec3& axis) {
    const double b = glm::dot(axis, ray.direction), across = 1 - b * b;
    if (across < 1e-9) return 0;
    const DVec3 w = origin - ray.origin;
    return (b * glm::dot(ray.direction, w) - glm::dot(axis, w)) / across;
}

std::optional<DVec3> onPlane(const ViewRay& ray, const DVec3& origin, const DVec3& normal) {
    const double d = glm::dot(ray.direction, normal);
    if (std::abs(d) < 1e-9) return std::nullopt;
    return ray.origin + ray.direction * (glm::dot(origin - ray.origin, normal) / d);
}

double snapped(double value, double step, bool snap) {
    return snap ? std::round(value / step) * step : value;
}

constexpr std::array kAxes = {Handle::X, Handle::Y, Handle::Z};
constexpr std::array kPlanes = {Handle::YZ, Handle::ZX, Handle::XY};

Handle ringAt(const ViewProjection& view, const GizmoFrame& frame, const QPointF& at) {
    Handle best = Handle::None;
    double nearest = kReach;
    for (const Handle handle : {Handle::X, Handle::Y, Handle::Z, Handle::Free}) {
        const double distance = distanceToPolyline(at, ring(view, frame, handle));
        if (distance < nearest) nearest = distance, best = handle;
    }
    return best;
}

}  // namespace

Affine toAffine(const GizmoChange& change, const DVec3& pivot, const DMat3& axes) {
    const double c = std::cos(change.angle), s = std::sin(change.angle);
    const DVec3& a = change.axis;
    DMat3 rotation(1.0);
    if (change.angle != 0)
        for (int i = 0; i < 3; ++i) {
            DVec3 e(0.0);
            e[i] = 1;
            rotation[i] = e * c + glm::cross(a, e) * s + a * a[i] * (1 - c);
        }
    DMat3 scaling(1.0);
    if (change.scale != DVec3(1.0)) {
        DMat3 stretched = axes;
        for (int i = 0; i < 3; ++i) stretched[i] *= change.scale[i];
        scaling = stretched * glm::transpose(axes);
    }
    const DMat3 linear = rotation * scaling;
    const DVec3 fixed = linear == DMat3(1.0) ? DVec3(0.0) : pivot - linear * pivot;
    return {linear, fixed + change.translation};
}

std::optional<int> axisOf(Handle handle) {
    if (handle == Handle::X) return 0;
    if (handle == Handle::Y) return 1;
    if (handle == Handle::Z) return 2;
    return std::nullopt;
}

std::optional<int> planeNormalOf(Handle handle) {
    if (handle == Handle::YZ) return 0;
    if (handle == Handle::ZX) return 1;
    if (handle == Handle::XY) return 2;
    return std::nullopt;
}

std::optional<QPointF> axisEnd(const ViewProjection& view, const GizmoFrame& frame, int axis) {
    if (std::abs(glm::dot(frame.axes[axis], view.towardsViewer(frame.origin))) > kAlongView)
        return std::nullopt;
    return view.project(frame.origin + frame.axes[axis] * worldLength(view, frame));
}

QPolygonF planeSquare(const ViewProjection& view, const GizmoFrame& frame, Handle handle) {
    const int normal = planeNormalOf(handle).value_or(0);
    if (std::abs(glm::dot(frame.axes[normal], view.towardsViewer(frame.origin))) < kFlatRing)
        return {};
    const double length = worldLength(view, frame);
    const DVec3 a = frame.axes[(normal + 1) % 3] * length,
                b = frame.axes[(normal + 2) % 3] * length;
    QPolygonF out;
    for (const auto& [u, v] : {std::pair(kPlaneFrom, kPlaneFrom), std::pair(kPlaneTo, kPlaneFrom),
                               std::pair(kPlaneTo, kPlaneTo), std::pair(kPlaneFrom, kPlaneTo)}) {
        const auto corner = view.project(frame.origin + a * u + b * v);
        if (!corner) return {};
        out << *corner;
    }
    return out;
}

QPolygonF ring(const ViewProjection& view, const GizmoFrame& frame, Handle handle) {
    const auto axis = axisOf(handle);
    const DVec3 viewer = view.towardsViewer(frame.origin);
    const DVec3 normal = axis ? frame.axes[*axis] : viewer;
    const DVec3 helper = axis ? frame.axes[(*axis + 1) % 3] : view.axes().up;
    const DVec3 u = glm::normalize(helper - normal * glm::dot(helper, normal)),
                v = glm::cross(normal, u);
    const double radius = worldLength(view, frame) * (axis ? kRingScale : kFreeRingScale);
    // Start where the ring is farthest from the viewer, so that the front half is one piece.
    const double back = axis ? std::atan2(glm::dot(v, -viewer), glm::dot(u, -viewer)) : 0;
    QPolygonF out;
    for (int i = 0; i <= kRingPoints; ++i) {
        const double angle = back + 2 * kPi * i / kRingPoints;
        const DVec3 offset = u * std::cos(angle) + v * std::sin(angle);
        if (axis && glm::dot(offset, viewer) < -0.02) continue;
        if (const auto point = view.project(frame.origin + offset * radius)) out << *point;
    }
    return out;
}

Handle handleAt(const ViewProjection& view, const GizmoFrame& frame, Tool tool, const QPointF& at) {
    const auto origin = view.project(frame.origin);
    if (tool == Tool::Select || !origin) return Handle::None;
    if (tool == Tool::Rotate) return ringAt(view, frame, at);
    if (QLineF(at, *origin).length() < kReach + 2) return Handle::Free;
    if (tool == Tool::Move)
        for (const Handle plane : kPlanes)
            if (planeSquare(view, frame, plane).containsPoint(at, Qt::OddEvenFill)) return plane;
    Handle best = Handle::None;
    double nearest = kReach;
    for (int axis = 0; axis < 3; ++axis) {
        const auto end = axisEnd(view, frame, axis);
        const double distance = end ? distanceToSegment(at, *origin, *end) : kInfinity;
        if (distance < nearest) nearest = distance, best = kAxes[static_cast<std::size_t>(axis)];
    }
    return best;
}

GizmoDrag::GizmoDrag(Tool tool, Handle handle, const GizmoFrame& frame, const ViewProjection& view,
                     const QPointF& start)
    : tool_(tool), handle_(handle), frame_(frame), view_(view), start_(start) {}

GizmoChange GizmoDrag::change(const Input& input) const {
    const QPointF at = input.fine ? start_ + (input.at - start_) / 10 : input.at;
    const GizmoSnap snap;
    GizmoChange out;
    switch (tool_) {
        case Tool::Select:
            break;
        case Tool::Move: {
            // Snap along the frame's axes, so that a locked drag moves by whole steps.
            const DVec3 local = glm::transpose(frame_.axes) * translation(at);
            for (int i = 0; i < 3; ++i)
                out.translation += frame_.axes[i] * snapped(local[i], snap.metres, input.snap);
            break;
        }
        case Tool::Rotate:
            out.axis = rotationAxis();
            out.angle =
                degreesToRadians(snapped(radiansToDegrees(angle(at)), snap.degrees, input.snap));
            break;
        case Tool::Scale: {
            const double f = snapped(factor(at), snap.factor, input.snap);
            // A factor of 0 would make things vanish for good.
            return scaledBy(std::abs(f) < 1e-3 ? std::copysign(1e-3, f) : f);
        }
    }
    return out;
}

GizmoChange GizmoDrag::typed(double number) const {
    GizmoChange out;
    if (tool_ == Tool::Move) {
        const auto axis = axisOf(handle_);
        out.translation = (axis ? frame_.axes[*axis] : view_.axes().right) * number;
    } else if (tool_ == Tool::Rotate) {
        out.axis = rotationAxis();
        out.angle = degreesToRadians(number);
    } else if (tool_ == Tool::Scale && number != 0) {
        return scaledBy(number);
    }
    return out;
}

DVec3 GizmoDrag::translation(const QPointF& at) const {
    if (const auto axis = axisOf(handle_)) {
        const DVec3& direction = frame_.axes[*axis];
        const double from = nearestOnAxis(view_.ray(start_), frame_.origin, direction);
        return direction * (nearestOnAxis(view_.ray(at), frame_.origin, direction) - from);
    }
    const auto across = planeNormalOf(handle_);
    const DVec3 normal = across ? frame_.axes[*across] : view_.axes().forward;
    const auto from = onPlane(view_.ray(start_), frame_.origin, normal),
               to = onPlane(view_.ray(at), frame_.origin, normal);
    return from && to ? *to - *from : DVec3(0.0);
}

DVec3 GizmoDrag::rotationAxis() const {
    const auto axis = axisOf(handle_);
    return axis ? frame_.axes[*axis] : view_.towardsViewer(frame_.origin);
}

double GizmoDrag::angle(const QPointF& at) const {
    const auto center = view_.project(frame_.origin);
    if (!center) return 0;
    const DVec3 axis = rotationAxis();
    const double facing = glm::dot(axis, view_.towardsViewer(frame_.origin));
    if (std::abs(facing) < kFlatRing) {
        // Edge on: along the line that the ring has become.
        const auto tip = view_.project(frame_.origin + axis * worldLength(view_, frame_));
        const QPointF along = tip ? *tip - *center : QPointF(0, -1);
        const QPointF tangent(-along.y(), along.x());
        const double length = std::hypot(tangent.x(), tangent.y());
        return length > 0 ? QPointF::dotProduct(at - start_, tangent) / length / kGizmoLength : 0;
    }
    const QPointF a = start_ - *center, b = at - *center;
    // The screen's y points down: an angle that grows clockwise there is negative about an axis
    // towards the viewer.
    const double turn = std::atan2(a.x() * b.y() - a.y() * b.x(), QPointF::dotProduct(a, b));
    return facing > 0 ? -turn : turn;
}

double GizmoDrag::factor(const QPointF& at) const {
    if (const auto axis = axisOf(handle_)) {
        const DVec3& direction = frame_.axes[*axis];
        const double from = nearestOnAxis(view_.ray(start_), frame_.origin, direction);
        return from != 0 ? nearestOnAxis(view_.ray(at), frame_.origin, direction) / from : 1;
    }
    const QPointF d = at - start_;
    return std::pow(2.0, (d.x() - d.y()) / 100);
}

GizmoChange GizmoDrag::scaledBy(double f) const {
    GizmoChange out;
    const auto axis = axisOf(handle_);
    if (axis)
        out.scale[*axis] = f;
    else
        out.scale = DVec3(f);
    return out;
}

}  // namespace glint
