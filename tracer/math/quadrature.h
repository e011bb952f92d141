// Gauss-Legendre quadrature for smooth functions of one variable.
#pragma once

#include <vector>

#include "tracer/math/types.h"

namespace glint {

struct QuadratureNode {
    double x = 0, weight = 0;
};

/// The rule of `count` nodes on [0, 1]; exact for polynomials up to degree 2 count - 1. Nodes are
/// the roots of Legendre's polynomial by Newton's method (Press et al., Numerical Recipes, 3rd ed.,
/// sec. 4.6).
[[nodiscard]] inline std::vector<QuadratureNode> gaussLegendre(int count) {
    std::vector<QuadratureNode> nodes;
    for (int i = 0; i < count; ++i) {
        double x = std::cos(kPi * (i + 0.75) / (count + 0.5)), slope = 1;
        for (int step = 0; step < 8; ++step) {
            double p = 1, previous = 0;
            for (int k = 1; k <= count; ++k) {
                const double older = previous;
                previous = p;
                p = ((2 * k - 1) * x * previous - (k - 1) * older) / k;
            }
            slope = count * (x * p - previous) / (x * x - 1);
            x -= p / slope;
        }
        nodes.push_back({0.5 * (1 - x), 1 / ((1 - x * x) * slope * slope)});
    }
    return nodes;
}

}  // namespace glint
