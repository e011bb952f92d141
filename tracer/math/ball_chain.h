// Light that a ball sends from one place to another by reflection, or by refraction in and out:
// which ways there are, and how much they spread a bundle of rays. Pure geometry, for next-event
// estimation by way of perfect balls (render/connections.h).
//
// A ray that meets the unit ball at the angle of incidence i turns about the centre by i - asin(sx
// sin i) on the way from x, by pi - 2 asin(sin i / n) along each chord inside, and by i - asin(sy
// sin i) on the way to y, sx and sy being one over the distances. So the chains between x and y,
// which see each other at the angle theta about the centre, are the roots of
//   m pi + h(i) = +-theta (mod 2 pi),   h(i) = 2 i - asin(sx sin i) - asin(sy sin i) - 2 m asin(sin
//   i / n),
// and h is convex for n >= 1: Newton's method from the right side of each root finds all of them
// without a search.
#pragma once

#include <array>

#include "tracer/math/types.h"

namespace glint {

/// Two places outside a ball, lengths in its radii. `y` may be infinitely far.
struct ChainEnds {
    double sx = 0,
           sy = 0;  ///< one over the distance from the centre; below 1; sy = 0: infinitely far
    double sine = 0, cosine = 1;  ///< of the angle between them at the centre
};

/// One way from x to y.
struct BallChain {
    double sine = 0, cosine = 1;  ///< of incidence where the ball is met first, and left last
    double first = 0;             ///< angle at the centre from x to the first meeting
    double side = 1;  ///< +1: on y's side of the line from x through the centre; -1: on the other
};

/// The ways from x to y by `chords` pieces inside the ball (0: reflection; 1: straight through; 2:
/// with one inner reflection) with refractive index `n` > 1 (not used for reflection). Answers how
/// many were written to `out`.
inline constexpr std::size_t kMaxBallChains = 6;
[[nodiscard]] int findBallChains(const ChainEnds& ends, double n, int chords,
                                 std::array<BallChain, kMaxBallChains>& out);

/// Solid angle at x per area at y, perpendicular to the light there, in radii; per solid angle
/// where y is infinitely far. Of a chain with this sine and cosine of incidence.
[[nodiscard]] double ballChainSpread(const ChainEnds& ends, double n, int chords, double sine,
                                     double cosine);

}  // namespace glint
