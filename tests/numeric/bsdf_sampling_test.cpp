// Samplers of the smooth leaves against their densities (chi-square), and samples against eval and
// pdf.
#include <gtest/gtest.h>

#include <random>

#include "tests/support/bsdf_cases.h"
#include "tests/support/chi2.h"

namespace glint::test {
namespace {

/// 80 x 160 cells a sheet in the full form.
const DirectionGrid kGrid = fullCounts() ? DirectionGrid{80, 160} : DirectionGrid{24, 16};
constexpr double kSuiteAlpha = 1e-3, kTwinLevel = 1e-4;
constexpr unsigned kSeed = 20240611;

/// Uniform in [0, 1 - 2^-24], as the renderer's samplers give.
class Uniforms {
  public:
    explicit Uniforms(unsigned seed) : engine_(seed) {}
    [[nodiscard]] float next() { return static_cast<float>(engine_() >> 8) * 0x1p-24f; }
    [[nodiscard]] Vec3 next3() {
        const float x = next(), y = next();
        return {x, y, next()};
    }

  private:
    std::mt19937 engine_;
};

std::vector<double> histogram(const LeafCase& c, const Vec3& wo, int samples, Uniforms& uniforms) {
    std::vector<double> counts(static_cast<std::size_t>(kGrid.cells()), 0.0);
    for (int k = 0; k < samples; ++k) {
        const BsdfSample sample = sampleLeaf(c, wo, uniforms.next3());
        if (!(sample.pdf > 0)) continue;
        ++counts[static_cast<std::size_t>(cellOf(c, kGrid, wo, sample.wi))];
    }
    return counts;
}

TEST(BsdfSampling, SamplesMatchPdf) {
    const std::vector<LeafCase> cases = smoothCases();
    const std::vector<Vec3> views = viewDirections();
    const int samples = fullCounts() ? 1000000 : 100000;
    const double level = sidak(kSuiteAlpha, static_cast<int>(cases.size() * views.size()));
    std::printf("seed %u, %d samples a case, significance %.3g a case\n", kSeed, samples, level);
    Uniforms uniforms(kSeed);
    for (const LeafCase& c : cases)
        for (const Vec3& wo : views) {
            const std::vector<double> counts = histogram(c, wo, samples, uniforms);
            // Total reflection begins with a square root in the rows, Phong's horizon is steep in
            // the columns.
            const DirectionGrid quick =
                c.aroundMirror ? DirectionGrid{24, 96} : DirectionGrid{c.refracts ? 16 : 6, 6};
            const DirectionGrid rule = !fullCounts()    ? quick
                                       : c.aroundMirror ? DirectionGrid{8, 12}
                                                        : DirectionGrid{4, 2};
            std::vector<double> expected = integrateCells(c, kGrid, wo, rule, [&](const Vec3& wi) {
                return static_cast<double>(pdfLeaf(c, wo, wi)) * samples;
            });
            const Chi2Result result = chi2Test(counts, expected, samples);
            EXPECT_GT(result.pValue, level) << c.name << ", cos " << wo.z << ": chi2 "
                                            << result.statistic << " of " << result.degrees;
            // The twin with a density 2 % too large must not pass.
            for (double& cell : expected) cell *= 1.02;
            EXPECT_LT(chi2Test(counts, expected, samples).pValue, kTwinLevel)
                << c.name << ", cos " << wo.z;
        }
}

TEST(BsdfSampling, PdfIntegratesToOneLessRejectedSamples) {
    const int samples = fullCounts() ? 400000 : 40000;
    Uniforms uniforms(kSeed + 1);
    double worstRejection = 0;
    for (const LeafCase& c : smoothCases())
        for (const Vec3& wo : viewDirections()) {
            int rejected = 0;
            for (int k = 0; k < samples; ++k)
                rejected += sampleLeaf(c, wo, uniforms.next3()).pdf > 0 ? 0 : 1;
            const double share = static_cast<double>(rejected) / samples;
            const double integral =
                integrateDirections(c, wo, [&](const Vec3& wi) { return pdfLeaf(c, wo, wi); });
            const double sigma = std::sqrt(std::max(share * (1 - share), 1.0 / samples) / samples);
            EXPECT_NEAR(integral + share, 1, 1e-3 + 4 * sigma) << c.name << ", cos " << wo.z;
            worstRejection = std::max(worstRejection, share);
        }
    std::printf("largest share of rejected samples %.4f\n", worstRejection);
}

TEST(BsdfSampling, SamplesAgreeWithEvalAndPdf) {
    Uniforms uniforms(kSeed + 2);
    for (const LeafCase& c : smoothCases())
        for (const Vec3& wo : viewDirections())
            for (int k = 0; k < 200; ++k) {
                const BsdfSample sample = sampleLeaf(c, wo, uniforms.next3());
                if (!(sample.pdf > 0)) continue;
                const Rgb f = evalLeaf(c, wo, sample.wi);
                const float pdf = pdfLeaf(c, wo, sample.wi);
                ASSERT_NEAR(sample.pdf, pdf, 1e-5 * pdf) << c.name << ", cos " << wo.z;
                for (int channel = 0; channel < 3; ++channel)
                    ASSERT_NEAR(sample.f[channel], f[channel], 1e-5 * f[channel])
                        << c.name << ", cos " << wo.z;
                ASSERT_NEAR(glm::length(toDouble(sample.wi)), 1, 1e-6) << c.name;
            }
}

/// f cos / pdf of one sample: at most the albedo over the sampler's share of that part.
double weightOf(const BsdfSample& sample) {
    return maxComponent(sample.f) * std::abs(sample.wi.z) / sample.pdf;
}

TEST(BsdfSampling, CornerUniformsGiveFiniteSamplesOrNone) {
    const float corners[] = {0.0f, 0x1p-32f, 0.5f, 1 - 0x1p-24f};
    double largest = 0;
    std::string where;
    std::vector<Vec3> views = viewDirections();
    views.insert(
        views.end(),
        {{1, 0, 0}, {0, -1, 0}, {1, 0, 1e-30f}, {1, 0, -1e-8f}, {0.6f, 0.8f, 1e-4f}, {0, 0, -1}});
    for (const LeafCase& c : smoothCases())
        for (const Vec3& wo : views)
            for (const float x : corners)
                for (const float y : corners)
                    for (const float z : corners) {
                        const BsdfSample sample = sampleLeaf(c, wo, {x, y, z});
                        ASSERT_TRUE(isFinite(sample.wi) && isFinite(sample.f))
                            << c.name << ", cos " << wo.z;
                        ASSERT_TRUE(std::isfinite(sample.pdf) && sample.pdf >= 0)
                            << c.name << ", cos " << wo.z;
                        if (!(sample.pdf > 0)) continue;
                        if (weightOf(sample) > largest)
                            where = c.name + ", cos " + std::to_string(wo.z);
                        largest = std::max(largest, weightOf(sample));
                    }
    std::printf("largest weight f cos / pdf %.3f: %s\n", largest, where.c_str());
    // The largest come from multiple scattering of narrow lobes at grazing angles, which is rare
    // and faint.
    EXPECT_LE(largest, 8);
}

TEST(BsdfSampling, PdfIsPositiveWhereverFIs) {
    Uniforms uniforms(kSeed + 3);
    for (const LeafCase& c : smoothCases())
        for (const Vec3& wo : viewDirections())
            for (int k = 0; k < 300; ++k) {
                Vec3 wi = toFloat(uniformSphere({uniforms.next(), uniforms.next()}));
                if (k % 3 == 0) wi = glm::normalize(Vec3(wi.x, wi.y, 1e-4f * wi.z));
                const Rgb f = evalLeaf(c, wo, wi);
                ASSERT_TRUE(isFinite(f) && std::isfinite(pdfLeaf(c, wo, wi))) << c.name;
                ASSERT_TRUE(f.x >= 0 && f.y >= 0 && f.z >= 0) << c.name;
                ASSERT_TRUE(maxComponent(f) == 0 || pdfLeaf(c, wo, wi) > 0)
                    << c.name << ", " << wo.z << " " << wi.z;
            }
}

}  // namespace
}  // namespace glint::test
