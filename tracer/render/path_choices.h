// The choices of the `path` integrator that change noise and time, never the mean, as types that tests and the bench can put others
// in the place of; with what each gains (`glint-bench choices`).
#pragma once

#include "tracer/render/kernel.h"

namespace glint {

/// How the two ways to one light share its contribution (Veach 1997, sec. 9.2). Tests put others in its place.
/// Densities are per solid angle; that of the way taken is above 0. Efficiency with the power heuristic to that with this one
/// (glint-bench choices --only weights): 0.79 to 1.01 in rooms and under skies, where the surfaces' own directions see past what
/// hides a light; 4 and more under one lamp alone that nothing hides.
struct BalanceHeuristic {
    static double lightWeight(double light, double bsdf) { return light / (light + bsdf); }
    static double bsdfWeight(double bsdf, double light) { return bsdf / (light + bsdf); }
};

/// How much a path may cost: changes noise and time, never the mean. Tests put others in its place.
struct UsualEffort {
    /// Both ways are followed at a path's first smooth dielectrics, up to so many, not one by chance. Efficiency with none and with one
    /// to that with it (glint-bench choices --only splitting): 0.83 and 0.83 glass_study, 0.78 and 0.84 cornell, 0.75 and 1.00
    /// still_life, 0.54 and 1.01 outdoor, 0.01 and 0.03 glass_in_sun; 1.00 to 1.02 where there is no glass.
    static constexpr int kMostSplits = kSplitBits;
    /// Light is also looked for by way of perfect balls and faces, see connections.h. Efficiency without to that with it
    /// (glint-bench choices --only caustics): below 0.01 outdoor, 0.3 cornell, 0.85 still_life; 1.0 to 1.1 without caustics.
    static constexpr bool kConnects = true;
    /// Light is also looked for by way of its highlights in glossy surfaces, see highlights.h. Efficiency without to that with it
    /// (glint-bench choices --only highlights): 0.5 rough_metal_room, 0.6 outdoor, 0.8 torus_field, 1.2 columns; 1.0 where they are
    /// too few to be looked for.
    static constexpr bool kHighlights = true;
    /// A path that carries less than this is left to Russian roulette. Efficiency with 1 and 0.05 to that with it (glint-bench
    /// choices --only roulette), geometric means: 0.85 and 0.98.
    static constexpr float kDim = 0.25f;
};

using UsualHeuristic = BalanceHeuristic;

}  // namespace glint
