// Directions towards lights of every kind against their densities (chi-square), cell by cell: each
// sample stands for 1 / pdf of solid angle, and those of a cell must add up to the solid angle of
// the light that a grid of directions finds there. Densities of area sampling grow without bound at
// outlines, their inverse does not. T15
#include <gtest/gtest.h>

#include <random>

#include "tests/support/chi2.h"
#include "tests/support/scenes.h"
#include "tests/support/ztest.h"
#include "tracer/math/frame.h"

namespace glint::test {
namespace {

constexpr double kSuiteAlpha = 1e-3;
constexpr unsigned kSeed = 20240612;

/// Cells about an axis, even in the solid angle: rows in the cosine from 1 to `least`, columns in
/// the azimuth.
struct Cells {
    Frame frame;
    double least = -1;
    int rows = 0, columns = 0;

    [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(rows * columns); }
    [[nodiscard]] DVec3 direction(double row, double column) const {
        const double cosine = 1 - (1 - least) * row / rows, phi = 2 * kPi * column / columns,
                     sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
        return frame.toWorld(DVec3(sine * std::cos(phi), sine * std::sin(phi), cosine));
    }
    /// count() for a direction outside.
    [[nodiscard]] std::size_t cellOf(const DVec3& wi) const {
        const DVec3 local = frame.toLocal(wi);
        const double row = (1 - local.z) / (1 - least) * rows,
                     turn = std::atan2(local.y, local.x) / (2 * kPi);
        if (!(row < rows)) return count();
        return static_cast<std::size_t>(std::max(0.0, row)) * static_cast<std::size_t>(columns) +
               std::min(static_cast<std::size_t>((turn < 0 ? turn + 1 : turn) * columns),
                        static_cast<std::size_t>(columns - 1));
    }
};

/// One light seen from one place.
struct LightCase {
    std::shared_ptr<const RenderScene> scene;
    DVec3 from{0.0};
    std::string name;

    [[nodiscard]] const CompiledLight& light() const { return scene->lights.lights[0]; }
    [[nodiscard]] bool reaches(const DVec3& wi) const {
        if (light().kind == LightKind::Sun) return light().discHolds(wi);
        const ShapeInstance& shape = scene->shapes[light().shape];
        return std::visit(
            [&](const auto& s) {
                return s
                    .first(shape.localPoint(from), glm::normalize(shape.localVector(wi)),
                           Start::Elsewhere)
                    .found();
            },
            shape.shape);
    }
    [[nodiscard]] double pdf(const DVec3& wi) const {
        return reaches(wi) ? lightPdf(scene->lights, scene->shapes, 0, from, wi) : 0;
    }
    /// A little wider than the light, the whole sphere from within it.
    [[nodiscard]] Cells cells() const {
        Cells cells = fullCounts() ? Cells{{}, -1, 80, 160} : Cells{{}, -1, 12, 24};
        if (light().kind == LightKind::Sun) {
            cells.frame = Frame(light().direction);
            cells.least = std::sqrt(1 - 1.05 * light().sin2Angle);
            return cells;
        }
        const ShapeInstance& shape = scene->shapes[light().shape];
        const DVec3 to = shape.center - from;
        const double sine = 1.02 * glm::length(shape.halfSize()) / glm::length(to);
        cells.frame = Frame(glm::normalize(to));
        if (sine < 1) cells.least = std::sqrt(1 - sine * sine);
        return cells;
    }
};

std::vector<LightCase> lightCases() {
    std::vector<LightCase> cases;
    const auto add = [&](const Shape& shape, const char* name) {
        SceneBuilder b;
        const ObjectId id = b.object(shape, {}, {0, 0, 0}, {1, 1, 1});
        Object lamp = b.scene().objects.at(id);
        lamp.twoSided = true;
        lamp.transform.rotateDegrees = {25, 40, -15};
        lamp.transform.scale = {1, 1.4, 0.8};
        b.scene().objects.set(id, lamp);
        const auto scene = b.compile();
        const DVec3 center = scene->shapes[0].center;
        int view = 0;
        for (const DVec3& from : {DVec3(0.9, 2.3, 1.7), DVec3(-1.9, -0.6, 0.4), DVec3(20, 30, -25)})
            cases.push_back({scene, center + from,
                             std::string(name) + " from place " + std::to_string(++view)});
    };
    add(Sphere{0.8}, "ball");
    add(Box{{1, 0.7, 1.2}}, "box");
    add(Quad{{1.5, 1}}, "quad");
    add(Disk{0.7}, "disk");
    add(Cylinder{0.5, 1.2}, "cylinder");
    add(Cone{0.6, 1.1}, "cone");
    add(Torus{0.7, 0.25}, "torus");
    for (const double angle : {0.53, 40.0}) {
        SceneBuilder b;
        b.object(Sphere{1}, {});
        b.scene().lights.add({"Sun", SunLight{{0.3, -1, 0.2}, {1, 1, 1}, angle}, true, ""});
        cases.push_back({b.compile(), {0, 3, 0}, "sun of " + std::to_string(angle) + " degrees"});
    }
    return cases;
}

/// Solid angle of the light in each cell, and the variance of that estimate.
struct Areas {
    std::vector<double> mean, variance, count;
    explicit Areas(std::size_t cells) : mean(cells, 0.0), variance(cells, 0.0), count(cells, 0.0) {}
    void add(std::size_t cell, double area) {
        mean[cell] += area;
        variance[cell] += area * area;
        count[cell] += 1;
    }
};

class Uniforms {
  public:
    double next() { return static_cast<double>(engine_() >> 8) * 0x1p-24; }

  private:
    std::mt19937 engine_{kSeed};
};

/// By the light's own samples, their densities multiplied by `wrong`.
Areas bySampling(const LightCase& c, const Cells& cells, int samples, double wrong,
                 Uniforms& uniforms) {
    Areas out(cells.count());
    for (int i = 0; i < samples; ++i) {
        const double x = uniforms.next(), y = uniforms.next();
        const LightSample s =
            sampleLight(c.scene->lights, c.scene->shapes, 0, Ray{c.from, {0, 1, 0}}, {}, {x, y});
        if (!(s.pdf > 0) || !c.reaches(s.wi)) continue;
        const std::size_t cell = cells.cellOf(s.wi);
        EXPECT_LT(cell, cells.count()) << c.name;
        if (cell < cells.count()) out.add(cell, 1 / (s.pdf * wrong * samples));
    }
    return out;
}

/// By an even grid of directions within each cell; of a cell that the light's outline cuts, it is
/// off by some of the grid's meshes along the cut.
Areas byGrid(const LightCase& c, const Cells& cells) {
    const int sub = fullCounts() ? 24 : 60;
    Areas out(cells.count());
    const double cell = 2 * kPi * (1 - cells.least) / static_cast<double>(cells.count()),
                 mesh = cell / (sub * sub);
    for (int row = 0; row < cells.rows; ++row)
        for (int column = 0; column < cells.columns; ++column) {
            const auto at = static_cast<std::size_t>(row * cells.columns + column);
            for (int k = 0; k < sub * sub; ++k)
                if (c.reaches(cells.direction(row + (k / sub + 0.5) / sub,
                                              column + (k % sub + 0.5) / sub)))
                    out.add(at, mesh);
            out.variance[at] = out.count[at] < sub * sub ? mesh * mesh * sub : 0;
        }
    return out;
}

/// Twice the smaller significance of all cells together and of their sum.
double significance(const Areas& a, const Areas& b) {
    constexpr double kLeastCount = 25;
    double statistic = 0, poolDifference = 0, poolVariance = 0, difference = 0, variance = 0;
    int degrees = 0;
    for (std::size_t i = 0; i < a.mean.size(); ++i) {
        const double d = a.mean[i] - b.mean[i], v = a.variance[i] + b.variance[i];
        difference += d;
        variance += v;
        if (a.count[i] < kLeastCount) {
            poolDifference += d;
            poolVariance += v;
            continue;
        }
        statistic += d * d / v;
        ++degrees;
    }
    if (poolVariance > 0) {
        statistic += poolDifference * poolDifference / poolVariance;
        ++degrees;
    }
    return 2 * std::min(chiSquareSurvival(statistic, degrees),
                        normalTwoSided(difference / std::sqrt(variance)));
}

TEST(LightSampling, DirectionsMatchTheirDensities) {
    const std::vector<LightCase> cases = lightCases();
    const int samples = fullCounts() ? 2000000 : 500000;
    const double level = sidak(kSuiteAlpha, static_cast<int>(cases.size()));
    Uniforms uniforms;
    for (const LightCase& c : cases) {
        const Cells cells = c.cells();
        const Areas expected = byGrid(c, cells);
        EXPECT_GT(significance(bySampling(c, cells, samples, 1, uniforms), expected), level)
            << c.name;
        EXPECT_LT(significance(bySampling(c, cells, samples, 1.02, uniforms), expected), level)
            << c.name << ": the wrong twin";
    }
}

}  // namespace
}  // namespace glint::test
