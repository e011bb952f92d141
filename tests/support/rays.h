// Random shapes, places and rays for the stress tests, tallies of what they find, and many threads
// for the full counts.
#pragma once

#include <chrono>
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <string>

#include <gtest/gtest.h>

#include "tests/support/scenes.h"
#include "tracer/compile/shape_lists.h"
#include "tracer/math/transform.h"

namespace glint::test {

/// PCG32 (O'Neill 2014): a stream of its own for every `stream`.
class Random {
  public:
    explicit Random(std::uint64_t seed, std::uint64_t stream = 0) : increment_(stream * 2 + 1) {
        next();
        state_ += seed;
        next();
    }
    std::uint32_t next() {
        const std::uint64_t old = state_;
        state_ = old * 6364136223846793005ull + increment_;
        const auto shifted = static_cast<std::uint32_t>(((old >> 18u) ^ old) >> 27u);
        const auto turn = static_cast<std::uint32_t>(old >> 59u);
        return (shifted >> turn) | (shifted << ((32 - turn) & 31));
    }
    /// In [0, 1), 53 bits.
    double uniform() {
        const std::uint64_t high = next();
        return static_cast<double>((high << 21) ^ (next() >> 11)) * 0x1p-53;
    }
    double uniform(double lo, double hi) { return lo + (hi - lo) * uniform(); }
    double logUniform(double lo, double hi) {
        return std::exp(uniform(std::log(lo), std::log(hi)));
    }
    DVec3 inCube(double half) {
        return {uniform(-half, half), uniform(-half, half), uniform(-half, half)};
    }
    DVec3 direction() {
        const double z = uniform(-1, 1), r = std::sqrt(1 - z * z), phi = uniform(0, 2 * kPi);
        return {r * std::cos(phi), r * std::sin(phi), z};
    }

  private:
    std::uint64_t state_ = 0, increment_;
};

/// Any invertible affine map that an object and two groups around it can have: turns, unequal
/// scales, shear, mirrors. Its columns are about 1 long and it stretches at most about 30 times
/// more in one direction than in another.
[[nodiscard]] inline DMat3 randomLinear(Random& random) {
    const auto turn = [&] { return rotationFromDegrees(random.inCube(180)); };
    const auto scale = [&] {
        const auto factor = [&] {
            return (random.uniform() < 0.5 ? -1 : 1) * random.logUniform(0.45, 2.2);
        };
        return DMat3(DVec3(factor(), 0, 0), DVec3(0, factor(), 0), DVec3(0, 0, factor()));
    };
    return turn() * scale() * turn() * scale();
}

[[nodiscard]] inline ShapeInstance makeInstance(const CanonicalShape& shape,
                                                const DMat3& worldFromLocal, const DVec3& center) {
    ShapeInstance out;
    out.shape = shape;
    out.worldFromLocal = worldFromLocal;
    out.localFromWorld = inverse(Affine{worldFromLocal, DVec3(0.0)})->linear;
    out.center = center;
    return out;
}

/// One of each analytic shape, in the order of CanonicalShape.
[[nodiscard]] inline std::vector<CanonicalShape> oneOfEach() {
    return {CanonicalSphere{}, CanonicalBox{},      CanonicalPlane{}, CanonicalQuad{},
            CanonicalDisk{},   CanonicalCylinder{}, CanonicalCone{},  CanonicalTorus{0.3}};
}
inline constexpr const char* kShapeNames[] = {"sphere", "box",      "plane", "quad",
                                              "disk",   "cylinder", "cone",  "torus"};
[[nodiscard]] inline const char* nameOf(const CanonicalShape& shape) {
    return kShapeNames[shape.index()];
}
[[nodiscard]] inline bool isClosed(const CanonicalShape& shape) {
    return std::visit([](const auto& s) { return s.closed; }, shape);
}

/// A point on an edge, a corner, a rim or the apex; of balls and tori, which have none, any point
/// near the surface.
[[nodiscard]] inline DVec3 rimPoint(Random& random, const CanonicalShape& shape) {
    const double phi = random.uniform(0, 2 * kPi);
    const bool upper = random.next() % 2 == 0;
    if (std::holds_alternative<CanonicalBox>(shape) ||
        std::holds_alternative<CanonicalQuad>(shape)) {
        DVec3 p = random.inCube(1);
        const std::uint32_t along = random.next() % 4;  // The edge's direction; 3: a corner.
        for (std::uint32_t axis = 0; axis < 3; ++axis)
            if (axis != along)
                p[static_cast<int>(axis)] = std::copysign(1.0, p[static_cast<int>(axis)]);
        if (std::holds_alternative<CanonicalQuad>(shape)) p.y = 0;
        return p;
    }
    if (const auto* torus = std::get_if<CanonicalTorus>(&shape)) {
        const double r = 1 + torus->ratio * std::cos(phi), around = random.uniform(0, 2 * kPi);
        return {r * std::cos(around), torus->ratio * std::sin(phi), r * std::sin(around)};
    }
    if (std::holds_alternative<CanonicalSphere>(shape)) return random.direction();
    if (std::holds_alternative<CanonicalCone>(shape) && upper) return {0, 1, 0};
    const bool flat = std::holds_alternative<CanonicalDisk>(shape) ||
                      std::holds_alternative<CanonicalPlane>(shape);
    return {std::cos(phi), flat ? 0 : upper ? 1 : -1, std::sin(phi)};
}

/// A unit direction; the tracer takes no other.
[[nodiscard]] inline Ray rayTo(const DVec3& origin, const DVec3& target) {
    return {origin, glm::normalize(target - origin)};
}

/// One line that replays a case: every number in hex, to the last bit.
[[nodiscard]] inline std::string replay(const ShapeInstance& s, const Ray& ray) {
    char text[1024];
    const DMat3& m = s.worldFromLocal;
    const double ratio = std::holds_alternative<CanonicalTorus>(s.shape)
                             ? std::get<CanonicalTorus>(s.shape).ratio
                             : 0;
    std::snprintf(text, sizeof text,
                  "%s ratio=%a center={%a,%a,%a} worldFromLocal={{%a,%a,%a},{%a,%a,%a},{%a,%a,%a}} "
                  "origin={%a,%a,%a} "
                  "direction={%a,%a,%a} fromShape=%u fromInside=%d returns=%d",
                  nameOf(s.shape), ratio, s.center.x, s.center.y, s.center.z, m[0].x, m[0].y,
                  m[0].z, m[1].x, m[1].y, m[1].z, m[2].x, m[2].y, m[2].z, ray.origin.x,
                  ray.origin.y, ray.origin.z, ray.direction.x, ray.direction.y, ray.direction.z,
                  ray.fromShape, ray.fromInside ? 1 : 0, ray.returns ? 1 : 0);
    return text;
}

/// Unit in the last place of float numbers around `x`.
[[nodiscard]] inline double floatUlp(double x) {
    const float f = std::abs(static_cast<float>(x));
    return static_cast<double>(std::nextafter(f, HUGE_VALF)) - static_cast<double>(f);
}

/// What a stress test found. Merging keeps the first failure's replay line.
struct Tally {
    std::uint64_t checks = 0, failures = 0;
    double worst = 0;  ///< largest error seen, in the test's own unit
    std::string first;

    void fail(const std::string& line) {
        if (failures++ == 0) first = line;
    }
    void error(double e) { worst = e > worst || std::isnan(e) ? e : worst; }
    void add(const Tally& other) {
        if (failures == 0) first = other.first;
        checks += other.checks, failures += other.failures;
        error(other.worst);
    }
    /// Prints one line, and adds it to the running full test's entry in the record (FullRun).
    void print(const std::string& what) const;
};

/// The share of `count` that GLINT_FULL asks for in a full test, at least 1; all of it elsewhere.
[[nodiscard]] std::uint64_t askedOf(std::uint64_t count);

/// Runs `piece(random, count)` for askedOf(total) cases in pieces with fixed seeds, on all
/// processors, and adds up what they return, so that the outcome does not depend on the number of
/// threads.
[[nodiscard]] Tally tallyInParallel(std::uint64_t total, std::uint64_t seed,
                                    const std::function<Tally(Random&, std::uint64_t)>& piece);

/// Base of the suites named *Full: the counts that take minutes, on request only (GLINT_FULL=1;
/// 0.01 for a hundredth of them). Where GLINT_RECORD names a file, each test appends a line to it:
/// name, checks, failures, worst error, passed or FAILED, seconds, share of the counts, separated
/// by tabs; glint-numeric-table makes a table of them.
class FullRun : public testing::Test {
  protected:
    void SetUp() override;
    void TearDown() override;

  private:
    std::chrono::steady_clock::time_point start_;
};

}  // namespace glint::test
