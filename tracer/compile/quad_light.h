// A rectangular lamp as seen from a point: directions drawn nearly in proportion to the light that
// they bring. From afar the density goes linearly from edge to edge, so that the solid angle with
// its arc functions is not needed; from close by it is uniform in the solid angle.
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

/// Whether a quad's edges are perpendicular.
[[nodiscard]] inline bool isRectangle(const ShapeInstance& instance) {
    if (!std::holds_alternative<CanonicalQuad>(instance.shape)) return false;
    const DVec3 x = instance.worldFromLocal[0], y = instance.worldFromLocal[2];
    return std::abs(glm::dot(x, y)) <= 1e-12 * glm::length(x) * glm::length(y);
}

/// What of a rectangular lamp does not depend on the point that sees it.
struct LampRectangle {
    /// `quad` passes isRectangle().
    explicit LampRectangle(const ShapeInstance& quad)
        : center(quad.center),
          x(quad.worldFromLocal[0]),
          y(quad.worldFromLocal[2]),
          normal(glm::normalize(DVec3(0, 1, 0) * quad.localFromWorld)),  // (M^-1)^T n
          halfX(glm::length(x)),
          halfY(glm::length(y)) {}
    DVec3 center, x, y, normal;  ///< half edges [m]; unit normal
    double halfX, halfY;         ///< lengths of x and y [m]
};

class QuadLight {
  public:
    QuadLight(const LampRectangle& lamp, const DVec3& from)
        : lamp_(lamp), toCenter_(lamp.center - from), height_(glm::dot(toCenter_, lamp.normal)) {}

    /// The point is on the side that the quad's normal points to.
    [[nodiscard]] bool seenFromFront() const { return height_ < 0; }

    struct Sample {
        DVec3 direction{0.0};
        double distance = 0, pdf = 0;  ///< density per solid angle; 0: no sample
    };
    [[nodiscard]] Sample sample(const DVec2& u) const {
        if (height_ == 0) return {};
        return isFar() ? sampleEdges(Vec2(u)) : sampleSolidAngle(u);
    }
    /// The density of sample() towards `direction`, which meets the quad.
    [[nodiscard]] double pdf(const DVec3& direction) const {
        if (height_ == 0) return 0;
        if (!isFar()) return solidAngle().pdf(inFrame(direction));
        const double t = height_ / glm::dot(direction, lamp_.normal);
        const DVec3 p = t * direction - toCenter_;
        const auto place = [&](const DVec3& axis, double half) {
            return static_cast<float>(
                std::clamp(0.5 * glm::dot(p, axis) / (half * half) + 0.5, 0.0, 1.0));
        };
        return Edges(*this).pdf({place(lamp_.x, lamp_.halfX), place(lamp_.y, lamp_.halfY)}, t);
    }

  private:
    /// Far: from twice the half diagonal on. There cos / r^2 lies within a factor of 2.1 of the
    /// density.
    static constexpr double kFar = 4;

    [[nodiscard]] double distance2() const { return glm::dot(toCenter_, toCenter_); }
    [[nodiscard]] double diagonal2() const {
        return lamp_.halfX * lamp_.halfX + lamp_.halfY * lamp_.halfY;
    }
    [[nodiscard]] bool isFar() const { return distance2() >= kFar * diagonal2(); }

    /// What the middles of the edges see of the light, of which cos / r^2 has r^-3 because the
    /// cosine is height / r, of the same height for all.
    struct Edges {
        explicit Edges(const QuadLight& light) {
            const LampRectangle& lamp = light.lamp_;
            const double inverse = 1 / light.distance2();
            const auto along = [&](const DVec3& axis) {
                return static_cast<float>(2 * glm::dot(light.toCenter_, axis) * inverse);
            };
            const auto middle = [&](double half) {
                return static_cast<float>(1 + half * half * inverse);
            };
            const float x = along(lamp.x), y = along(lamp.y), x2 = middle(lamp.halfX),
                        y2 = middle(lamp.halfY);
            weight = {x2 - x, x2 + x, y2 - y, y2 + y};  // (r / distance)^2
            for (float& w : weight) w = 1 / (w * std::sqrt(w));
            const auto sum = static_cast<double>((weight[0] + weight[1]) * (weight[2] + weight[3]));
            scale = 1 / (sum * lamp.halfX * lamp.halfY * std::abs(light.height_));
        }
        /// Density per solid angle at a place on the lamp, both in [0, 1], at `distance`.
        [[nodiscard]] double pdf(const Vec2& place, double distance) const {
            const float x = weight[0] + place.x * (weight[1] - weight[0]),
                        y = weight[2] + place.y * (weight[3] - weight[2]);
            return static_cast<double>(x * y) * scale * (distance * distance * distance);
        }
        std::array<float, 4> weight;  ///< at -x, x, -y and y
        double scale;
    };
    [[nodiscard]] Sample sampleEdges(const Vec2& u) const {
        const Edges edges(*this);
        const auto& w = edges.weight;
        const float a = invertLinearDensity(u.x, w[0], w[1]),
                    b = invertLinearDensity(u.y, w[2], w[3]);
        const DVec3 p = toCenter_ + (2 * static_cast<double>(a) - 1) * lamp_.x +
                        (2 * static_cast<double>(b) - 1) * lamp_.y;
        const double r = glm::length(p);
        return {p * (1 / r), r, edges.pdf({a, b}, r)};
    }

    /// In the lamp's own axes.
    [[nodiscard]] SphericalQuad solidAngle() const {
        const double cx = glm::dot(toCenter_, lamp_.x) / lamp_.halfX,
                     cy = glm::dot(toCenter_, lamp_.y) / lamp_.halfY;
        return {cx - lamp_.halfX, cy - lamp_.halfY, cx + lamp_.halfX, cy + lamp_.halfY, height_};
    }
    [[nodiscard]] DVec3 inFrame(const DVec3& d) const {
        return {glm::dot(d, lamp_.x) / lamp_.halfX, glm::dot(d, lamp_.y) / lamp_.halfY,
                glm::dot(d, lamp_.normal)};
    }
    [[nodiscard]] Sample sampleSolidAngle(const DVec2& u) const {
        const DirectionSample s = solidAngle().sample(u);
        if (!(s.pdf > 0)) return {};
        const DVec3 direction = s.direction.x / lamp_.halfX * lamp_.x +
                                s.direction.y / lamp_.halfY * lamp_.y +
                                s.direction.z * lamp_.normal;
        return {direction, height_ / s.direction.z, s.pdf};
    }

    const LampRectangle& lamp_;
    DVec3 toCenter_;
    double height_;  ///< of the lamp over the point, along its normal [m]
};

}  // namespace glint
