// CameraModel: film position -> ray. Built from the document's Camera for one film size.
#pragma once

#include <optional>

#include "tracer/math/ray.h"
#include "tracer/math/ray_bundle.h"
#include "tracer/math/warp.h"
#include "tracer/scene/scene.h"

namespace glint {

class CameraModel {
  public:
    CameraModel() = default;
    /// `origin` is the world position of render space's origin.
    CameraModel(const Camera& camera, const DVec3& origin, int width, int height) {
        position_ = camera.position - origin;
        const DVec3 axis = camera.target - camera.position;
        const double distance = glm::length(axis);
        forward_ = axis / distance;
        const DVec3 right = glm::normalize(glm::cross(forward_, camera.up));
        const DVec3 up = glm::cross(right, forward_);
        orthographic_ = camera.projection == Projection::Orthographic;
        const double halfHeight = orthographic_
                                      ? camera.orthoHeight / 2
                                      : std::tan(degreesToRadians(camera.verticalFovDegrees) / 2);
        const double aspect = static_cast<double>(width) / height;
        perPixelX_ = right * (2 * halfHeight * aspect / width);
        perPixelY_ = -up * (2 * halfHeight / height);
        corner_ = right * (-halfHeight * aspect) + up * halfHeight;
        halfFilm_ = halfHeight * (aspect * absolute(right) + absolute(up));
        lensX_ = right * camera.apertureRadius;
        lensY_ = up * camera.apertureRadius;
        hasLens_ = camera.apertureRadius > 0;
        focus_ = camera.focusDistance.value_or(distance);
    }

    /// Equal ones have the same rays.
    bool operator==(const CameraModel&) const = default;

    /// The ray through film position (x, y), in pixels from the top left corner, and the middle of
    /// the lens.
    [[nodiscard]] Ray ray(double x, double y) const {
        const Ray middle = unnormalized(x, y);
        return {middle.origin, glm::normalize(middle.direction)};
    }
    /// The same through lens position u in [0, 1)^2.
    [[nodiscard]] Ray ray(double x, double y, const DVec2& u) const {
        const Ray middle = unnormalized(x, y);
        const DVec2 lens = concentricDisk(u);
        const DVec3 shift = lens.x * lensX_ + lens.y * lensY_;
        return {middle.origin + shift, glm::normalize(middle.direction - shift / focus_)};
    }

    /// What holds the rays of all film positions from (x0, y0) to (x1, y1). Nothing through a lens,
    /// whose rays spread.
    [[nodiscard]] std::optional<RayBundle> bundle(double x0, double y0, double x1,
                                                  double y1) const {
        if (hasLens_) return std::nullopt;
        const std::array corners{unnormalized(x0, y0), unnormalized(x1, y0), unnormalized(x1, y1),
                                 unnormalized(x0, y1)};
        return RayBundle(corners, unnormalized(0.5 * (x0 + x1), 0.5 * (y0 + y1)));
    }

    /// Half the box about position() in which rays start, for film positions up to `margin` pixels
    /// outside the film.
    [[nodiscard]] DVec3 reach(double margin) const {
        DVec3 out = absolute(lensX_) + absolute(lensY_);
        if (orthographic_)
            out += halfFilm_ + margin * (absolute(perPixelX_) + absolute(perPixelY_));
        return out;
    }

    [[nodiscard]] const DVec3& position() const { return position_; }
    [[nodiscard]] const DVec3& forward() const { return forward_; }
    [[nodiscard]] bool hasLens() const { return hasLens_; }

  private:
    [[nodiscard]] Ray unnormalized(double x, double y) const {
        const DVec3 offset = corner_ + x * perPixelX_ + y * perPixelY_;
        return orthographic_ ? Ray{position_ + offset, forward_}
                             : Ray{position_, forward_ + offset};
    }

    DVec3 position_{0.0}, forward_{0, 0, -1}, corner_{0.0}, halfFilm_{0.0}, perPixelX_{0.0},
        perPixelY_{0.0}, lensX_{0.0}, lensY_{0.0};
    double focus_ = 1;
    bool orthographic_ = false, hasLens_ = false;
};

}  // namespace glint
