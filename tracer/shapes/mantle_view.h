// The side of a cylinder or cone as seen from a point outside: directions that are even in the
// angle about the axis, or about the line to the apex. Every straight line of the side fills a
// half-plane through that line, so nothing grows without bound where the side turns away.
#pragma once

#include "tracer/math/frame.h"
#include "tracer/math/linear_density.h"
#include "tracer/shapes/viewpoint.h"

namespace glint {

/// A circle of the side, c + sin(phi) u + cos(phi) v, in the plane across the line that one looks
/// along, with the looking point at the origin.
class MantleView {
  public:
    /// One straight line of the side.
    struct Generator {
        double sine = 0, cosine = 1;  ///< of phi
        DVec2 point{0.0};             ///< of the circle
        double pdf = 0;
    };

    /// `line`: unit vector of the world along the axis, or to the apex. `height`: of the circle in
    /// the shape's space. `halfAngle`: of the arc in view, which lies about the point's own angle;
    /// pi where all of it is in view.
    MantleView(const DVec3& line, const DVec3& circleCenter, const Viewpoint& view,
               double halfAngle)
        : frame_(line),
          center_(flat(circleCenter)),
          u_(flat(view.worldFromLocal[0])),
          v_(flat(view.worldFromLocal[2])) {
        const double r = axisDistance(view.origin);
        const double sine = r > 0 ? view.origin.x / r : 0, cosine = r > 0 ? view.origin.z / r : 1;
        middle_ = {sine, cosine};
        if (halfAngle >= kPi) {
            begin_ = circle(sine, cosine);
            range_ = 2 * kPi;
            return;
        }
        isArc_ = true;
        const double s = std::sin(halfAngle), c = std::cos(halfAngle);
        const DVec2 middle = circle(sine, cosine);
        begin_ = circle(sine * c - cosine * s, cosine * c + sine * s);
        range_ = angle(begin_, middle) +
                 angle(middle, circle(sine * c + cosine * s, cosine * c - sine * s));
    }

    /// Has sample() choose lines of the side by what `width` says that their half-planes hold:
    /// solid angle over angle about the line one looks along. Must be called first.
    template <class Width>
    void weigh(const Width& width) {
        density_ = LinearDensity<kSteps>([&](double s) { return width(at(s)); });
    }
    /// Of the side, nearly.
    [[nodiscard]] double solidAngle() const { return std::abs(range_) * density_.integral(); }
    /// A line of the side, and its density over the angle about the line one looks along.
    [[nodiscard]] Generator sample(double u) const { return withPdf(density_.sample(u)); }
    /// The same for the line of the side that the world's direction `d` meets.
    [[nodiscard]] Generator met(const DVec3& d) const {
        const DVec2 to = flat(d);
        double turn = angle(begin_, to);
        if (turn * range_ < 0) turn = isArc_ ? 0 : turn + std::copysign(2 * kPi, range_);
        return withPdf(turn / range_);
    }

  private:
    [[nodiscard]] DVec2 flat(const DVec3& v) const {
        return {glm::dot(v, frame_.s), glm::dot(v, frame_.t)};
    }
    [[nodiscard]] DVec2 circle(double sine, double cosine) const {
        return center_ + sine * u_ + cosine * v_;
    }
    static double cross(const DVec2& a, const DVec2& b) { return a.x * b.y - a.y * b.x; }
    static double angle(const DVec2& a, const DVec2& b) {
        return std::atan2(cross(a, b), glm::dot(a, b));
    }

    [[nodiscard]] Generator at(double s) const {
        const double turn = range_ * s, sine = std::sin(turn), cosine = std::cos(turn);
        return towards({cosine * begin_.x - sine * begin_.y, sine * begin_.x + cosine * begin_.y});
    }
    [[nodiscard]] Generator withPdf(double s) const {
        Generator out = at(s);
        out.pdf = density_.density(s) / std::abs(range_);
        return out;
    }
    /// Of the two places where the circle is met along `d`, the one in view: cross(d, circle) = 0.
    [[nodiscard]] Generator towards(const DVec2& d) const {
        const double a = cross(d, u_), b = cross(d, v_), length = std::hypot(a, b);
        if (!(length > 0)) return {};
        const double k = std::clamp(-cross(d, center_) / length, -1.0, 1.0),
                     w = std::sqrt(1 - k * k);
        const auto place = [&](double root) {
            const double sine = (k * a + root * b) / length, cosine = (k * b - root * a) / length;
            return Generator{sine, cosine, circle(sine, cosine)};
        };
        const Generator one = place(w), other = place(-w);
        const auto rank = [&](const Generator& g) {
            return isArc_ ? g.sine * middle_.x + g.cosine * middle_.y : glm::dot(d, g.point);
        };
        return rank(one) >= rank(other) ? one : other;
    }

    static constexpr std::size_t kSteps = 8;

    Frame frame_;
    DVec2 center_, u_, v_, middle_{0.0}, begin_{0.0};
    double range_ = 0;
    bool isArc_ = false;
    LinearDensity<kSteps> density_;  ///< over the range
};

}  // namespace glint
