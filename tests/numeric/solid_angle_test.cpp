// T19: solid angles to the last digits, and every shape's light sampling: densities agree with
// samples, and with the solid angle that rays find.
#include <gtest/gtest.h>

#include <functional>
#include <span>
#include <sstream>
#include <thread>

#include "tests/support/chi2.h"
#include "tests/support/rays.h"
#include "tracer/render/worker_pool.h"

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

/// A shape that stretches, leans or neither, as seen from a place of its own space.
struct View {
    DMat3 worldFromLocal{1.0};
    DVec3 from{0.0};

    [[nodiscard]] DVec3 toLocal(const DVec3& d) const {
        return glm::normalize(glm::inverse(worldFromLocal) * d);
    }
    template <class Shape>
    [[nodiscard]] bool meets(const Shape& shape, const DVec3& localDirection) const {
        return shape.first(from, localDirection, Start::Elsewhere).found();
    }
};

/// Integral over the world's directions that hit the shape, by its own sampling (pdf times `wrong`)
/// and by uniform directions. Returns the difference in standard errors. Each sample's density must
/// be the one that pdfDirection() states.
double discrepancy(const CanonicalShape& shape, const View& view, std::uint64_t count,
                   double wrong = 1) {
    return std::visit(
        [&](const auto& s) {
            Random random(29);
            Mean own[2], uniform[2];
            const Viewpoint point(view.from, view.worldFromLocal);
            for (std::uint64_t i = 0; i < count; ++i) {
                const DirectionSample sample =
                    s.sampleDirection(point, {random.uniform(), random.uniform()});
                const bool hits = sample.pdf > 0 && view.meets(s, sample.direction);
                if (sample.pdf > 0) {
                    EXPECT_NEAR(glm::length(sample.direction), 1, 1e-12);
                    if (hits) {
                        EXPECT_NEAR(s.pdfDirection(point, sample.direction) / sample.pdf, 1, 1e-6)
                            << nameOf(shape);
                    }
                }
                const DVec3 anywhere = random.direction(),
                            drawn = glm::normalize(view.worldFromLocal * sample.direction);
                const bool met = view.meets(s, view.toLocal(anywhere));
                for (int k = 0; k < 2; ++k) {
                    own[k].add(hits ? weightOf(drawn, k) / (sample.pdf * wrong) : 0);
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

/// Upright, stretched to a rod, flattened, and leaning.
DMat3 stretched(const DVec3& scale) {
    return DMat3(DVec3(scale.x, 0, 0), DVec3(0, scale.y, 0), DVec3(0, 0, scale.z));
}
/// Of which chi2OfDirections() can integrate the densities.
const DMat3 kMildTransforms[] = {DMat3(1.0),
                                 rotationFromDegrees({20, 50, -70}) * stretched({0.7, 1.5, -1}),
                                 DMat3({1, 0.2, -0.3}, {0.5, 1.1, 0}, {-0.4, 0.3, 0.7})};
const DMat3 kTransforms[] = {DMat3(1.0), stretched({0.3, 6, 0.5}),
                             rotationFromDegrees({20, 50, -70}) * stretched({3, 0.1, -1.5}),
                             DMat3({1, 0.2, -0.3}, {0.5, 1.1, 0}, {-0.4, 0.3, 0.7})};

const DVec3 kPlaces[] = {{0.3, 2.1, 0.4},  {2, 0.3, 0.5},   {1.3, -1.4, 0.2}, {0.1, -1.7, 0.1},
                         {1.1, 1.2, -0.3}, {0.2, 0.1, 0.3}, {-0.9, 0.05, 0.2}};

/// A lamp, stretched and looked at.
struct Case {
    CanonicalShape shape;
    View view;

    [[nodiscard]] std::string name() const {
        std::ostringstream out;
        out << nameOf(shape) << " from " << view.from.x << ' ' << view.from.y << ' ' << view.from.z
            << ", stretched to " << glm::length(view.worldFromLocal[0]) << ' '
            << glm::length(view.worldFromLocal[1]) << ' ' << glm::length(view.worldFromLocal[2]);
        return out.str();
    }
};
/// judge(case) for each, on all processors.
std::vector<double> onEach(const std::vector<Case>& cases,
                           const std::function<double(const Case&)>& judge) {
    std::vector<double> out(cases.size());
    WorkerPool pool(static_cast<int>(std::max(1u, std::thread::hardware_concurrency())));
    pool.run(static_cast<int>(cases.size()), [&](int, int index) {
        const auto i = static_cast<std::size_t>(index);
        out[i] = judge(cases[i]);
    });
    return out;
}

void expectSamplesMatchDensities(std::uint64_t count) {
    std::vector<Case> cases{{CanonicalTorus{1.6}, {DMat3(1.0), kPlaces[1]}}};
    for (const CanonicalShape& shape : oneOfEach()) {
        if (std::holds_alternative<CanonicalPlane>(shape)) continue;
        for (const DVec3& from : kPlaces)
            cases.push_back({shape, {kTransforms[cases.size() % 4], from}});
    }
    const std::vector<double> worst =
        onEach(cases, [&](const Case& c) { return discrepancy(c.shape, c.view, count); });
    Tally tally;  // Samples, and the largest difference in standard errors.
    for (std::size_t i = 0; i < cases.size(); ++i) {
        tally.checks += count;
        tally.error(worst[i]);
        // 50 places of two functions: 1e-3 for the suite is 4.3 standard errors each.
        EXPECT_LT(worst[i], 4.3) << cases[i].name();
    }
    tally.print("directions to lamps");
}

TEST(SolidAngle, SamplesMatchDensities) { expectSamplesMatchDensities(20000); }
TEST_F(SolidAngleFull, SamplesMatchDensities) { expectSamplesMatchDensities(1'000'000); }

TEST(SolidAngle, CheckRefusesADensityThatIsTwoPercentOff) {
    EXPECT_GT(discrepancy(CanonicalSphere{}, {DMat3(1.0), {2, 0.3, 0.5}}, 1000000, 1.02), 4.3);
}

/// Counts of directions drawn, and what the density (times `wrong`) expects, in cells about the
/// direction to the shape. The cells are even in the shape's own space, which it fills however it
/// is stretched; discrepancy() shows that the densities are those of the world.
Chi2Result chi2OfDirections(const CanonicalShape& shape, const View& view, int samples, int grid,
                            double wrong = 1) {
    constexpr int kRings = 10, kSectors = 20, kCells = kRings * kSectors;
    std::vector<double> observed(kCells), expected(kCells);
    const Viewpoint point(view.from, view.worldFromLocal);
    const Frame frame(glm::normalize(-view.from));
    // The cells cover a cone around the ball around the shape, so that no direction lies outside.
    const double sine = 1.75 / glm::length(view.from),
                 cone = sine < 1 ? coneSolidAngle(sine * sine) / (2 * kPi) : 2;
    std::visit(
        [&](const auto& s) {
            Random random(37);
            for (int i = 0; i < samples; ++i) {
                const DirectionSample d =
                    s.sampleDirection(point, {random.uniform(), random.uniform()});
                if (!(d.pdf > 0) || !view.meets(s, d.direction)) continue;
                const DVec3 local = frame.toLocal(d.direction);
                const double turn = std::atan2(local.y, local.x) / (2 * kPi) + 0.5;
                const int ring = static_cast<int>((1 - local.z) / cone * kRings),
                          sector = std::min(static_cast<int>(turn * kSectors), kSectors - 1);
                ++observed[static_cast<std::size_t>(ring * kSectors + sector)];
            }
            for (int cell = 0; cell < kCells; ++cell)
                for (int i = 0; i < grid * grid; ++i) {
                    // Jittered, so that no silhouette runs along the grid.
                    const double ring = cell / kSectors + (i / grid + random.uniform()) / grid,
                                 turn = cell % kSectors + (i % grid + random.uniform()) / grid;
                    const double z = 1 - ring / kRings * cone,
                                 r = std::sqrt(std::max(0.0, 1 - z * z)),
                                 phi = (turn / kSectors - 0.5) * 2 * kPi;
                    const DVec3 d = frame.toWorld(DVec3(r * std::cos(phi), r * std::sin(phi), z));
                    if (!view.meets(s, d)) continue;
                    const double density = s.pdfDirection(point, d) / point.worldDensity(d, 1);
                    expected[static_cast<std::size_t>(cell)] +=
                        density * wrong * samples * 2 * kPi * cone / (kCells * grid * grid);
                }
        },
        shape);
    return chi2Test(observed, expected, samples, 0.01, 20);
}

/// Each shape from afar, from near, and from beside a face. Tori are left to discrepancy(): their
/// density has no bound at outlines, which no grid integrates.
void expectDirectionsAreDistributedAsStated(std::span<const DMat3> transforms, int samples,
                                            int grid) {
    std::vector<Case> cases;
    for (const CanonicalShape& shape : oneOfEach()) {
        if (std::holds_alternative<CanonicalPlane>(shape) ||
            std::holds_alternative<CanonicalTorus>(shape))
            continue;
        for (const DMat3& transform : transforms)
            for (const DVec3& from : {DVec3(4, 9, -6), DVec3(1.2, -1.1, 0.4), DVec3(0.3, 1.06, 0.2),
                                      DVec3(-0.2, 0.4, 1.1)})
                cases.push_back({shape, {transform, from}});
    }
    const std::vector<double> chance = onEach(cases, [&](const Case& c) {
        return chi2OfDirections(c.shape, c.view, samples, grid).pValue;
    });
    Tally tally;  // Samples, and the smallest chance, from 1.
    const double bound = sidak(1e-3, static_cast<int>(cases.size()));
    for (std::size_t i = 0; i < cases.size(); ++i) {
        tally.checks += static_cast<std::uint64_t>(samples);
        tally.error(1 - chance[i]);
        EXPECT_GT(chance[i], bound) << cases[i].name();
    }
    tally.print("distributions of directions to lamps");
}
TEST(SolidAngle, DirectionsAreDistributedAsStated) {
    expectDirectionsAreDistributedAsStated({&kMildTransforms[1], 1}, 5000, 30);
}
TEST_F(SolidAngleFull, DirectionsAreDistributedAsStated) {
    expectDirectionsAreDistributedAsStated(kMildTransforms, 100000, 120);
}
TEST(SolidAngle, DistributionCheckRefusesADensityThatIsTwoPercentOff) {
    EXPECT_LT(
        chi2OfDirections(CanonicalBox{}, {kTransforms[1], {4, 9, -6}}, 200000, 40, 1.02).pValue,
        1e-6);
}

/// How evenly a shape is sampled: (mean of 1/pdf)^2 over the mean of 1/pdf^2; 1 is uniform.
double evenness(const CanonicalShape& shape, const View& view) {
    return std::visit(
        [&](const auto& s) {
            Random random(41);
            double sum = 0, squares = 0;
            constexpr int kCount = 4000;
            for (int i = 0; i < kCount; ++i) {
                const DirectionSample d = s.sampleDirection({view.from, view.worldFromLocal},
                                                            {random.uniform(), random.uniform()});
                if (!(d.pdf > 0) || !view.meets(s, d.direction)) continue;
                sum += 1 / d.pdf, squares += 1 / (d.pdf * d.pdf);
            }
            return sum * sum / (kCount * squares);
        },
        shape);
}
/// Also rods and flat ones, without shear. A torus is sampled evenly in its own two angles only.
TEST(SolidAngle, StretchedLampsAreSampledEvenlyInTheWorldsAngles) {
    std::vector<Case> cases;
    for (const CanonicalShape& shape : oneOfEach()) {
        if (std::holds_alternative<CanonicalPlane>(shape) ||
            std::holds_alternative<CanonicalTorus>(shape))
            continue;
        for (const DMat3& transform : std::span(kTransforms, 3))
            for (const DVec3& from : {DVec3(4, 9, -6), DVec3(1.2, -1.1, 0.4), DVec3(0.3, 1.06, 0.2),
                                      DVec3(-0.2, 0.4, 1.1), DVec3(1.01, 0.5, 0)})
                cases.push_back({shape, {transform, from}});
    }
    const std::vector<double> found =
        onEach(cases, [](const Case& c) { return evenness(c.shape, c.view); });
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const bool isCone = std::holds_alternative<CanonicalCone>(cases[i].shape);
        EXPECT_GT(found[i], isCone ? 0.6 : 0.9) << cases[i].name();
    }
}
/// The measure tells: in its own space, a disk flattened to a blade is far from even.
TEST(SolidAngle, EvennessFallsWhereTheStretchIsForgotten) {
    const DMat3 blade = stretched({6, 1, 0.3});
    const DVec3 from(0.8, 0.4, 0.1);
    Random random(43);
    double sum = 0, squares = 0;
    for (int i = 0; i < 4000; ++i) {
        const DirectionSample d =
            CanonicalDisk{}.sampleDirection(from, {random.uniform(), random.uniform()});
        const double pdf = Viewpoint(from, blade).worldDensity(d.direction, d.pdf);
        sum += 1 / pdf, squares += 1 / (pdf * pdf);
    }
    EXPECT_LT(sum * sum / (4000 * squares), 0.5);
    EXPECT_GT(evenness(CanonicalDisk{}, {blade, from}), 0.9);
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
