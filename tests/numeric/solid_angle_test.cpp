// T19: solid angles to the last digits, and every shape's light sampling: densities agree with
// samples, and with the solid angle that rays find.
#include <gtest/gtest.h>

#include "tests/support/rays.h"

namespace glint {
namespace {

using namespace test;
using SolidAngleFull = FullRun;

TEST(SolidAngle, OfABallHasNoCancellation) {
    for (double ratio = 0.999999; ratio > 1e-8; ratio *= 0.7) {
        const double exact =
            static_cast<double>(2 * std::numbers::pi_v<long double> * ratio * ratio /
                                (1 + std::sqrt(1 - static_cast<long double>(ratio) * ratio)));
        EXPECT_NEAR(1 / sphereDirectionPdf({0, 0, 1}, ratio), exact, 1e-9 * exact) << ratio;
        // What the textbook's 2 pi (1 - cos) would give: the test can fail.
        if (ratio < 1e-6) {
            EXPECT_GT(std::abs(2 * kPi * (1 - std::sqrt(1 - ratio * ratio)) - exact), 1e-5 * exact);
        }
    }
}

/// The classical corner formula, in long double: a sum of four arcs.
long double rectangleSolidAngle(long double x0, long double y0, long double x1, long double y1,
                                long double z) {
    const auto corner = [z](long double x, long double y) {
        return std::atan2(x * y, z * std::sqrt(x * x + y * y + z * z));
    };
    return corner(x1, y1) - corner(x0, y1) - corner(x1, y0) + corner(x0, y0);
}

TEST(SolidAngle, OfARectangleFrom1e8thToTheWholeHalfSpace) {
    Random random(19);
    int compared = 0;
    for (int i = 0; i < 20000; ++i) {
        const double x0 = random.uniform(-3, 3), y0 = random.uniform(-3, 3),
                     z = random.logUniform(1e-3, 1e4);
        const double w = random.logUniform(1e-2, 10), h = random.logUniform(1e-2, 10);
        const double exact = static_cast<double>(rectangleSolidAngle(x0, y0, x0 + w, y0 + h, z));
        if (exact < 1e-10) continue;
        ++compared;
        EXPECT_NEAR(SphericalQuad(x0, y0, x0 + w, y0 + h, z).solidAngle(), exact, 1e-9 * exact)
            << x0 << ' ' << y0 << ' ' << w << ' ' << h << ' ' << z;
    }
    EXPECT_GT(compared, 10000);
    EXPECT_NEAR(SphericalQuad(-1e5, -1e5, 1e5, 1e5, 0.1).solidAngle(), 2 * kPi, 1e-5);
}

/// u.x is the share of the solid angle on one side of the sample, u.y the share of sines within the
/// column.
TEST(SolidAngle, ARectangleIsDividedAsTheNumbersSay) {
    Random random(23);
    for (int i = 0; i < 20000; ++i) {
        const double x0 = random.uniform(-3, 3), y0 = random.uniform(-3, 3),
                     z = random.logUniform(1e-3, 1e2);
        const double w = random.logUniform(1e-2, 10), h = random.logUniform(1e-2, 10);
        const SphericalQuad quad(x0, y0, x0 + w, y0 + h, z);
        if (quad.solidAngle() < 1e-6) continue;
        const DVec2 u(random.uniform(0.01, 0.99), random.uniform(0.01, 0.99));
        const DirectionSample s = quad.sample(u);
        const double x = s.direction.x * z / s.direction.z, y = s.direction.y * z / s.direction.z;
        EXPECT_NEAR(SphericalQuad(x0, y0, x, y0 + h, z).solidAngle() / quad.solidAngle(), u.x, 1e-4)
            << x0 << ' ' << y0 << ' ' << w << ' ' << h << ' ' << z;
        const auto sine = [&](double v) { return v / std::sqrt(x * x + v * v + z * z); };
        EXPECT_NEAR((sine(y) - sine(y0)) / (sine(y0 + h) - sine(y0)), u.y, 1e-4);
        EXPECT_NEAR(s.pdf * quad.solidAngle(), 1, 1e-12);
    }
}

/// Mean and standard error.
struct Mean {
    double sum = 0, squares = 0;
    std::uint64_t count = 0;
    void add(double x) { sum += x, squares += x * x, ++count; }
    [[nodiscard]] double value() const { return sum / static_cast<double>(count); }
    [[nodiscard]] double sigma2() const {
        return (squares / static_cast<double>(count) - value() * value()) /
               static_cast<double>(count);
    }
};

/// A function of direction that no symmetry hides.
double weightOf(const DVec3& d, int which) {
    return which == 0 ? 1 : 1 + 0.5 * d.x + 0.3 * d.y * d.z - 0.4 * d.z;
}

/// Integral over the directions that hit the shape, by its own sampling (pdf times `wrong`) and by
/// uniform directions. Returns the difference in standard errors. Each sample's density must be the
/// one that pdfDirection() states.
double discrepancy(const CanonicalShape& shape, const DVec3& from, std::uint64_t count,
                   double wrong = 1) {
    return std::visit(
        [&](const auto& s) {
            Random random(29);
            Mean own[2], uniform[2];
            for (std::uint64_t i = 0; i < count; ++i) {
                const DirectionSample sample =
                    s.sampleDirection(from, {random.uniform(), random.uniform()});
                const bool hits =
                    sample.pdf > 0 && s.first(from, sample.direction, Start::Elsewhere).found();
                if (sample.pdf > 0) {
                    EXPECT_NEAR(glm::length(sample.direction), 1, 1e-12);
                    if (hits) {
                        EXPECT_NEAR(s.pdfDirection(from, sample.direction) / sample.pdf, 1, 1e-6)
                            << nameOf(shape);
                    }
                }
                const DVec3 anywhere = random.direction();
                const bool met = s.first(from, anywhere, Start::Elsewhere).found();
                for (int k = 0; k < 2; ++k) {
                    own[k].add(hits ? weightOf(sample.direction, k) / (sample.pdf * wrong) : 0);
                    uniform[k].add(met ? 4 * kPi * weightOf(anywhere, k) : 0);
                }
            }
            double worst = 0;
            for (int k = 0; k < 2; ++k)
                worst = std::max(worst, std::abs(own[k].value() - uniform[k].value()) /
                                            std::sqrt(own[k].sigma2() + uniform[k].sigma2()));
            return worst;
        },
        shape);
}

const DVec3 kPlaces[] = {{0.3, 2.1, 0.4},  {2, 0.3, 0.5},   {1.3, -1.4, 0.2}, {0.1, -1.7, 0.1},
                         {1.1, 1.2, -0.3}, {0.2, 0.1, 0.3}, {-0.9, 0.05, 0.2}};

void expectSamplesMatchDensities(std::uint64_t count) {
    Tally tally;  // Samples, and the largest difference in standard errors.
    const auto expectNone = [&](const CanonicalShape& shape, const DVec3& from) {
        const double worst = discrepancy(shape, from, count);
        tally.checks += count;
        tally.error(worst);
        // 50 places of two functions: 1e-3 for the suite is 4.3 standard errors each.
        EXPECT_LT(worst, 4.3) << nameOf(shape) << " from " << from.x << ' ' << from.y << ' '
                              << from.z;
    };
    for (const CanonicalShape& shape : oneOfEach()) {
        if (std::holds_alternative<CanonicalPlane>(shape)) continue;
        for (const DVec3& from : kPlaces) expectNone(shape, from);
    }
    expectNone(CanonicalTorus{1.6}, kPlaces[1]);
    tally.print("directions to lamps");
}

TEST(SolidAngle, SamplesMatchDensities) { expectSamplesMatchDensities(20000); }
TEST_F(SolidAngleFull, SamplesMatchDensities) { expectSamplesMatchDensities(3'000'000); }

TEST(SolidAngle, CheckRefusesADensityThatIsTwoPercentOff) {
    EXPECT_GT(discrepancy(CanonicalSphere{}, {2, 0.3, 0.5}, 1000000, 1.02), 4.3);
}

/// From outside, no sample of a convex shape goes past it.
TEST(SolidAngle, EverySampleOfAConvexShapeReachesIt) {
    Random random(31);
    for (const CanonicalShape& shape : oneOfEach()) {
        if (std::holds_alternative<CanonicalPlane>(shape)) continue;
        int missed = 0;
        for (int i = 0; i < 20000; ++i) {
            const DVec3 from = random.logUniform(2, 1e4) * random.direction();
            std::visit(
                [&](const auto& s) {
                    const DirectionSample sample =
                        s.sampleDirection(from, {random.uniform(), random.uniform()});
                    missed += !(sample.pdf > 0) ||
                              !s.first(from, sample.direction, Start::Elsewhere).found();
                },
                shape);
        }
        EXPECT_LE(missed, 2) << nameOf(shape);
    }
}

}  // namespace
}  // namespace glint
