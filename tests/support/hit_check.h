// One ray on one shape: the tracer's answer held against the quad-precision reference.
#pragma once

#include "tests/support/rays.h"
#include "tests/support/reference.h"

namespace glint::test {

/// Length of the longest column: the shape's size in render space.
[[nodiscard]] inline double sizeOf(const ShapeInstance& s) {
    const DMat3& m = s.worldFromLocal;
    return std::sqrt(std::max({glm::dot(m[0], m[0]), glm::dot(m[1], m[1]), glm::dot(m[2], m[2])}));
}

/// What rounding may move a surface by, in canonical units: a few roundings of the numbers that
/// place the ray relative to the shape, as far as the transform stretches them. Hits and misses
/// within this band of a silhouette are both right.
[[nodiscard]] inline double roundingBand(const ShapeInstance& s, const DVec3& origin) {
    const auto norm = [](const DMat3& m) {
        return std::sqrt(glm::dot(m[0], m[0]) + glm::dot(m[1], m[1]) + glm::dot(m[2], m[2]));
    };
    const double condition = norm(s.worldFromLocal) * norm(s.localFromWorld);
    return 16 * 0x1p-53 * condition * (1 + norm(s.localFromWorld) * glm::length(origin - s.center));
}
/// The same band for the references' own rounding in long double, whose unit is 2^-11 of double's;
/// 16 times as wide, as they take more steps.
inline constexpr double kLongDoubleShare = 16 * 0x1p-11;

/// Sine of the angle at which a flat shape is seen; 1 for solids.
[[nodiscard]] inline double sineOfView(const CanonicalShape& shape,
                                       const Line<long double>& local) {
    const bool flat = std::holds_alternative<CanonicalPlane>(shape) ||
                      std::holds_alternative<CanonicalQuad>(shape) ||
                      std::holds_alternative<CanonicalDisk>(shape);
    return flat ? static_cast<double>(absolute(local.d.y) / squareRoot(dot(local.d, local.d))) : 1;
}

/// The error of a hit: |dt| in units of max(float ulp of t, 2^-24 of the size).
template <class Real>
[[nodiscard]] double hitError(const ShapeInstance& instance, double t, Real exact) {
    const double unit = std::max(floatUlp(static_cast<double>(exact)), 0x1p-24 * sizeOf(instance));
    return static_cast<double>(absolute(Real(t) - exact)) / unit;
}

/// What the shape in two sizes, smaller and larger by the band, says of a hit: the true answer lies
/// between.
struct Bracket {
    bool unclear = false;  ///< one is hit and the other is not
    bool miss = false;     ///< both are missed
    bool holds = false;    ///< both are hit, and the given t lies between their t
    double error = 0;      ///< hitError() against the worse of both
};
template <class Real>
[[nodiscard]] Bracket bracket(const ShapeInstance& instance, const Line<Real>& local, double t,
                              double band) {
    const auto grown = firstReference(instance.shape, local, band),
               shrunk = firstReference(instance.shape, local, -band);
    if (grown.has_value() != shrunk.has_value()) return {.unclear = true};
    if (!grown) return {.miss = true};
    const Real least = *grown < *shrunk ? *grown : *shrunk,
               most = *grown < *shrunk ? *shrunk : *grown;
    return {.holds = least <= Real(t) && Real(t) <= most,
            .error = std::max(hitError(instance, t, *grown), hitError(instance, t, *shrunk))};
}

/// Counts one check. An error of more than one unit fails, and so does a hit or miss that the
/// reference has otherwise, unless it is within the rounding band of a silhouette. The reference
/// works in long double where the shape in two sizes, a band of its rounding apart, gives the same
/// answer; everywhere else in quad precision.
inline void checkHit(const ShapeInstance& instance, const ShapeLists& lists, const Ray& ray,
                     Tally& tally) {
    ++tally.checks;
    const ShapeHit hit = lists.closest(ray, {});
    if (std::isnan(hit.t)) return tally.fail("t is no number: " + replay(instance, ray));
    const Line<long double> line = localLine<long double>(instance, ray);
    // Seen edge-on, the rounding of the direction decides where and whether a flat shape is met.
    const double sine = sineOfView(instance.shape, line);
    if (sine < 1e-6) return;
    const double band = std::min(
        1e-3, roundingBand(instance, ray.origin) / sine);  // Of needles the bound means nothing.
    const Bracket quick = bracket(instance, line, hit.t, kLongDoubleShare * band);
    if (!quick.unclear && quick.miss == !hit.found() && quick.error <= 0.5)
        return tally.error(quick.error);

    const Line<Float128> local = localLine<Float128>(instance, ray);
    const auto exact = firstReference(instance.shape, local);
    if (!hit.found() && !exact) return;
    if (hit.found() && exact)
        if (const double error = hitError(instance, hit.t, *exact); error <= 1)
            return tally.error(error);
    const Bracket wide = bracket(instance, local, hit.t, band);
    if (wide.unclear || (hit.found() && wide.holds)) return;
    tally.fail(replay(instance, ray) + " t=" + std::to_string(hit.t) +
               " exact=" + (exact ? std::to_string(static_cast<double>(*exact)) : "miss"));
}

/// A shape somewhere, turned, stretched and sheared as randomLinear() says, of any size from 1e-3
/// to 1e3.
[[nodiscard]] inline ShapeInstance randomInstance(Random& random, const CanonicalShape& shape) {
    return makeInstance(shape, randomLinear(random) * random.logUniform(1e-3, 1e3),
                        random.inCube(1));
}

/// A ray by two places of a shape's canonical space.
struct LocalRay {
    DVec3 from, to;
};
/// checkHit() of `count` rays: a new instance from `place(random)` for every 64, rays towards it
/// from `aim(random)`. With `company` a second shape stands far off, so that the lists are
/// filtered.
enum class Company { None, OneFarOff };
template <class Place, class Aim>
[[nodiscard]] Tally checkHits(std::uint64_t count, std::uint64_t seed, const Place& place,
                              const Aim& aim, Company company = Company::None) {
    return tallyInParallel(count, seed, [=](Random& random, std::uint64_t n) {
        Tally tally;
        ShapeInstance instance;
        ShapeLists lists;
        for (std::uint64_t i = 0; i < n; ++i) {
            if (i % 64 == 0) {
                instance = place(random);
                std::vector<ShapeInstance> all{instance};
                if (company == Company::OneFarOff)
                    all.push_back(makeInstance(CanonicalSphere{}, DMat3(1e-9), DVec3(1e9)));
                lists = ShapeLists(all);
            }
            const LocalRay ray = aim(random);
            checkHit(instance, lists,
                     rayTo(instance.center + instance.worldFromLocal * ray.from,
                           instance.center + instance.worldFromLocal * ray.to),
                     tally);
        }
        return tally;
    });
}

}  // namespace glint::test
