// Real roots of a polynomial within an interval, each bracketed by the critical points and polished
// by Newton. Source: Yuksel, "High-Performance Polynomial Root Finding for Graphics", HPG 2022.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace glint {

/// Roots in ascending order.
template <int Degree>
struct Roots {
    std::array<double, Degree> at{};
    int count = 0;

    [[nodiscard]] double operator[](int i) const { return at[static_cast<std::size_t>(i)]; }
    void add(double x) { at[static_cast<std::size_t>(count++)] = x; }
};

/// A function and its derivative at one place.
struct ValueAndSlope {
    double value = 0, slope = 0;
};

/// The place in [left, right] where `f` changes sign, to within `resolution`; `negativeLeft` says
/// from which. Newton from `x`, held in the bracket by bisection; a slope that is no number only
/// costs a bisection.
template <class Function>
[[nodiscard]] double refineRoot(const Function& f, double left, double right, bool negativeLeft,
                                double x, double resolution) {
    while (right - left > resolution) {
        const ValueAndSlope at = f(x);
        ((at.value < 0) == negativeLeft ? left : right) = x;
        double next = x - at.value / at.slope;
        if (!(next > left && next < right)) next = 0.5 * (left + right);
        const double step = next - x;
        x = next;
        if (std::abs(step) <= resolution) break;
    }
    return x;
}

/// All places in [lo, hi] where `f` changes sign. `critical`: those where its direction may change,
/// so that between two of them there is one root at most. f may be any function that has the roots
/// of a polynomial of that degree or some of them, in a form that loses fewer digits than the
/// coefficients do.
template <int Degree, class Function>
[[nodiscard]] Roots<Degree> signChanges(const Roots<Degree - 1>& critical, double lo, double hi,
                                        const Function& f) {
    const double resolution =
        0x1p-53 * (hi - lo);  // Finer steps drown in the rounding of places within the interval.
    Roots<Degree> roots;
    double a = lo;
    bool negativeA = f(lo).value < 0;
    for (int i = 0; i <= critical.count; ++i) {
        const double b = i < critical.count ? critical[i] : hi;
        const bool negativeB = f(b).value < 0;
        if (negativeA != negativeB)
            roots.add(refineRoot(f, a, b, negativeA, 0.5 * (a + b), resolution));
        a = b, negativeA = negativeB;
    }
    return roots;
}

/// Roots of c[0] + c[1] x + c[2] x^2 in [lo, hi] at which it changes sign, without cancellation.
[[nodiscard]] inline Roots<2> quadraticRoots(const std::array<double, 3>& c, double lo, double hi) {
    Roots<2> roots;
    const double discriminant = c[1] * c[1] - 4 * c[0] * c[2];
    if (!(discriminant > 0)) return roots;
    const double q = -0.5 * (c[1] + std::copysign(std::sqrt(discriminant), c[1]));
    double first = c[0] / q, second = q / c[2];
    if (first > second) std::swap(first, second);
    if (first >= lo && first <= hi) roots.add(first);
    if (second >= lo && second <= hi) roots.add(second);
    return roots;
}

}  // namespace glint
