// A disk as seen from a point: from afar uniform in its area, from close by nearly uniform in its
// solid angle. Strips across the line from the disk's middle to the foot of the point hold solid
// angle in proportion to their sines (SolidStrip) for every step of the angle under which they are
// seen; a density that is linear between a few of these angles spreads the strips.
#pragma once

#include "tracer/math/linear_density.h"
#include "tracer/shapes/solid_strip.h"
#include "tracer/shapes/viewpoint.h"

namespace glint {

/// The disk of radius 1 about the y axis at the height `y` of the shape's space.
class DiskView {
  public:
    DiskView(const Viewpoint& view, double y) : view_(view), y_(y) {
        const DVec3& o = view.origin;
        const double r = axisDistance(o);
        toFoot_ = r > 0 ? DVec2(o.x / r, o.z / r) : DVec2(1, 0);
        const DMat3& m = view.worldFromLocal;
        const DVec3 sweep = toFoot_.x * m[0] + toFoot_.y * m[2],
                    strip = toFoot_.x * m[2] - toFoot_.y * m[0];
        const DVec3 center = view.toWorld({0, y, 0});
        stripLength_ = glm::length(strip);
        slant_ = glm::dot(sweep, strip) / (stripLength_ * stripLength_);
        const DVec3 across =
            sweep - slant_ * strip;  // Perpendicular to the strips, also under shear.
        sweepLength_ = glm::length(across);
        const double areaScale = sweepLength_ * stripLength_;
        height_ = std::abs(glm::determinant(m) * (y - o.y)) / areaScale;
        if (!(height_ > 0)) return;  // In the disk's own plane there is nothing to see.
        const double d2 = glm::dot(center, center),
                     size2 = glm::dot(sweep, sweep) + stripLength_ * stripLength_;
        isNear_ = d2 < kNear * size2;
        if (!isNear_) {
            solidAngle_ = kPi * areaScale * height_ / (d2 * std::sqrt(d2));
            return;
        }
        centerX_ = glm::dot(center, across) / sweepLength_;
        centerZ_ = glm::dot(center, strip) / stripLength_;
        const double x0 = centerX_ - sweepLength_, x1 = centerX_ + sweepLength_;
        spread_ = std::atan2((x1 - x0) * height_, height_ * height_ + x0 * x1);
        density_ = LinearDensity<kSteps>([&](double s) {
            return s > 0 && s < 1 ? stripAt(placeAt(s)).sines() * std::sin(kPi * s) : 0;
        });
        solidAngle_ = density_.integral() * spread_ * kPi / 2;
    }

    /// Nearly: for choosing among the faces of a shape.
    [[nodiscard]] double solidAngle() const { return solidAngle_; }

    struct Sample {
        DVec3 point{0.0};  ///< in the shape's space
        double pdf = 0;    ///< per solid angle of the world
    };
    [[nodiscard]] Sample sample(const DVec2& u) const {
        if (!(solidAngle_ > 0)) return {};
        if (!isNear_) {
            const DVec2 q = concentricDisk(u);
            const DVec3 p(q.x, y_, q.y);
            return {p, pdf(p)};
        }
        const double s = density_.sample(u.x), x = placeAt(s);
        const SolidStrip strip = stripAt(x);
        const double half = std::sqrt(1 - x * x);
        const double z =
            std::clamp((strip.sample(u.y) - centerZ_) / stripLength_ - slant_ * x, -half, half);
        return {{toFoot_.x * x - toFoot_.y * z, y_, toFoot_.y * x + toFoot_.x * z},
                nearPdf(s, strip)};
    }
    /// The density of sample() at the place `p` of the disk, in the shape's space.
    [[nodiscard]] double pdf(const DVec3& p) const {
        if (!(solidAngle_ > 0)) return 0;
        if (!isNear_) {
            const double d = glm::length(view_.toWorld(p));
            return d * d * d / (kPi * sweepLength_ * stripLength_ * height_);
        }
        const double x = std::clamp(toFoot_.x * p.x + toFoot_.y * p.z, -1.0, 1.0);
        const double x0 = centerX_ - sweepLength_, along = centerX_ + sweepLength_ * x;
        const double turned =
            std::atan2(sweepLength_ * (1 + x) * height_, height_ * height_ + x0 * along);
        const double s = 2 / kPi * std::asin(std::sqrt(std::clamp(turned / spread_, 0.0, 1.0)));
        return nearPdf(s, stripAt(x));
    }

  private:
    /// Near: within three times the root of both half axes' squares. From there on cos / r^2 varies
    /// by a factor of 3 at most.
    static constexpr double kNear = 9;
    static constexpr std::size_t kSteps = 8;

    /// Where the strip of the parameter s in [0, 1] is, from the disk's middle towards the foot of
    /// the point, in the disk's own units. The angle goes slowly at both ends, where strips shrink
    /// to points.
    [[nodiscard]] double placeAt(double s) const {
        const double sine = std::sin(kPi / 2 * s), turn = spread_ * sine * sine;
        const double x0 = centerX_ - sweepLength_;
        const double along = height_ * (x0 * std::cos(turn) + height_ * std::sin(turn)) /
                             (height_ * std::cos(turn) - x0 * std::sin(turn));
        return std::clamp((along - centerX_) / sweepLength_, -1.0, 1.0);
    }
    /// At the place `x` of placeAt().
    [[nodiscard]] SolidStrip stripAt(double x) const {
        const double along = centerX_ + sweepLength_ * x,
                     middle = centerZ_ + stripLength_ * slant_ * x;
        const double half = stripLength_ * std::sqrt(std::max(0.0, 1 - x * x));
        return {height_ * height_ + along * along, middle - half, middle + half};
    }
    [[nodiscard]] double nearPdf(double s, const SolidStrip& strip) const {
        const double angleSpeed = spread_ * kPi / 2 * std::sin(kPi * s), sines = strip.sines();
        return angleSpeed * sines > 0 ? density_.density(s) / (angleSpeed * sines) : 0;
    }

    Viewpoint view_;
    double y_;
    DVec2 toFoot_{1, 0};  ///< unit, in x and z of the shape's space
    double sweepLength_ = 0, stripLength_ = 0, slant_ = 0, height_ = 0;
    double centerX_ = 0,
           centerZ_ = 0;  ///< of the disk, across and along the strips, from the point
    double solidAngle_ = 0, spread_ = 0;
    bool isNear_ = false;
    LinearDensity<kSteps> density_;  ///< of the strips, over the parameter of placeAt()
};

}  // namespace glint
