// Directions to rectangular lamps: the density is that of the draws, and what arrives is what a
// grid over the lamp's area gives.
#include <gtest/gtest.h>

#include <random>

#include "tracer/compile/quad_light.h"
#include "tracer/math/transform.h"

namespace glint {
namespace {

ShapeInstance makeQuad(const DVec3& at, const DVec2& half, const DVec3& degrees) {
    ShapeInstance out;
    out.shape = CanonicalQuad{};
    out.center = at;
    out.worldFromLocal = rotationFromDegrees(degrees);
    out.worldFromLocal[0] *= half.x;
    out.worldFromLocal[2] *= half.y;
    out.localFromWorld = glm::inverse(out.worldFromLocal);
    return out;
}

/// What a point's cosine-weighted view of the quad is, by sampling it and by a fine grid over its
/// area.
TEST(QuadLight, WeighsTheQuadAsAGridOverItDoes) {
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> u(0, 1);
    for (int round = 0; round < 60; ++round) {
        const DVec2 half(0.2 + u(random), 0.2 + 2 * u(random));
        const ShapeInstance quad = makeQuad({0.3, round % 2 ? 1.2 : 6.0, -0.4}, half,
                                            {360 * u(random), 360 * u(random), 360 * u(random)});
        const DVec3 from(0.0);
        const LampRectangle lamp(quad);
        const QuadLight light(lamp, from);
        double sampled = 0, grid = 0, solidAngle = 0, least = kInfinity, most = 0;
        constexpr int kSide = 300;
        for (int i = 0; i < kSide * kSide; ++i) {
            const DVec2 place((i % kSide + 0.5) / kSide, (i / kSide + 0.5) / kSide);
            const QuadLight::Sample s = light.sample(place);
            ASSERT_GT(s.pdf, 0);
            ASSERT_NEAR(light.pdf(s.direction) / s.pdf, 1, 1e-6) << "round " << round;
            const DVec3 hit = quad.localPoint(from + s.distance * s.direction);
            ASSERT_NEAR(hit.y, 0, 1e-9);
            ASSERT_LE(std::max(std::abs(hit.x), std::abs(hit.z)), 1 + 1e-9);
            sampled += std::max(0.0, s.direction.y) / s.pdf / (kSide * kSide);
            solidAngle += 1 / s.pdf / (kSide * kSide);
            least = std::min(least, 1 / s.pdf), most = std::max(most, 1 / s.pdf);

            const DVec3 p = quad.center +
                            quad.worldFromLocal * DVec3(2 * place.x - 1, 0, 2 * place.y - 1) - from;
            const double r2 = glm::dot(p, p),
                         facing = std::abs(glm::dot(p, glm::normalize(quad.worldFromLocal[1])));
            grid += std::max(0.0, p.y) * facing / (r2 * r2) * 4 * half.x * half.y / (kSide * kSide);
        }
        EXPECT_NEAR(sampled, grid, 2e-3 * grid + 1e-6) << "round " << round;
        EXPECT_LE(most, 2.1 * solidAngle) << "round " << round;
        EXPECT_GE(least, solidAngle / 2.1) << "round " << round;
    }
}

}  // namespace
}  // namespace glint
