#include "tracer/math/ball_chain.h"

#include <algorithm>
#include <cmath>

namespace glint {

namespace {

/// h at an angle of incidence, and its derivative.
struct Turn {
    double h, slope;
};
Turn turnAt(const ChainEnds& ends, double n, int chords, double sine, double cosine, double angle) {
    const auto along = [&](double s) {
        return DVec2(std::asin(s * sine), s * cosine / std::sqrt(1 - s * s * sine * sine));
    };
    const DVec2 x = along(ends.sx), y = ends.sy > 0 ? along(ends.sy) : DVec2(0.0);
    const DVec2 inside = chords > 0 ? 2.0 * chords * along(1 / n) : DVec2(0.0);
    return {2 * angle - x.x - y.x - inside.x, 2 - x.y - y.y - inside.y};
}

/// Newton's method from `start`, which lies on the side of the root where all steps go one way.
/// False: there is no root, which shows when the slope changes its sign.
bool solve(const ChainEnds& ends, double n, int chords, double target, double start,
           BallChain& out) {
    constexpr int kMaxSteps = 40;
    constexpr double kTolerance =
        1e-9;  // Convergence is quadratic: after such a step the error is 1e-17 but at folds.
    double angle = start, rising = 0;
    for (int step = 0; step < kMaxSteps; ++step) {
        if (!(angle >= 0 && angle <= kPi / 2 + kTolerance)) return false;
        const double sine = std::sin(angle), cosine = std::max(0.0, std::cos(angle));
        const Turn turn = turnAt(ends, n, chords, sine, cosine, angle);
        if (turn.slope == 0 || turn.slope * rising < 0) return false;
        rising = turn.slope;
        const double move = (turn.h - target) / turn.slope;
        angle -= move;
        if (std::abs(move) <= kTolerance) {
            angle = std::clamp(angle, 0.0, kPi / 2);
            out.sine = std::sin(angle);
            out.cosine = std::max(0.0, std::cos(angle));
            out.first = angle - std::asin(ends.sx * out.sine);
            return true;
        }
    }
    return false;
}

}  // namespace

int findBallChains(const ChainEnds& ends, double n, int chords,
                   std::array<BallChain, kMaxBallChains>& out) {
    const double theta = std::atan2(ends.sine, ends.cosine);
    const double atZero = 2 - ends.sx - ends.sy - 2 * chords / n * (chords > 0 ? 1 : 0);
    const double atRight = turnAt(ends, n, chords, 1, 0, kPi / 2).h;
    int count = 0;
    const auto find = [&](double target, double side) {
        // From the right: h lies above its tangents at both ends, whose slopes are 2 and atZero.
        if (target <= atRight && (target > 0 || atZero < 0)) {
            double start = kPi / 2 - 0.5 * (atRight - target);
            if (atZero > 0) start = std::min(start, target / atZero);
            BallChain& chain = out[static_cast<std::size_t>(count)];
            if (solve(ends, n, chords, target, start, chain)) chain.side = side, ++count;
        }
        if (target < 0 && atZero < 0 && target / atZero < kPi / 2) {
            BallChain& chain = out[static_cast<std::size_t>(count)];
            if (solve(ends, n, chords, target, target / atZero, chain)) chain.side = side, ++count;
        }
    };
    switch (chords) {
        case 0:
            find(theta, 1);
            break;
        case 1:
            find(theta - kPi, 1);
            find(kPi - theta, -1);
            break;
        default:
            find(theta, 1);
            find(-theta, -1);
            find(theta - 2 * kPi, 1);  // Once round: h is above -2 pi.
            break;
    }
    return count;
}

double ballChainSpread(const ChainEnds& ends, double n, int chords, double sine, double cosine) {
    const auto root = [&](double s) { return std::sqrt(std::max(0.0, 1 - s * s * sine * sine)); };
    const double rootX = root(ends.sx), rootY = root(ends.sy);
    double slope = 2 - ends.sx * cosine / rootX - ends.sy * cosine / rootY;
    if (chords > 0) slope -= 2 * chords * cosine / (n * root(1 / n));
    slope = std::abs(slope);
    // On the axis both sines go to 0 together, in the ratio of the slope.
    constexpr double kOnAxis = 1e-7;
    const double ratio = ends.sine < kOnAxis && sine < kOnAxis ? 1 / slope : sine / ends.sine;
    const double perAngle = ratio * cosine * ends.sx * ends.sx / (rootX * slope);
    return ends.sy > 0 ? perAngle * ends.sy * ends.sy / rootY : perAngle;
}

}  // namespace glint
