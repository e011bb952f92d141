#include "tests/support/bsdf_cases.h"

#include <array>
#include <numeric>

#include "tests/support/chi2.h"
#include "tracer/math/quadrature.h"

namespace glint::test {
namespace {

constexpr double kLargestSlope = 1e5;

/// Rows are even in the logarithm of 1 + slope / width.
double rowScale(double width) { return std::log1p(kLargestSlope / width); }

/// The direction whose half vector (to wo, on the given sheet) has the place (s, t), and d(solid
/// angle) / d(s, t).
struct Placed {
    DVec3 wi{0.0};
    double jacobian = 0;  ///< 0: no such direction
};
/// How far rows reach at this azimuth of the half vector: for reflection to the horizon exactly,
/// else to the largest slope.
double rowEnd(const LeafCase& c, const DVec3& o, bool reflected, double phi) {
    if (!reflected) return rowScale(c.width);
    const double a = o.x * std::cos(phi) + o.y * std::sin(phi), root = std::sqrt(a * a + o.z * o.z);
    return std::log1p((a > 0 ? (a + root) / o.z : o.z / (root - a)) / c.width);
}

/// The upper half vector of a refraction; false if it faces away from either direction.
bool refractionNormal(const LeafCase& c, const DVec3& o, const DVec3& i, DVec3& h) {
    h = static_cast<double>(c.eta) * o + i;
    if (h.z < 0) h = -h;
    return glm::dot(o, h) > 0 && glm::dot(i, h) < 0;
}

/// Rows of sheet 2 are even in the logarithm of 1 + cosine / width: narrow lobes lose most at
/// cosines near their width.
Placed placeElsewhere(const LeafCase& c, const DVec3& o, double s, double t) {
    const double k = std::log1p(1 / c.width), z = c.width * std::expm1(k * s),
                 r = std::sqrt(1 - z * z);
    const DVec3 wi{r * std::cos(2 * kPi * t), r * std::sin(2 * kPi * t), -z};
    DVec3 h;
    return refractionNormal(c, o, wi, h) ? Placed{}
                                         : Placed{wi, 2 * kPi * c.width * k * std::exp(k * s)};
}

/// About the mirrored direction, with azimuth 0 straight up.
Frame mirrorFrame(const DVec3& o) {
    Frame frame(DVec3(-o.x, -o.y, o.z));
    const double across = std::hypot(o.x, o.y);
    if (across > 0) frame.s = DVec3(o.x * o.z, o.y * o.z, across * across) / across;
    frame.t = glm::cross(frame.n, frame.s);
    return frame;
}

/// The largest angle from the mirrored direction at this azimuth about it: to the horizon, or all
/// the way round.
double angleEnd(const Frame& mirror, double phi) {
    const double slope = -mirror.n.z / (std::cos(phi) * mirror.s.z + std::sin(phi) * mirror.t.z);
    return slope > 0 ? std::atan(slope) : kPi + std::atan(slope);
}
Placed placeAroundMirror(const LeafCase& c, const DVec3& o, double s, double t) {
    const Frame mirror = mirrorFrame(o);
    const double phi = 2 * kPi * t, k = std::log1p(angleEnd(mirror, phi) / c.width);
    const double angle = c.width * std::expm1(k * s), anglePerS = c.width * k * std::exp(k * s);
    const DVec3 wi = mirror.toWorld(
        DVec3(std::sin(angle) * std::cos(phi), std::sin(angle) * std::sin(phi), std::cos(angle)));
    return {wi, 2 * kPi * std::sin(angle) * anglePerS};
}

Placed place(const LeafCase& c, const DVec3& o, int sheet, double s, double t) {
    if (c.aroundMirror) return placeAroundMirror(c, o, s, t);
    if (sheet == 2) return placeElsewhere(c, o, s, t);
    const bool reflected = sheet == 0 || !c.refracts;
    const double phi = 2 * kPi * t, k = rowEnd(c, o, reflected, phi),
                 slope = c.width * std::expm1(k * s);
    const double slopePerS = c.width * k * std::exp(k * s), z = 1 / std::sqrt(1 + slope * slope);
    const DVec3 h{slope * z * std::cos(phi), slope * z * std::sin(phi), z};
    const double normals = slope * slopePerS * 2 * kPi * z * z * z, cosine = glm::dot(o, h);
    if (cosine <= 0) return {};
    const DVec3 mirrorDirection = 2 * cosine * h - o;
    if (reflected) {
        if (mirrorDirection.z <= 0) return {};
        const double flip = sheet == 0 ? 1 : -1;
        return {{mirrorDirection.x, mirrorDirection.y, flip * mirrorDirection.z},
                4 * cosine * normals};
    }
    const double eta = c.eta, cos2 = 1 - eta * eta * (1 - cosine * cosine);
    if (cos2 <= 0) return {};
    const double ct = std::sqrt(cos2), q = eta * cosine - ct;
    const DVec3 wi = q * h - eta * o;
    if (wi.z >= 0) return {};
    return {wi, q * q / ct * normals};
}

DVec3 onUpperSide(const Vec3& w, const Vec3& wo) {
    DVec3 d = glm::normalize(toDouble(w));
    if (wo.z < 0) d.z = -d.z;
    return d;
}

std::vector<double> alphas() {
    return fullCounts() ? std::vector<double>{1e-4, 1e-3, 1e-2, 0.1, 0.3, 0.6, 1}
                        : std::vector<double>{1e-4, 1e-2, 0.1, 0.4, 1};
}

void addMicrofacetCases(std::vector<LeafCase>& cases, double alpha) {
    const float a = static_cast<float>(alpha);
    const std::string at = " alpha " + std::to_string(alpha);
    cases.push_back({"metal" + at, MetalBsdf(Rgb(0.9f, 0.5f, 0.1f), a), 1, alpha});
    for (const float ior : {1.5f, 1.33f}) {
        if (ior != 1.5f && !fullCounts()) break;
        cases.push_back({"glass" + at + " from outside, ior " + std::to_string(ior),
                         RoughGlassBsdf(a), 1 / ior, alpha, true, true});
        cases.push_back({"glass" + at + " from inside, ior " + std::to_string(ior),
                         RoughGlassBsdf(a), ior, alpha, true, true});
    }
    cases.push_back({"thin glass" + at, RoughThinGlassBsdf(1.5f, a), 1, alpha, true});
    cases.push_back({"glossy" + at, GlossyBsdf(Rgb(0.8f, 0.4f, 0.0f), 1.5f, a), 1, alpha});
}

}  // namespace

std::vector<LeafCase> smoothCases() {
    std::vector<LeafCase> cases{
        {"lambert", LambertBsdf{Rgb(0.8f)}},
        {"translucent", TranslucentBsdf(Rgb(0.2f, 0.5f, 0.1f), Rgb(0.3f)), 1, 1, true},
        {"polished glossy", PolishedGlossyBsdf(Rgb(0.9f), 1.5f)},
    };
    for (const float exponent : {0.0f, 1.0f, 32.0f, 1000.0f, 1e6f})
        cases.push_back({"phong " + std::to_string(exponent), PhongBsdf{exponent}, 1,
                         1 / std::sqrt(1.0 + exponent), false, false, true});
    for (const double alpha : alphas()) addMicrofacetCases(cases, alpha);
    return cases;
}

Vec3 viewDirection(double thetaDegrees, double phiDegrees) {
    const double theta = degreesToRadians(thetaDegrees), phi = degreesToRadians(phiDegrees);
    return toFloat(
        {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)});
}

std::vector<Vec3> viewDirections() {
    // Along x at 89.9 degrees: elsewhere a lobe of alpha 1e-4 is no wider than ten steps of a float
    // direction.
    std::vector<Vec3> all{viewDirection(89.9, 0)};
    if (fullCounts()) all.push_back(viewDirection(90.1, 0));
    for (const double theta : {0.0, 30.0, 60.0, 80.0, 89.0}) {
        all.push_back(viewDirection(theta, 25));
        if (fullCounts() || theta == 30.0 || theta == 89.0)
            all.push_back(viewDirection(180 - theta, 200));
    }
    return all;
}

Rgb evalLeaf(const LeafCase& c, const Vec3& wo, const Vec3& wi) {
    return std::visit(
        [&]<class Leaf>(const Leaf& leaf) {
            if constexpr (Leaf::kSmooth)
                return leaf.eval(wo, wi, c.eta);
            else
                return Rgb(0.0f);
        },
        c.leaf);
}
float pdfLeaf(const LeafCase& c, const Vec3& wo, const Vec3& wi) {
    return std::visit(
        [&]<class Leaf>(const Leaf& leaf) {
            if constexpr (Leaf::kSmooth)
                return leaf.pdf(wo, wi, c.eta);
            else
                return 0.0f;
        },
        c.leaf);
}
BsdfSample sampleLeaf(const LeafCase& c, const Vec3& wo, const Vec3& u) {
    return std::visit(
        [&]<class Leaf>(const Leaf& leaf) {
            if constexpr (Leaf::kSmooth) {
                const BsdfSample sample = leaf.sample(wo, u, c.eta);
                return c.crosses || sameSide(wo, sample.wi) ? sample : BsdfSample{};
            } else {
                return BsdfSample{};
            }
        },
        c.leaf);
}

namespace {

int cellAt(const DirectionGrid& grid, int sheet, double s, double azimuth) {
    const double turn = azimuth / (2 * kPi), t = turn < 0 ? turn + 1 : turn;
    const int row = std::min(static_cast<int>(s * grid.rows), grid.rows - 1);
    return (sheet * grid.rows + row) * grid.columns +
           std::min(static_cast<int>(t * grid.columns), grid.columns - 1);
}

}  // namespace

int cellOf(const LeafCase& c, const DirectionGrid& grid, const Vec3& wo, const Vec3& wi) {
    const DVec3 o = onUpperSide(wo, wo);
    DVec3 i = onUpperSide(wi, wo), h;
    if (c.aroundMirror) {
        const Frame mirror = mirrorFrame(o);
        const DVec3 local = mirror.toLocal(i);
        const double phi = std::atan2(local.y, local.x),
                     angle = std::atan2(std::hypot(local.x, local.y), local.z);
        return cellAt(grid, 0,
                      std::log1p(angle / c.width) / std::log1p(angleEnd(mirror, phi) / c.width),
                      phi);
    }
    int sheet = i.z < 0 ? 1 : 0;
    if (sheet == 1 && c.refracts) {
        if (!refractionNormal(c, o, i, h)) {
            const double s = std::log1p(std::abs(i.z) / c.width) / std::log1p(1 / c.width);
            return cellAt(grid, 2, s, std::atan2(i.y, i.x));
        }
    } else {
        i.z = std::abs(i.z);
        h = o + i;
    }
    const double slope = std::hypot(h.x, h.y) / h.z, phi = std::atan2(h.y, h.x);
    const double end = rowEnd(c, o, sheet == 0 || !c.refracts, phi);
    return cellAt(grid, sheet, std::log1p(slope / c.width) / end, phi);
}

namespace {

using Density = std::function<double(const Vec3&)>;
using Rule = std::vector<QuadratureNode>;

/// Directions of one sheet over a rectangle of places.
struct Patch {
    int sheet = 0;
    double s = 0, t = 0, ds = 1, dt = 1;
};

/// The density's integral over a patch; `mixed` tells that directions exist in a part of it only.
double integratePatch(const LeafCase& c, const Vec3& wo, const Patch& patch, const Rule& rows,
                      const Rule& columns, const Density& density, bool& mixed) {
    const DVec3 o = onUpperSide(wo, wo);
    double sum = 0;
    std::size_t found = 0;
    for (const QuadratureNode& a : rows)
        for (const QuadratureNode& b : columns) {
            const Placed placed =
                place(c, o, patch.sheet, patch.s + patch.ds * a.x, patch.t + patch.dt * b.x);
            if (!(placed.jacobian > 0)) continue;
            ++found;
            Vec3 wi = toFloat(placed.wi);
            if (wo.z < 0) wi.z = -wi.z;
            sum += a.weight * b.weight * patch.ds * patch.dt * placed.jacobian * density(wi);
        }
    mixed = found > 0 && found < rows.size() * columns.size();
    return sum;
}

}  // namespace

std::vector<double> integrateCells(const LeafCase& c, const DirectionGrid& grid, const Vec3& wo,
                                   const DirectionGrid& rule, const Density& density,
                                   int firstSheet, int lastSheet) {
    constexpr int kParts = 16;
    const Rule rows = gaussLegendre(rule.rows), columns = gaussLegendre(rule.columns);
    std::vector<double> cells(static_cast<std::size_t>(grid.cells()), 0.0);
    lastSheet = std::min(lastSheet, !c.crosses ? 0 : c.refracts ? 2 : 1);
    for (int cell = firstSheet * grid.sheet(); cell < (lastSheet + 1) * grid.sheet(); ++cell) {
        Patch patch{cell / grid.sheet(),
                    static_cast<double>(cell / grid.columns % grid.rows) / grid.rows,
                    static_cast<double>(cell % grid.columns) / grid.columns, 1.0 / grid.rows,
                    1.0 / grid.columns};
        double& sum = cells[static_cast<std::size_t>(cell)];
        bool mixed = false;
        sum = integratePatch(c, wo, patch, rows, columns, density, mixed);
        if (!mixed) continue;
        // The border of what exists runs through: finer steps.
        sum = 0;
        patch.ds /= kParts;
        for (int part = 0; part < kParts; ++part, patch.s += patch.ds)
            sum += integratePatch(c, wo, patch, rows, columns, density, mixed);
    }
    return cells;
}

double integrateDirections(const LeafCase& c, const Vec3& wo, const Density& density) {
    const auto total = [&](const DirectionGrid& grid, int nodes, int firstSheet, int lastSheet) {
        const std::vector<double> cells =
            integrateCells(c, grid, wo, {nodes, nodes}, density, firstSheet, lastSheet);
        return std::accumulate(cells.begin(), cells.end(), 0.0);
    };
    // Total reflection begins with a square root: more rows where there is refraction.
    if (!c.refracts) return total({24, 32}, 4, 0, 1);
    return total({96, 32}, 3, 0, 0) + total({96, 16}, 3, 1, 1) + total({24, 24}, 2, 2, 2);
}

}  // namespace glint::test
