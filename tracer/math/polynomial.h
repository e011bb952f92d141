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

/// c[0] + c[1] x + ... + c[Degree] x^Degree by Horner's rule.
template <int Degree>
[[nodiscard]] ValueAndSlope evaluatePolynomial(const std::array<double, Degree + 1>& c, double x) {
    ValueAndSlope out{c[Degree], 0};
    for (std::size_t i = Degree; i-- > 0;) {
        out.slope = out.slope * x + out.value;
        out.value = out.value * x + c[i];
    }
    return out;
}

/// The place in [left, right] where `f` changes sign, to within `resolution`; `negativeLeft` says
/// from which. Newton from the middle, held in the bracket by bisection; a slope that is no number
/// only costs a bisection.
template <class Function>
[[nodiscard]] double refineRoot(const Function& f, double left, double right, bool negativeLeft,
                                double resolution) {
    double x = 0.5 * (left + right);
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
        if (negativeA != negativeB) roots.add(refineRoot(f, a, b, negativeA, resolution));
        a = b, negativeA = negativeB;
    }
    return roots;
}

/// The first of these places beyond `after`; infinite if there is none. Those before are not refined.
template <int Degree, class Function>
[[nodiscard]] double firstSignChange(const Roots<Degree - 1>& critical, double lo, double hi,
                                     double after, const Function& f) {
    const double resolution = 0x1p-53 * (hi - lo);
    double a = lo;
    bool negativeA = f(lo).value < 0;
    for (int i = 0; i <= critical.count; ++i) {
        const double b = i < critical.count ? critical[i] : hi;
        const bool negativeB = f(b).value < 0;
        if (negativeA != negativeB && b > after)
            if (const double x = refineRoot(f, a, b, negativeA, resolution); x > after) return x;
        a = b, negativeA = negativeB;
    }
    return std::numeric_limits<double>::infinity();
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

/// All roots in [lo, hi] at which the polynomial changes sign.
template <int Degree>
[[nodiscard]] Roots<Degree> findRoots(const std::array<double, Degree + 1>& c, double lo,
                                      double hi) {
    if constexpr (Degree == 1) {
        Roots<1> root;
        if (const double x = -c[0] / c[1]; x >= lo && x <= hi) root.add(x);
        return root;
    } else if constexpr (Degree == 2) {
        return quadraticRoots(c, lo, hi);
    } else {
        std::array<double, Degree> derivative{};
        for (std::size_t i = 0; i < Degree; ++i)
            derivative[i] = static_cast<double>(i + 1) * c[i + 1];
        return signChanges<Degree>(findRoots<Degree - 1>(derivative, lo, hi), lo, hi,
                                   [&](double x) { return evaluatePolynomial<Degree>(c, x); });
    }
}

}  // namespace glint
