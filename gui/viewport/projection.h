// ViewProjection: between the world and the pixels of a view, for a camera as the tracer sees it.
// Pure math.
#pragma once

#include <QPointF>
#include <optional>

#include "tracer/scene/scene.h"

namespace glint {

/// A ray in world space.
struct ViewRay {
    DVec3 origin{0.0};
    DVec3 direction{0.0, 0.0, -1.0};  ///< unit length
};

/// Right, up and forward of a camera in world space; orthonormal. Falls back to some axes for a
/// camera without direction.
struct CameraAxes {
    DVec3 right{1, 0, 0}, up{0, 1, 0}, forward{0, 0, -1};
};
[[nodiscard]] CameraAxes cameraAxes(const Camera& camera);

/// The camera for a view of another shape than the film: it shows at least all of the film's
/// picture.
[[nodiscard]] Camera fittedCamera(Camera camera, const FilmSettings& film, double width,
                                  double height);

class ViewProjection {
  public:
    /// A view of `width` x `height` pixels; the camera's field of view spans the full height.
    ViewProjection(const Camera& camera, double width, double height);

    /// Where a point appears, in pixels from the top left; nothing for points not in front of the
    /// camera.
    [[nodiscard]] std::optional<QPointF> project(const DVec3& point) const;
    [[nodiscard]] ViewRay ray(const QPointF& pixel) const;
    /// Length in metres that one pixel spans at the depth of `point`.
    [[nodiscard]] double metresPerPixel(const DVec3& point) const;
    /// Distance along the view axis.
    [[nodiscard]] double depth(const DVec3& point) const {
        return glm::dot(point - position_, axes_.forward);
    }
    /// From `point` towards the viewer; unit length.
    [[nodiscard]] DVec3 towardsViewer(const DVec3& point) const;
    [[nodiscard]] const CameraAxes& axes() const { return axes_; }
    [[nodiscard]] double width() const { return width_; }
    [[nodiscard]] double height() const { return height_; }

  private:
    CameraAxes axes_;
    DVec3 position_;
    bool perspective_;
    double halfHeight_;  ///< of the picture at depth 1 (perspective) or anywhere, metres
    double width_, height_;
};

}  // namespace glint
