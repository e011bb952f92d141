#include "gui/viewport/projection.h"

#include <algorithm>
#include <cmath>

namespace glint {

CameraAxes cameraAxes(const Camera& camera) {
    const DVec3 view = camera.target - camera.position;
    const DVec3 side = glm::cross(view, camera.up);
    if (!(glm::length(view) > 0) || !(glm::length(side) > 0)) return {};
    const DVec3 forward = glm::normalize(view), right = glm::normalize(side);
    return {right, glm::cross(right, forward), forward};
}

Camera fittedCamera(Camera camera, const FilmSettings& film, double width, double height) {
    const double narrower =
        static_cast<double>(film.width) / film.height * height / std::max(1.0, width);
    if (!(narrower > 1)) return camera;
    // The film's width must fit: see more above and below.
    const double halfTan = std::tan(degreesToRadians(camera.verticalFovDegrees) / 2) * narrower;
    camera.verticalFovDegrees = radiansToDegrees(2 * std::atan(halfTan));
    camera.orthoHeight *= narrower;
    return camera;
}

ViewProjection::ViewProjection(const Camera& camera, double width, double height)
    : axes_(cameraAxes(camera)),
      position_(camera.position),
      perspective_(camera.projection == Projection::Perspective),
      halfHeight_(perspective_ ? std::tan(degreesToRadians(camera.verticalFovDegrees) / 2)
                               : camera.orthoHeight / 2),
      width_(std::max(1.0, width)),
      height_(std::max(1.0, height)) {}

std::optional<QPointF> ViewProjection::project(const DVec3& point) const {
    const DVec3 d = point - position_;
    const double z = glm::dot(d, axes_.forward);
    // Nearer points would fall far outside any screen.
    constexpr double kNearest = 1e-6;
    if (perspective_ && z < kNearest) return std::nullopt;
    const double scale = height_ / 2 / (halfHeight_ * (perspective_ ? z : 1));
    return QPointF(width_ / 2 + glm::dot(d, axes_.right) * scale,
                   height_ / 2 - glm::dot(d, axes_.up) * scale);
}

ViewRay ViewProjection::ray(const QPointF& pixel) const {
    const double scale = halfHeight_ / (height_ / 2);
    const DVec3 offset = axes_.right * ((pixel.x() - width_ / 2) * scale) -
                         axes_.up * ((pixel.y() - height_ / 2) * scale);
    if (perspective_) return {position_, glm::normalize(axes_.forward + offset)};
    return {position_ + offset, axes_.forward};
}

double ViewProjection::metresPerPixel(const DVec3& point) const {
    const double z = perspective_ ? std::max(1e-9, depth(point)) : 1;
    return halfHeight_ * z / (height_ / 2);
}

DVec3 ViewProjection::towardsViewer(const DVec3& point) const {
    const DVec3 d = position_ - point;
    return perspective_ && glm::length(d) > 0 ? glm::normalize(d) : -axes_.forward;
}

}  // namespace glint
