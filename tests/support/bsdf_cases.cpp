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
                 r = std::sqrt(std::max(0.0, 1 - z * z));
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

constexpr std::array kAir{1.0f};
constexpr std::array kAirAndWater{1.0f, 1.33f};

void addMicrofacetCases(std::vector<LeafCase>& cases, double alpha) {
    const float a = static_cast<float>(alpha);
    const std::string at = " alpha " + std::to_string(alpha);
    cases.push_back({"metal" + at, MetalBsdf(Rgb(0.9f, 0.5f, 0.1f), a), 1, alpha});
    for (const float ior : {1.5f, 1.33f}) {
        if (ior != 1.5f && !fullCounts()) break;
        cases.push_back({"glass" + at + " from outside, ior " + std::to_string(ior),
                         RoughGlassBsdf(a, std::array{ior}), 1 / ior, alpha, true, true});
        cases.push_back({"glass" + at + " from inside, ior " + std::to_string(ior),
                         RoughGlassBsdf(a, std::array{ior}), ior, alpha, true, true});
    }
    cases.push_back({"thin glass" + at, RoughThinGlassBsdf(1.5f, a, kAir), 1, alpha, true});
    cases.push_back({"glossy" + at, GlossyBsdf(Rgb(0.8f, 0.4f, 0.0f), 1.5f, a, kAir), 1, alpha});
    cases.push_back({"glossy in water" + at,
                     GlossyBsdf(Rgb(0.8f, 0.4f, 0.0f), 1.5f, a, kAirAndWater), 1.33f, alpha});
}

}  // namespace

std::vector<LeafCase> smoothCases() {
    std::vector<LeafCase> cases{
        {"lambert", LambertBsdf{Rgb(0.8f)}},
        {"translucent", TranslucentBsdf(Rgb(0.2f, 0.5f, 0.1f), Rgb(0.3f)), 1, 1, true},
        {"polished glossy", PolishedGlossyBsdf(Rgb(0.9f), 1.5f, kAir)},
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
    // Along x at 89.9 degrees, and with the finer cells of the full form at 89: elsewhere a lobe of
    // alpha 1e-4 is no wider than ten steps of a float direction.
    std::vector<Vec3> all{viewDirection(89.9, 0)};
    if (fullCounts()) all.push_back(viewDirection(90.1, 0));
    for (const double theta : {0.0, 30.0, 60.0, 80.0, 89.0}) {
        const double turn = fullCounts() && theta == 89.0 ? 0 : 25;
        all.push_back(viewDirection(theta, turn));
        if (fullCounts() || theta == 30.0 || theta == 89.0)
            all.push_back(viewDirection(180 - theta, turn + 175));
    }
    return all;
}

Rgb evalLeaf(const LeafCase& c, const Vec3& wo, const Vec3& wi) {
    return std::visit(
        [&]<class Leaf>(const Leaf& leaf) {
            if constexpr (Leaf::kSmooth)
                return leaf.value(wo, wi, c.eta).f;
            else
                return Rgb(0.0f);
        },
        c.leaf);
}
float pdfLeaf(const LeafCase& c, const Vec3& wo, const Vec3& wi) {
    return std::visit(
        [&]<class Leaf>(const Leaf& leaf) {
            if constexpr (Leaf::kSmooth)
                return leaf.value(wo, wi, c.eta).pdf;
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

/// The smooth piece of the density that a place lies in; 0 where there is no direction.
int pieceAt(const LeafCase& c, const DVec3& o, int sheet, double s, double t) {
    const Placed placed = place(c, o, sheet, s, t);
    if (!(placed.jacobian > 0)) return 0;
    if (sheet > 0 || !c.refracts || c.eta <= 1) return 1;
    // Total reflection begins with a square root.
    const double cosine = glm::dot(o, glm::normalize(o + placed.wi)), eta = c.eta;
    return 1 - eta * eta * (1 - cosine * cosine) > 0 ? 1 : 2;
}

/// The integral over s in [start, start + size) at one t, each smooth piece by itself.
double integrateColumn(const LeafCase& c, const Vec3& wo, int sheet, double start, double size,
                       double t, const Rule& rule, const Density& density) {
    constexpr int kScanSteps = 4, kBisections = 40;
    const DVec3 o = onUpperSide(wo, wo);
    double sum = 0;
    const auto addPiece = [&](double from, double to, bool cut) {
        for (const QuadratureNode& node : rule) {
            // Square roots at a border become smooth.
            const double x = cut ? node.x * node.x * (3 - 2 * node.x) : node.x;
            const double weight = cut ? node.weight * 6 * node.x * (1 - node.x) : node.weight;
            const Placed placed = place(c, o, sheet, from + (to - from) * x, t);
            Vec3 wi = toFloat(placed.wi);
            if (wo.z < 0) wi.z = -wi.z;
            if (placed.jacobian > 0) sum += weight * (to - from) * placed.jacobian * density(wi);
        }
    };
    double from = start;
    int piece = pieceAt(c, o, sheet, start, t);
    for (int k = 1; k <= kScanSteps; ++k) {
        double low = start + size * (k - 1) / kScanSteps, high = start + size * k / kScanSteps;
        const int next = pieceAt(c, o, sheet, high, t);
        if (next == piece) continue;
        for (int step = 0; step < kBisections; ++step) {
            const double middle = 0.5 * (low + high);
            (pieceAt(c, o, sheet, middle, t) == piece ? low : high) = middle;
        }
        if (piece != 0) addPiece(from, low, true);
        from = high;
        piece = next;
    }
    if (piece != 0) addPiece(from, start + size, from > start);
    return sum;
}

}  // namespace

std::vector<double> integrateCells(const LeafCase& c, const DirectionGrid& grid, const Vec3& wo,
                                   const DirectionGrid& rule, const Density& density,
                                   int firstSheet, int lastSheet) {
    const Rule rows = gaussLegendre(rule.rows), columns = gaussLegendre(rule.columns);
    std::vector<double> cells(static_cast<std::size_t>(grid.cells()), 0.0);
    lastSheet = std::min(lastSheet, !c.crosses ? 0 : c.refracts ? 2 : 1);
    for (int cell = firstSheet * grid.sheet(); cell < (lastSheet + 1) * grid.sheet(); ++cell) {
        const int row = cell / grid.columns % grid.rows, column = cell % grid.columns;
        for (const QuadratureNode& node : columns)
            cells[static_cast<std::size_t>(cell)] +=
                node.weight / grid.columns *
                integrateColumn(c, wo, cell / grid.sheet(), static_cast<double>(row) / grid.rows,
                                1.0 / grid.rows, (column + node.x) / grid.columns, rows, density);
    }
    return cells;
}

namespace {

/// The integral over [0, 1] of what piece(from, to) gives the integral of with few points: halved
/// where that is not enough.
template <class Piece>
double halvedIntegral(const Piece& piece) {
    constexpr int kParts = 16, kDeepest = 8;
    constexpr double kTolerance =
        1e-4;  // What is left is far below it: it bounds the worse of two values.
    const auto halve = [&](const auto& self, double from, double to, double whole,
                           int depth) -> double {
        const double middle = 0.5 * (from + to), left = piece(from, middle),
                     right = piece(middle, to);
        if (depth == kDeepest || std::abs(left + right - whole) <= kTolerance * (to - from))
            return left + right;
        return self(self, from, middle, left, depth + 1) + self(self, middle, to, right, depth + 1);
    };
    double sum = 0;
    for (int part = 0; part < kParts; ++part) {
        const double from = static_cast<double>(part) / kParts, to = (part + 1.0) / kParts;
        sum += halve(halve, from, to, piece(from, to), 0);
    }
    return sum;
}

}  // namespace

double integrateDirections(const LeafCase& c, const Vec3& wo, const Density& density) {
    const Rule rule = gaussLegendre(4);
    double total = 0;
    for (int sheet = 0; sheet <= (!c.crosses ? 0 : c.refracts ? 2 : 1); ++sheet) {
        const auto column = [&](double t) {
            return halvedIntegral([&](double from, double to) {
                return integrateColumn(c, wo, sheet, from, to - from, t, rule, density);
            });
        };
        total += halvedIntegral([&](double from, double to) {
            double sum = 0;
            for (const QuadratureNode& node : rule)
                sum += node.weight * (to - from) * column(from + (to - from) * node.x);
            return sum;
        });
    }
    return total;
}

}  // namespace glint::test
