// The GGX distribution: normalisation, accuracy, and the limit of a perfect mirror.
#include <gtest/gtest.h>

#include <array>

#include "tests/support/bsdf_cases.h"
#include "tracer/materials/builder.h"
#include "tracer/math/quadrature.h"

namespace glint::test {
namespace {

/// D from the angle, in long double: alpha^2 / (pi cos^4 (alpha^2 + tan^2)^2).
long double exactD(long double slope, long double alpha) {
    const long double cos2 = 1 / (1 + slope * slope), q = alpha * alpha + slope * slope;
    return alpha * alpha / (std::numbers::pi_v<long double> * cos2 * cos2 * q * q);
}

TEST(Microfacet, DistributionIsAccurateForFloatNormals) {
    double largest = 0, cancelling = 0;
    for (const double alpha : {1e-4, 1e-3, 1e-2, 0.1, 0.5, 1.0})
        for (double relative = 0.01; relative < 100; relative *= 1.3) {
            const double slope = alpha * relative, z = 1 / std::sqrt(1 + slope * slope);
            const Vec3 h = toFloat({0.6 * slope * z, 0.8 * slope * z, z});
            const long double x = h.x, y = h.y, tangent = std::sqrt(x * x + y * y);
            const long double exact = exactD(tangent / std::sqrt(1 - tangent * tangent), alpha);
            largest = std::max(
                largest, static_cast<double>(std::abs(Ggx(alpha).d(unitDirection(h)) / exact - 1)));
            const float a2 = static_cast<float>(alpha * alpha), q = h.z * h.z * (a2 - 1) + 1;
            cancelling = std::max(cancelling,
                                  static_cast<double>(std::abs(a2 / (kPiF * q * q) / exact - 1)));
        }
    std::printf("largest relative error %.2e, of the cancelling form %.2e\n", largest, cancelling);
    EXPECT_LE(largest, 1e-5);
    EXPECT_GT(cancelling, 1e-2);  // the wrong twin
}

/// A13, the weak white furnace: without shadowing of the outgoing side all the light comes back, in
/// whatever direction.
TEST(Microfacet, WeakFurnaceIsWhite) {
    for (const double alpha : {1e-4, 1e-3, 1e-2, 0.1, 0.3, 1.0})
        for (const double theta : {0.0, 30.0, 60.0, 80.0, 89.0, 89.9}) {
            const Ggx ggx(alpha);
            const DVec3 o = toDouble(viewDirection(theta, 0));
            // G1 D / (4 o.z) over all reflected directions is visibleNormalPdf over all normals.
            const double end = std::log1p(1e5 / alpha);
            const auto rule = gaussLegendre(6);
            double sum = 0;
            constexpr int kPanels = 96;
            for (int row = 0; row < kPanels; ++row)
                for (int column = 0; column < kPanels; ++column)
                    for (const QuadratureNode& a : rule)
                        for (const QuadratureNode& b : rule) {
                            const double e = end * (row + a.x) / kPanels,
                                         slope = alpha * std::expm1(e);
                            const double phi = kPi * (column + b.x) / kPanels,
                                         z = 1 / std::sqrt(1 + slope * slope);
                            const DVec3 h{slope * z * std::cos(phi), slope * z * std::sin(phi), z};
                            const double area =
                                slope * alpha * std::exp(e) * end * 2 * kPi * z * z * z;
                            sum += a.weight * b.weight / (kPanels * kPanels) * area *
                                   ggx.visibleNormalPdf(o, h);
                        }
            EXPECT_NEAR(sum, 1, 1e-4) << "alpha " << alpha << ", theta " << theta;
        }
}

/// Radiance that reaches wo through the leaf from a smooth environment 1 + x/2 + z^2.
template <class Leaf>
double seenThrough(const Leaf& leaf, const Vec3& wo, float eta) {
    const auto environment = [](const Vec3& w) {
        return 1 + 0.5 * w.x + static_cast<double>(w.z) * w.z;
    };
    double sum = 0;
    constexpr int kPlaces = 6,
                  kPicks = 1024;  // what is picked decides more than the place in so narrow a lobe
    for (int k = 0; k < kPlaces * kPlaces * kPicks; ++k) {
        const Vec3 u{(static_cast<float>(k % kPlaces) + 0.5f) / kPlaces,
                     (static_cast<float>(k / kPlaces % kPlaces) + 0.5f) / kPlaces,
                     (static_cast<float>(k / (kPlaces * kPlaces)) + 0.5f) / kPicks};
        const BsdfSample sample = leaf.sample(wo, u, eta);
        if (sample.pdf > 0)
            sum += sample.f.x * std::abs(sample.wi.z) / sample.pdf * environment(sample.wi);
    }
    return sum / (kPlaces * kPlaces * kPicks);
}
template <class Leaf>
double seenThroughDelta(const Leaf& leaf, const Vec3& wo, float eta) {
    DeltaBranch found[kMaxBranches];
    double sum = 0;
    for (int i = 0, count = leaf.branches(wo, eta, found); i < count; ++i) {
        const Vec3& w = found[i].wi;
        sum += found[i].weight.x * (1 + 0.5 * w.x + static_cast<double>(w.z) * w.z);
    }
    return sum;
}

TEST(Microfacet, NarrowestLobesAgreeWithPolishedLeaves) {
    for (const double theta : {0.0, 30.0, 60.0, 80.0, 85.0}) {
        const Vec3 wo = viewDirection(theta, 25);
        const Rgb color(0.7f);
        const double mirror = seenThroughDelta(PolishedMetalBsdf{color}, wo, 1);
        EXPECT_NEAR(seenThrough(MetalBsdf(color, kMinAlpha), wo, 1) / mirror, 1, 1e-3) << theta;
        for (const float eta : {1 / 1.5f, 1.5f}) {
            const double smooth = seenThroughDelta(GlassBsdf{}, wo, eta);
            EXPECT_NEAR(seenThrough(RoughGlassBsdf(kMinAlpha, std::array{eta}), wo, eta) / smooth,
                        1, 1e-3)
                << theta << " " << eta;
        }
    }
}

TEST(Microfacet, RoughGlassBetweenEqualMediaIsNotThere) {
    const RoughGlassBsdf glass(0.25f, std::array{1.0f, 1.5f});
    DeltaBranch found[kMaxBranches];
    const Vec3 wo = viewDirection(50, 30);
    ASSERT_EQ(glass.branches(wo, 1, found), 1);
    EXPECT_NEAR(glm::length(found[0].wi + wo), 0, 1e-6);
    EXPECT_NEAR(found[0].weight.x, 1, 1e-6);
    EXPECT_TRUE(found[0].straight);
    EXPECT_EQ(glass.sample(wo, {0.3f, 0.4f, 0.5f}, 1).pdf, 0);
    EXPECT_EQ(glass.value(wo, -wo, 1).f.x, 0);
    EXPECT_EQ(glass.branches(wo, 1.5f, found), 0);
}

TEST(Glossy, CoatOfTheIndexAroundIsNotThere) {
    const Vec3 wo = viewDirection(50, 30), wi = viewDirection(20, 200);
    const std::array indices{1.0f, 1.33f};
    const PolishedGlossyBsdf polished(Rgb(0.6f), 1.33f, indices);
    DeltaBranch found[kMaxBranches];
    EXPECT_EQ(polished.branches(wo, 1.33f, found), 0);
    EXPECT_EQ(polished.branches(wo, 1, found), 1);
    EXPECT_NEAR(polished.value(wo, wi, 1.33f).f.x, 0.6 / kPi, 1e-6);
    const GlossyBsdf rough(Rgb(0.6f), 1.33f, 0.1f, indices);
    EXPECT_NEAR(rough.value(wo, wi, 1.33f).f.x, 0.6 / kPi, 1e-4);
    EXPECT_LT(rough.baseValue(viewDirection(75, 30), wi, 1).x, 0.55 / kPi);
    EXPECT_NEAR(rough.baseValue(viewDirection(75, 30), wi, 1.33f).x, 0.6 / kPi, 1e-4);
}

TEST(Mix, OfMixesIsTakenApartOnce) {
    Scene scene;
    const MaterialId clay = scene.materials.add({"clay", Diffuse{}}),
                     mirror = scene.materials.add({"mirror", Mirror{}});
    MaterialId mix = scene.materials.add({"mix 0", Mix{{clay, false}, {mirror, false}, 0.25}});
    // Two to the power of 60 ways to the same two materials.
    for (int i = 1; i <= 60; ++i)
        mix =
            scene.materials.add({"mix " + std::to_string(i), Mix{{mix, false}, {mix, false}, 0.5}});
    mix = scene.materials.add({"veil", Mix{{mix, false}, {{}, true}, 0.2}});
    const MaterialLeaves leaves = BsdfBuilder(scene).build(mix);
    ASSERT_EQ(leaves.leaves.size(), 3u);
    float sum = 0;
    for (const WeightedLeaf& leaf : leaves.leaves) sum += leaf.weight.x;
    EXPECT_NEAR(sum, 1, 1e-5);
}

}  // namespace
}  // namespace glint::test
