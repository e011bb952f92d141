// A cylinder or cone as seen from a point outside: its side (MantleView) and at most one flat face
// (DiskView), chosen by the solid angles that they nearly have.
#pragma once

#include <optional>

#include "tracer/shapes/crossing.h"
#include "tracer/shapes/disk_view.h"
#include "tracer/shapes/mantle_view.h"

namespace glint {

/// What is in view; nothing from inside. `Side` knows the lines of the side: width(line) is the
/// solid angle of a line's half-plane over its angle, place(line, u) the point in the shape's space
/// before which the share `u` of that lies.
template <class Side>
class RoundView {
  public:
    RoundView(const Viewpoint& view, const Side& side, std::optional<MantleView> mantle,
              std::optional<DiskView> face)
        : view_(view), side_(side), mantle_(mantle), face_(face) {
        if (mantle_) {
            mantle_->weigh([&](const MantleView::Generator& line) { return side_.width(line); });
            ofSide_ = mantle_->solidAngle();
        }
        if (face_) ofFace_ = face_->solidAngle();
    }

    /// From inside: all directions.
    [[nodiscard]] DirectionSample sample(const DVec2& u) const {
        const double total = ofSide_ + ofFace_, pick = u.x * total;
        if (!(total > 0)) {
            const DVec3 d = uniformSphere(u);
            return {d, view_.worldDensity(d, kUniformSpherePdf)};
        }
        if (pick < ofSide_) {
            const MantleView::Generator line = mantle_->sample(pick / ofSide_);
            return view_.towards(side_.place(line, u.y), sidePdf(line));
        }
        const DiskView::Sample s = face_->sample({std::min((pick - ofSide_) / ofFace_, 1.0), u.y});
        return view_.towards(s.point, ofFace_ / total * s.pdf);
    }
    /// The density of sample() towards `d`, which meets `shape` in `span`.
    template <class Shape>
    [[nodiscard]] double pdf(const Shape& shape, const Span& span, const DVec3& d) const {
        const double total = ofSide_ + ofFace_;
        if (!(total > 0)) return view_.worldDensity(d, kUniformSpherePdf);
        if (span.empty()) return 0;
        if (span.face0 == 0) return mantle_ ? sidePdf(mantle_->met(view_.worldFromLocal * d)) : 0;
        const DVec3 p = shape.project(view_.origin + span.t0 * d, span.face0);
        return face_ ? ofFace_ / total * face_->pdf(p) : 0;
    }

  private:
    [[nodiscard]] double sidePdf(const MantleView::Generator& line) const {
        const double width = side_.width(line);
        return width > 0 ? ofSide_ / (ofSide_ + ofFace_) * line.pdf / width : 0;
    }

    const Viewpoint& view_;
    Side side_;
    std::optional<MantleView> mantle_;
    std::optional<DiskView> face_;
    double ofSide_ = 0, ofFace_ = 0;  ///< solid angles, nearly
};

}  // namespace glint
