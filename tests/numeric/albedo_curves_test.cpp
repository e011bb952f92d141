// The curves of what microsurfaces lose, against a sum over visible normals that knows of no
// borders and no curves.
#include <gtest/gtest.h>

#include "tracer/materials/albedo_curves.h"

namespace glint::test {
namespace {

/// 1 - E by the midpoint rule over the uniform numbers that choose a visible normal; eta 0:
/// everything is reflected.
double lossBySum(double cosine, double alpha, double eta) {
    constexpr int kSteps = 1200;
    const Ggx ggx(alpha);
    const DVec3 o{std::sqrt(1 - cosine * cosine), 0, cosine};
    double kept = 0;
    for (int a = 0; a < kSteps; ++a)
        for (int j = 0; j < kSteps; ++j) {
            // Crowded behind the viewer and at steep normals, where the horizon cuts.
            const double x = (a + 0.5) / kSteps, v = (j + 0.5) / kSteps,
                         weight = 2 * x * 3 * v * v / (kSteps * kSteps);
            const DVec3 h = ggx.visibleNormal(o, {0.5 * (1 - x * x), 1 - v * v * v}),
                        i = reflectAbout(o, h);
            const double c = glm::dot(o, h);
            const FresnelTerm fresnel = eta > 0 ? fresnelTerm(c, eta) : FresnelTerm{};
            if (i.z > 0) kept += weight * fresnel.reflectance * ggx.shadowing(o, i);
            if (fresnel.cosTransmitted <= 0) continue;
            const DVec3 t = (eta * c - fresnel.cosTransmitted) * h - eta * o;
            if (t.z < 0) kept += weight * (1 - fresnel.reflectance) * ggx.shadowing(o, t);
        }
    return 1 - kept;
}

constexpr double kAngles[] = {0.5, 19, 62, 88.5};

TEST(AlbedoCurves, OfLossesAgreeWithASumOverVisibleNormals) {
    double worst = 0;
    for (const double alpha : {1e-3, 0.1, 1.0})
        for (const double eta : {0.0, 1 / 1.5, 1.5, 1.05}) {
            const MicrosurfaceLoss loss =
                eta > 0 ? MicrosurfaceLoss(alpha, eta) : MicrosurfaceLoss(alpha);
            for (const double angle : kAngles) {
                const double cosine = std::cos(degreesToRadians(angle)),
                             exact = lossBySum(cosine, alpha, eta);
                EXPECT_NEAR(loss(cosine), exact, 1e-4)
                    << "alpha " << alpha << ", eta " << eta << ", " << angle << " degrees";
                worst = std::max(worst, std::abs(loss(cosine) - exact));
            }
        }
    std::printf("largest difference %.1e\n", worst);
    // The wrong twin: an alpha 2 % too large.
    EXPECT_GT(std::abs(MicrosurfaceLoss(0.255, 1.5)(0.5) - lossBySum(0.5, 0.25, 1.5)), 1e-4);
}

TEST(AlbedoCurves, AveragesAreThoseOfTheCurves) {
    for (const double alpha : {1e-4, 1e-2, 0.5})
        for (const double eta : {1 / 1.5, 1.5}) {
            const MicrosurfaceLoss loss(alpha, eta);
            const CoatPassing passing(alpha, eta);
            // Even in the square root of the cosine, which crowds the narrow peaks at the horizon.
            constexpr int kSteps = 400000;
            double lost = 0, passes = 0;
            for (int k = 0; k < kSteps; ++k) {
                const double x = (k + 0.5) / kSteps, cosine = x * x,
                             weight = 4 * x * cosine / kSteps;
                lost += weight * loss(cosine);
                passes += weight * passing(cosine);
            }
            EXPECT_NEAR(loss.average(), lost, 1e-5 * lost + 1e-8) << alpha << " " << eta;
            EXPECT_NEAR(passing.average(), passes, 1e-5) << alpha << " " << eta;
        }
}

}  // namespace
}  // namespace glint::test
