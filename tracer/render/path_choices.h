// The choices of the `path` integrator that change noise and time, never the mean, as types that
// tests and the bench can put others in the place of; with what each gains (`glint-bench choices`).
#pragma once

#include "tracer/render/kernel.h"

namespace glint {

/// How the two ways to one light share its contribution (Veach 1997, sec. 9.2). Tests put others in
/// its place. Densities are per solid angle; that of the way taken is above 0. Efficiency with the
/// power heuristic to that with this one (glint-bench choices --only weights): 0.79 to 1.01 in
/// rooms and under skies, where the surfaces' own directions see past what hides a light; 4 and
/// more under one lamp alone that nothing hides.
struct BalanceHeuristic {
    static double lightWeight(double light, double bsdf) { return light / (light + bsdf); }
    static double bsdfWeight(double bsdf, double light) { return bsdf / (light + bsdf); }
};

/// The other usual way (Veach 1997, sec. 9.2.3, beta = 2): for references and measurements.
struct PowerHeuristic {
    static double lightWeight(double light, double bsdf) { return share(light, bsdf); }
    static double bsdfWeight(double bsdf, double light) { return share(bsdf, light); }

  private:
    static double share(double a, double b) { return 1 / (1 + (b / a) * (b / a)); }
};

/// How much a path may cost: changes noise and time, never the mean. Tests put others in its place.
struct UsualEffort {
    /// Both ways are followed at a path's first smooth dielectrics, up to so many, not one by
    /// chance. Efficiency with none and with one to that with it (glint-bench choices --only
    /// splitting --width 40 --runs 40): 0.77 and 0.91 glass_study, 0.77 and 0.91 cornell, 0.64 and
    /// 0.87 still_life, 0.73 and 0.91 outdoor, 0.39 and 0.63 glass_in_sun; 1.0 where there is no
    /// glass.
    static constexpr int kMostSplits = kSplitBits;
    /// Light is also looked for by way of perfect balls and faces, see connections.h. Efficiency
    /// without to that with it (glint-bench choices --only caustics): below 0.01 outdoor, 0.3
    /// cornell, 0.85 still_life; 1.0 to 1.1 without caustics.
    static constexpr bool kConnects = true;
    /// Light is also looked for by way of its highlights in glossy surfaces, see highlights.h.
    /// Efficiency without to that with it (glint-bench choices --only highlights): 0.5
    /// rough_metal_room, 0.6 outdoor, 0.8 torus_field, 1.2 columns; 1.0 where they are too few to
    /// be looked for.
    static constexpr bool kHighlights = true;
    /// A path that carries less than this behind a surface that scatters, and behind one that does
    /// not, is left to Russian roulette. Efficiency with 1, 0.25 and 0.05 for both to that with it
    /// (glint-bench choices --only roulette), geometric means: 0.64, 0.97 and 0.95.
    static constexpr float kDim = 0.25f, kDimBranch = 0.15f;
    /// Of up to so many lights, each is sampled at the first surface that scatters, not one by
    /// choice, if some have no size: there little else makes noise. kAllSized: if none has, too.
    /// Efficiency with one to that with it (glint-bench choices --only lights): 1.04 columns, 0.55
    /// mirrors of scenes/classic; with each anyway 0.82 still_life, 0.95 materials.
    static constexpr std::size_t kAllLights = 4;
    static constexpr bool kAllSized = false;
};

using UsualHeuristic = BalanceHeuristic;

}  // namespace glint
