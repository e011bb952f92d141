#include "gui/viewport/navigation.h"

#include <algorithm>
#include <cmath>

#include "gui/viewport/projection.h"

namespace glint {

namespace {

/// The view stays at least this far from straight up and down, radians.
constexpr double kPoleMargin = 0.02;

DVec3 rotatedAbout(const DVec3& v, const DVec3& axis, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return v * c + glm::cross(axis, v) * s + axis * glm::dot(axis, v) * (1 - c);
}

/// The part of `pitch` that keeps the view off the poles.
double allowedPitch(const Camera& camera, double pitch) {
    const DVec3 up = glm::normalize(camera.up);
    const double elevation =
        std::asin(std::clamp(glm::dot(cameraAxes(camera).forward, up), -1.0, 1.0));
    const double limit = kPi / 2 - kPoleMargin;
    return std::clamp(elevation + pitch, std::min(-limit, elevation), std::max(limit, elevation)) -
           elevation;
}

}  // namespace

Camera orbited(Camera camera, const DVec3& pivot, double yaw, double pitch) {
    const DVec3 up = glm::normalize(camera.up), right = cameraAxes(camera).right;
    const double pitched = allowedPitch(camera, pitch);
    const auto rotate = [&](const DVec3& p) {
        return pivot + rotatedAbout(rotatedAbout(p - pivot, right, pitched), up, yaw);
    };
    camera.position = rotate(camera.position);
    camera.target = rotate(camera.target);
    return camera;
}

Camera turned(Camera camera, double yaw, double pitch) {
    return orbited(camera, camera.position, yaw, pitch);
}

Camera moved(Camera camera, const DVec3& rightUpForward) {
    const CameraAxes axes = cameraAxes(camera);
    const DVec3 step = axes.right * rightUpForward.x + axes.up * rightUpForward.y +
                       axes.forward * rightUpForward.z;
    camera.position += step;
    camera.target += step;
    return camera;
}

Camera dollied(Camera camera, const DVec3& point, double factor) {
    if (camera.projection == Projection::Orthographic) {
        // Scale the picture about the point: the centre moves towards it within the image plane.
        const CameraAxes axes = cameraAxes(camera);
        const DVec3 offset = point - camera.position;
        const DVec3 inPlane = offset - axes.forward * glm::dot(offset, axes.forward);
        camera.orthoHeight *= factor;
        camera.position += inPlane * (1 - factor);
        camera.target += inPlane * (1 - factor);
        return camera;
    }
    const DVec3 view = camera.target - camera.position;
    camera.position = point + (camera.position - point) * factor;
    camera.target = camera.position + view * factor;
    return camera;
}

Camera framed(Camera camera, const Bounds& bounds, double aspect) {
    if (bounds.isEmpty()) return camera;
    constexpr double kMargin = 1.15;
    const DVec3 forward = cameraAxes(camera).forward;
    const double radius = std::max(1e-3, bounds.radius()) * kMargin, narrow = std::min(1.0, aspect);
    const double halfAngle =
        std::atan(std::tan(degreesToRadians(camera.verticalFovDegrees) / 2) * narrow);
    const double distance = radius / std::sin(std::min(halfAngle, kPi / 2));
    camera.target = bounds.center();
    camera.position = camera.target - forward * distance;
    camera.orthoHeight = 2 * radius / narrow;
    return camera;
}

Camera lookingAlong(Camera camera, const DVec3& direction) {
    const double distance = std::max(1e-6, glm::length(camera.target - camera.position));
    const DVec3 along = glm::normalize(direction);
    camera.up = std::abs(along.y) > 0.999 ? DVec3(0, 0, along.y > 0 ? 1 : -1) : DVec3(0, 1, 0);
    camera.position = camera.target - along * distance;
    return camera;
}

Camera withProjection(Camera camera, Projection projection) {
    if (camera.projection == projection) return camera;
    const double distance = glm::length(camera.target - camera.position);
    const double halfTan = std::tan(degreesToRadians(camera.verticalFovDegrees) / 2);
    if (projection == Projection::Orthographic) {
        camera.orthoHeight = 2 * distance * halfTan;
    } else {
        const DVec3 forward = cameraAxes(camera).forward;
        camera.position = camera.target - forward * (camera.orthoHeight / (2 * halfTan));
    }
    camera.projection = projection;
    return camera;
}

}  // namespace glint
