// Energy and reciprocity of every leaf, by quadrature.
#include <gtest/gtest.h>

#include <array>
#include <random>

#include "tests/support/bsdf_cases.h"

namespace glint::test {
namespace {

constexpr std::array kAir{1.0f};

/// Power in all directions for unit irradiance from wo (by reciprocity, the albedo seen from wo),
/// smooth and delta parts. Radiance that crossed a boundary is brought back by eta^2.
double directionalAlbedo(const LeafCase& c, const Vec3& wo) {
    const auto power = [&](const Vec3& wi) {
        return c.refracts && !sameSide(wo, wi) ? 1 / (static_cast<double>(c.eta) * c.eta) : 1.0;
    };
    double sum = integrateDirections(c, wo, [&](const Vec3& wi) {
        return static_cast<double>(maxComponent(evalLeaf(c, wo, wi))) * std::abs(wi.z) * power(wi);
    });
    std::visit(
        [&]<class Leaf>(const Leaf& leaf) {
            if constexpr (Leaf::kDelta) {
                DeltaBranch found[kMaxBranches];
                for (int i = 0, count = leaf.branches(wo, c.eta, found); i < count; ++i)
                    sum += maxComponent(found[i].weight) * power(found[i].wi);
            }
        },
        c.leaf);
    return sum;
}

TEST(BsdfEnergy, NoLeafReflectsMoreThanItReceives) {
    double largest = 0;
    for (const LeafCase& c : smoothCases())
        for (const Vec3& wo : viewDirections()) {
            const double albedo = directionalAlbedo(c, wo);
            largest = std::max(largest, albedo);
            EXPECT_LE(albedo, 1 + 1e-4) << c.name << ", cos " << wo.z;
        }
    std::printf("largest albedo %.6f\n", largest);
}

/// White furnace: what is white loses nothing.
TEST(BsdfEnergy, WhiteLeavesKeepAllLight) {
    double metal = 0, thin = 0, glossy = 0, glass = 0;
    for (const double alpha : {1e-4, 1e-3, 1e-2, 0.1, 0.3, 0.6, 1.0}) {
        const float a = static_cast<float>(alpha);
        for (const double theta : {0.0, 30.0, 60.0, 80.0, 89.0}) {
            const Vec3 wo = viewDirection(theta, 25);
            const auto lost = [&](const LeafCase& c) {
                return std::abs(1 - directionalAlbedo(c, wo));
            };
            metal = std::max(metal, lost({"metal", MetalBsdf(Rgb(1.0f), a), 1, alpha}));
            thin =
                std::max(thin, lost({"thin", RoughThinGlassBsdf(1.5f, a, kAir), 1, alpha, true}));
            glossy =
                std::max(glossy, lost({"glossy", GlossyBsdf(Rgb(1.0f), 1.5f, a, kAir), 1, alpha}));
            for (const float eta : {1 / 1.5f, 1.5f})
                glass = std::max(glass, lost({"glass", RoughGlassBsdf(a, std::array{eta}), eta,
                                              alpha, true, true}));
        }
    }
    std::printf("largest difference from 1: metal %.1e, thin glass %.1e, glossy %.1e, glass %.1e\n",
                metal, thin, glossy, glass);
    EXPECT_LE(metal, 1e-4);
    EXPECT_LE(thin, 1e-4);
    EXPECT_LE(glossy, 1e-4);
    EXPECT_LE(glass, 1e-4);
}

TEST(BsdfEnergy, PolishedGlossyWithWhiteBaseKeepsAllLight) {
    for (const float ior : {1.0f, 1.33f, 1.5f, 2.4f})
        for (const double theta : {0.0, 45.0, 80.0, 89.0}) {
            const LeafCase c{"polished", PolishedGlossyBsdf(Rgb(1.0f), ior, kAir)};
            EXPECT_NEAR(directionalAlbedo(c, viewDirection(theta, 10)), 1, 1e-4)
                << ior << " " << theta;
        }
}

/// f(wo, wi) = f(wi, wo), and across a boundary f(wo, wi, eta) = eta^2 f(wi, wo, 1/eta).
TEST(BsdfEnergy, LeavesAreReciprocal) {
    std::mt19937 engine(7);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (const LeafCase& c : smoothCases())
        for (int k = 0; k < 400; ++k) {
            const Vec3 wo = toFloat(uniformSphere({uniform(engine), uniform(engine)}));
            Vec3 wi = toFloat(uniformSphere({uniform(engine), uniform(engine)}));
            if (k % 2 == 0)
                wi = sampleLeaf(c, wo, toFloat({uniform(engine), uniform(engine), uniform(engine)}))
                         .wi;
            if (glm::dot(wi, wi) < 0.5f || (!c.crosses && !sameSide(wo, wi))) continue;
            LeafCase reverse = c;
            const bool crossed = c.refracts && !sameSide(wo, wi);
            if (crossed) reverse.eta = 1 / c.eta;
            const double scale = crossed ? static_cast<double>(c.eta) * c.eta : 1;
            const Rgb there = evalLeaf(c, wo, wi), back = evalLeaf(reverse, wi, wo);
            // 1/eta is rounded to float, which turns the half vector by up to 1e-7.
            const double tolerance = 1e-4 + (crossed ? 4e-7 / c.width : 0);
            for (int channel = 0; channel < 3; ++channel)
                ASSERT_NEAR(there[channel], scale * back[channel],
                            tolerance * there[channel] + 1e-7)
                    << c.name << ", cos " << wo.z << " and " << wi.z;
        }
}

TEST(BsdfEnergy, DeltaBranchesKeepAllLight) {
    DeltaBranch found[kMaxBranches];
    for (const float eta : {1 / 2.4f, 1 / 1.5f, 1 / 1.01f, 1.0f, 1.01f, 1.5f, 2.4f})
        for (const double theta : {0.0, 20.0, 41.81, 60.0, 89.9, 90.5, 150.0, 180.0}) {
            const Vec3 wo = viewDirection(theta, 70);
            double glass = 0, thin = 0;
            for (int i = 0, count = GlassBsdf{}.branches(wo, eta, found); i < count; ++i)
                glass += found[i].weight.x *
                         (sameSide(wo, found[i].wi) ? 1.0 : 1 / (static_cast<double>(eta) * eta));
            for (int i = 0, count = ThinGlassBsdf{1.5f}.branches(wo, eta, found); i < count; ++i)
                thin += found[i].weight.x;
            EXPECT_NEAR(glass, 1, 1e-6) << eta << " " << theta;
            EXPECT_NEAR(thin, 1, 1e-6) << theta;
            EXPECT_EQ(PolishedMetalBsdf{Rgb(1.0f)}.branches(wo, eta, found), 1);
            EXPECT_NEAR(found[0].weight.x, 1, 1e-6);
        }
}

/// The lobe (n+2)/(2 pi) cos^n has albedo 1 at normal incidence, and less elsewhere.
TEST(BsdfEnergy, PhongLobeIsWhiteAtNormalIncidenceOnly) {
    for (const float exponent : {0.0f, 1.0f, 10.0f, 100.0f, 1e4f, 1e6f}) {
        const LeafCase c{
            "phong", PhongBsdf{exponent}, 1, 1 / std::sqrt(1.0 + exponent), false, false, true};
        EXPECT_NEAR(directionalAlbedo(c, {0, 0, 1}), 1, 1e-4) << exponent;
        EXPECT_LT(directionalAlbedo(c, viewDirection(45, 0)), 1) << exponent;
    }
}

}  // namespace
}  // namespace glint::test
