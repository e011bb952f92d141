// A rectangular lamp as seen from a point: directions drawn nearly in proportion to the light that
// they bring. From afar the density is the four corners' cos / r^2, blended bilinearly, so that the
// solid angle with its arc functions is not needed; from close by it is uniform in the solid angle.
// Both in render space: a long lamp is sampled as evenly as a square one.
#pragma once

#include <array>

#include "tracer/compile/shape_lists.h"
#include "tracer/shapes/spherical_quad.h"

namespace glint {

/// Area of a quad or disk in render space [m^2]; 0 for any other shape.
[[nodiscard]] inline double flatArea(const ShapeInstance& shape) {
    const double sides = glm::length(glm::cross(shape.worldFromLocal[2], shape.worldFromLocal[0]));
    if (std::holds_alternative<CanonicalQuad>(shape.shape)) return 4 * sides;
    return std::holds_alternative<CanonicalDisk>(shape.shape) ? kPi * sides : 0;
}

class QuadLight {
  public:
    /// `quad` passes isRectangle().
    QuadLight(const ShapeInstance& quad, const DVec3& from)
        : quad_(quad),
          x_(quad.worldFromLocal[0]),
          y_(quad.worldFromLocal[2]),
          toCenter_(quad.center - from) {
        const DMat3& m = quad.localFromWorld;
        normal_ = glm::normalize(
            DVec3(m[0][1], m[1][1], m[2][1]));  // Of the inverse transpose, as in surfacePoint().
        height_ = glm::dot(toCenter_, normal_);
        const double x2 = glm::dot(x_, x_), y2 = glm::dot(y_, y_),
                     d2 = glm::dot(toCenter_, toCenter_);
        isFar_ = d2 >= kFar * (x2 + y2);
        area_ = 4 * std::sqrt(x2 * y2);
        if (isFar_) weighCorners();
    }

    /// The point is on the side that the quad's normal points to.
    [[nodiscard]] bool seenFromFront() const { return height_ < 0; }

    struct Sample {
        DVec3 direction{0.0};
        double distance = 0, pdf = 0;  ///< density per solid angle; 0: no sample
    };
    [[nodiscard]] Sample sample(const DVec2& u) const {
        if (height_ == 0) return {};
        return isFar_ ? sampleCorners(u) : sampleSolidAngle(u);
    }
    /// The density of sample() towards `direction`, which meets the quad.
    [[nodiscard]] double pdf(const DVec3& direction) const {
        if (height_ == 0) return 0;
        if (!isFar_) return solidAngle().pdf(inFrame(direction));
        const double cosine = glm::dot(direction, normal_), t = height_ / cosine;
        const DVec3 local = quad_.localVector(t * direction - toCenter_);
        const auto unit = [](double v) { return std::clamp(0.5 * v + 0.5, 0.0, 1.0); };
        return cornersPdf({unit(local.x), unit(local.z)}, t * t, std::abs(cosine));
    }

  private:
    /// Far: from twice the half diagonal on. There cos / r^2 lies within a sixth of the corners'
    /// blend.
    static constexpr double kFar = 4;

    void weighCorners() {
        for (std::size_t i = 0; i < 4; ++i) {
            const DVec3 p = toCenter_ + (i & 1 ? x_ : -x_) + (i & 2 ? y_ : -y_);
            const double r2 = glm::dot(p, p);
            weight_[i] =
                1 / (r2 * std::sqrt(r2));  // The cosine is height / r, of the same height for all.
        }
        sum_ = weight_[0] + weight_[1] + weight_[2] + weight_[3];
    }
    [[nodiscard]] double cornersPdf(const DVec2& place, double distance2, double cosine) const {
        const double lower = weight_[0] + place.x * (weight_[1] - weight_[0]);
        const double upper = weight_[2] + place.x * (weight_[3] - weight_[2]);
        return 4 * (lower + place.y * (upper - lower)) / sum_ * distance2 / (cosine * area_);
    }
    [[nodiscard]] Sample sampleCorners(const DVec2& u) const {
        const double b = invertLinearDensity(u.y, weight_[0] + weight_[1], weight_[2] + weight_[3]);
        const double a = invertLinearDensity(u.x, weight_[0] + b * (weight_[2] - weight_[0]),
                                             weight_[1] + b * (weight_[3] - weight_[1]));
        const DVec3 p = toCenter_ + (2 * a - 1) * x_ + (2 * b - 1) * y_;
        const double r2 = glm::dot(p, p), r = std::sqrt(r2);
        return {p / r, r, cornersPdf({a, b}, r2, std::abs(height_) / r)};
    }

    /// In the quad's own axes.
    [[nodiscard]] SphericalQuad solidAngle() const {
        const double x = glm::length(x_), y = glm::length(y_);
        const double cx = glm::dot(toCenter_, x_) / x, cy = glm::dot(toCenter_, y_) / y;
        return {cx - x, cy - y, cx + x, cy + y, height_};
    }
    [[nodiscard]] DVec3 inFrame(const DVec3& d) const {
        return {glm::dot(d, x_) / glm::length(x_), glm::dot(d, y_) / glm::length(y_),
                glm::dot(d, normal_)};
    }
    [[nodiscard]] Sample sampleSolidAngle(const DVec2& u) const {
        const DirectionSample s = solidAngle().sample(u);
        if (!(s.pdf > 0)) return {};
        const DVec3 direction = s.direction.x / glm::length(x_) * x_ +
                                s.direction.y / glm::length(y_) * y_ + s.direction.z * normal_;
        return {direction, height_ / s.direction.z, s.pdf};
    }

    const ShapeInstance& quad_;
    DVec3 x_, y_, toCenter_, normal_{0.0};  ///< half edges; unit normal
    double area_ = 0, height_ = 0;  ///< height_: of the quad over the point, along its normal
    bool isFar_ = false;
    std::array<double, 4> weight_{};
    double sum_ = 0;
};

/// Whether a quad's edges are perpendicular, as QuadLight wants them.
[[nodiscard]] inline bool isRectangle(const ShapeInstance& instance) {
    if (!std::holds_alternative<CanonicalQuad>(instance.shape)) return false;
    const DVec3 x = instance.worldFromLocal[0], y = instance.worldFromLocal[2];
    return std::abs(glm::dot(x, y)) <= 1e-12 * glm::length(x) * glm::length(y);
}

}  // namespace glint
