// Uniform sampling of the solid angle of an axis-aligned rectangle.
// Source: Urena, Fajardo, King, "An Area-Preserving Parametrization for Spherical Rectangles", EGSR
// 2013; the solid angle itself by Van Oosterom and Strackee (IEEE Trans. Biomed. Eng. 30(2), 1983),
// which has no cancellation.
#pragma once

#include <algorithm>

#include "tracer/math/warp.h"

namespace glint {

/// The rectangle [x0,x1] x [y0,y1] in the plane z = z0 as seen from the origin. z0 may have either
/// sign.
class SphericalQuad {
  public:
    SphericalQuad(double x0, double y0, double x1, double y1, double z0)
        : x0_(x0), y0_(y0), x1_(x1), y1_(y1), z0_(z0) {
        const DVec3 a(x0, y0, z0), b(x1, y0, z0), c(x1, y1, z0), d(x0, y1, z0);
        solidAngle_ = triangleSolidAngle(a, b, c) + triangleSolidAngle(a, c, d);
    }

    [[nodiscard]] double solidAngle() const { return solidAngle_; }

    /// Density of sample() towards `direction`, which must hit the rectangle.
    [[nodiscard]] double pdf(const DVec3& direction) const {
        if (!(solidAngle_ > 0)) return 0;
        if (solidAngle_ >= kByArea) return 1 / solidAngle_;
        const double t = z0_ / direction.z;
        return t * t / (area() * std::abs(direction.z));
    }

    [[nodiscard]] DirectionSample sample(const DVec2& u) const {
        if (!(solidAngle_ > 0)) return {};
        const DVec3 p = solidAngle_ >= kByArea
                            ? samplePoint(u)
                            : DVec3(glm::mix(x0_, x1_, u.x), glm::mix(y0_, y1_, u.y), z0_);
        const DVec3 direction = p / glm::length(p);
        return {direction, pdf(direction)};
    }

  private:
    /// Below this solid angle [sr] the angles of the parametrization lose digits: sample by area,
    /// where nearly uniform anyway.
    static constexpr double kByArea = 1e-7;

    [[nodiscard]] double area() const { return (x1_ - x0_) * (y1_ - y0_); }

    static double triangleSolidAngle(const DVec3& a, const DVec3& b, const DVec3& c) {
        const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
        // a . (b x c) with the edges taken first: exact for small triangles far away.
        const double volume = std::abs(glm::dot(a, glm::cross(b - a, c - a)));
        const double denominator =
            la * lb * lc + glm::dot(a, b) * lc + glm::dot(a, c) * lb + glm::dot(b, c) * la;
        return 2 * std::atan2(volume, denominator);
    }

    [[nodiscard]] DVec3 samplePoint(const DVec2& u) const {
        const double z = -std::abs(z0_), z2 = z * z;
        const auto edge = [&](double c) { return std::sqrt(z2 + c * c); };
        // Unit normals of the planes through the origin and the four edges: only their z and one
        // other entry are not 0.
        const double n0z = -y0_ / edge(y0_), n2z = y1_ / edge(y1_), n3z = -x0_ / edge(x0_);
        const auto angle = [](double cosine) { return std::acos(std::clamp(cosine, -1.0, 1.0)); };
        const double g2 = angle(-n2z * n3z), g3 = angle(-n3z * n0z);
        const double k = 2 * kPi - g2 - g3;

        // Choose the vertical great circle that cuts off the share u.x of the solid angle.
        const double au = u.x * solidAngle_ + k;
        const double fu = (std::cos(au) * n0z - n2z) / std::sin(au);
        const double cu =
            std::clamp(std::copysign(1 / std::sqrt(fu * fu + n0z * n0z), fu), -1.0, 1.0);
        const double xu =
            std::clamp(-(cu * z) / std::sqrt(std::max(1e-300, 1 - cu * cu)), x0_, x1_);

        // Then the height along it.
        const double d2 = xu * xu + z2;
        const double h0 = y0_ / std::sqrt(d2 + y0_ * y0_), h1 = y1_ / std::sqrt(d2 + y1_ * y1_);
        const double h = glm::mix(h0, h1, u.y), h2 = h * h;
        const double yv = h2 < 1 ? std::clamp(h * std::sqrt(d2 / (1 - h2)), y0_, y1_) : y1_;
        return {xu, yv, z0_};
    }

    double x0_, y0_, x1_, y1_, z0_, solidAngle_;
};

}  // namespace glint
