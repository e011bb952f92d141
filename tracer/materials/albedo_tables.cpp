#include "tracer/materials/albedo_tables.h"

#include <algorithm>
#include <vector>

#include "tracer/math/quadrature.h"

namespace glint {
namespace {

// Rows are even in roughness = sqrt(alpha), layers in t = sqrt((n-1)/(n+1)): then losses and the
// critical angle's cosine are nearly linear where they vary most. The metal's rows all come from
// quadrature; of a dielectric's only every fourth, because its tables hold just what its loss
// differs from the metal's times Fresnel's reflectance.
constexpr int kAlphaNodes = 65, kDielectricStep = 4, kIndexNodes = 17;
/// Stands for alpha 0, where the tables have a limit by self-similarity.
constexpr double kTinyAlpha = 1e-6;
constexpr int kAverageSteps = 256;

double indexCoordinate(double n) { return std::sqrt((n - 1) / (n + 1)); }
double indexOfLayer(int layer) {
    const double t = static_cast<double>(layer) / (kIndexNodes - 1), s = t * t;
    return layer == kIndexNodes - 1 ? 1e6 : layer == 0 ? 1 + 1e-9 : (1 + s) / (1 - s);
}
double alphaOfRow(int row) {
    const double roughness = static_cast<double>(row) / (kAlphaNodes - 1);
    return std::max(kTinyAlpha, roughness * roughness);
}

/// Inverse of cosineCoordinate by bisection: it has no closed form and is needed at build only.
double cosineOfCoordinate(double x, double alpha) {
    double low = 0, high = 1;
    for (int step = 0; step < 50; ++step) {
        const double middle = 0.5 * (low + high);
        (cosineCoordinate(middle, alpha) < x ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

/// One table: layers x alphas x (cosines, average).
struct Table {
    std::vector<float> values;

    explicit Table(int layers)
        : values(static_cast<std::size_t>(layers * kAlphaNodes * kRowSize)) {}
    [[nodiscard]] float* row(int layer, int alpha) {
        return values.data() + (layer * kAlphaNodes + alpha) * kRowSize;
    }
    [[nodiscard]] const float* row(int layer, int alpha) const {
        return values.data() + (layer * kAlphaNodes + alpha) * kRowSize;
    }
};

/// Azimuths of the quadrature: many for the metal, whose loss must be right to 1e-4.
const std::vector<QuadratureNode>& manyAzimuths() {
    static const std::vector<QuadratureNode> nodes = gaussLegendre(32);
    return nodes;
}
const std::vector<QuadratureNode>& fewAzimuths() {
    static const std::vector<QuadratureNode> nodes = gaussLegendre(18);
    return nodes;
}

DVec3 directionOf(double cosine) {
    return {std::sqrt(std::max(0.0, 1 - cosine * cosine)), 0, cosine};
}

/// What one visible microfacet sends on after shadowing. `state` names the smooth piece of the
/// integrand it lies in.
struct Kept {
    double reflected = 0, transmitted = 0;
    int state = 0;
};

class Microsurface {
  public:
    /// Seen from the cosine; eta as for leaves, 0 for one that reflects everything.
    Microsurface(double cosine, double alpha, double eta)
        : ggx_(alpha), o_(directionOf(cosine)), eta_(eta) {}

    /// Sum over the visible microfacets by Gauss's rule: over the azimuth, crowded behind the
    /// viewer where the horizon cuts sharply, and over each smooth piece of the other coordinate.
    /// Pieces end where a direction crosses the horizon and where total reflection begins.
    [[nodiscard]] Kept integrate(const std::vector<QuadratureNode>& azimuths) const {
        Kept sum;
        for (const QuadratureNode& node : azimuths)
            addSlice(sum, 0.5 * (1 - node.x * node.x), 2 * node.x * node.weight);
        return sum;
    }

  private:
    static constexpr int kScanSteps = 6, kPieceNodes = 10, kBisections = 14;

    void addSlice(Kept& sum, double azimuth, double weight) const {
        double start = 0, low = 0;
        int state = at(0, azimuth).state;
        for (int j = 1; j <= kScanSteps; ++j) {
            const double high = static_cast<double>(j) / kScanSteps;
            if (const int next = at(high, azimuth).state; next != state) {
                const double end = border(low, high, state, azimuth);
                addPiece(sum, start, end, azimuth, weight);
                start = end;
                state = next;
            }
            low = high;
        }
        addPiece(sum, start, 1, azimuth, weight);
    }
    /// The cubic map crowds the nodes at steep normals, the long tail of GGX.
    [[nodiscard]] Kept at(double v, double azimuth) const {
        const DVec3 h = ggx_.visibleNormal(o_, {azimuth, 1 - v * v * v});
        const double c = glm::dot(o_, h);
        const FresnelTerm fresnel = eta_ > 0 ? fresnelTerm(c, eta_) : FresnelTerm{};
        const DVec3 i = reflectAbout(o_, h);
        Kept kept;
        if (i.z > 0) {
            kept.reflected = fresnel.reflectance * ggx_.shadowing(o_, i);
            kept.state = 1;
        }
        if (fresnel.cosTransmitted > 0) {
            const DVec3 t = (eta_ * c - fresnel.cosTransmitted) * h - eta_ * o_;
            if (t.z < 0) kept.transmitted = (1 - fresnel.reflectance) * ggx_.shadowing(o_, t);
            kept.state += t.z < 0 ? 2 : 4;
        }
        return kept;
    }
    /// Where the state of `low` ends.
    [[nodiscard]] double border(double low, double high, int state, double azimuth) const {
        for (int step = 0; step < kBisections; ++step) {
            const double middle = 0.5 * (low + high);
            (at(middle, azimuth).state == state ? low : high) = middle;
        }
        return 0.5 * (low + high);
    }
    void addPiece(Kept& sum, double start, double end, double azimuth, double share) const {
        static const std::vector<QuadratureNode> nodes = gaussLegendre(kPieceNodes);
        for (const QuadratureNode& node : nodes) {
            const double v = start + (end - start) * node.x;
            const double weight = share * 3 * v * v * (end - start) * node.weight;
            const Kept kept = at(v, azimuth);
            sum.reflected += weight * kept.reflected;
            sum.transmitted += weight * kept.transmitted;
        }
    }

    Ggx ggx_;
    DVec3 o_;
    double eta_;
};

/// Where the averages of one row's functions are taken: even steps of the coordinate, each with its
/// share of the squared cosine.
using AverageRule = std::vector<QuadratureNode>;
const AverageRule& averageRule(int alphaRow) {
    static const std::vector<AverageRule> rules = [] {
        std::vector<AverageRule> all(kAlphaNodes);
        for (int a = 0; a < kAlphaNodes; ++a) {
            double before = 0;
            for (int k = 0; k < kAverageSteps; ++k) {
                const double middle = cosineOfCoordinate((k + 0.5) / kAverageSteps, alphaOfRow(a));
                const double after = cosineOfCoordinate((k + 1.0) / kAverageSteps, alphaOfRow(a));
                all[static_cast<std::size_t>(a)].push_back(
                    {middle, after * after - before * before});
                before = after;
            }
        }
        return all;
    }();
    return rules[static_cast<std::size_t>(alphaRow)];
}

/// Fills the averages of a layer: those of its interpolated functions plus base(cosine, alpha,
/// layer).
template <class Base>
void fillAverages(Table& table, int layer, const Base& base) {
    for (int a = 0; a < kAlphaNodes; ++a) {
        float* row = table.row(layer, a);
        const CosineCurve<1> curve(alphaOfRow(a), {row}, {1.0f});
        double sum = 0;
        for (const QuadratureNode& node : averageRule(a))
            sum += node.weight * (curve(node.x) + base(node.x, alphaOfRow(a), layer));
        row[kCosineNodes] = static_cast<float>(sum);
    }
}

/// Fills the rows between every `step`-th, cubic in roughness.
void refine(Table& table, int layer, int step) {
    for (int a = 0; a < kAlphaNodes; ++a) {
        if (a % step == 0) continue;
        const int first = std::clamp(a / step - 1, 0, (kAlphaNodes - 1) / step - 3);
        const auto w = cubicWeights(static_cast<double>(a) / step - first - 1);
        for (int c = 0; c < kCosineNodes; ++c) {
            double sum = 0;
            for (int k = 0; k < 4; ++k)
                sum += w[static_cast<std::size_t>(k)] * table.row(layer, (first + k) * step)[c];
            table.row(layer, a)[c] = static_cast<float>(sum);
        }
    }
}

/// value(cosine, alpha, layer) - base(cosine, alpha, layer) at every `step`-th row; averages are
/// those of the value.
template <class Value, class Base>
Table makeTable(int layers, int step, const Value& value, const Base& base) {
    Table table(layers);
    for (int layer = 0; layer < layers; ++layer) {
        for (int a = 0; a < kAlphaNodes; a += step)
            for (int c = 0; c < kCosineNodes; ++c) {
                const double alpha = alphaOfRow(a), x = static_cast<double>(c) / (kCosineNodes - 1);
                // At the horizon itself the quotients are 0/0: the limit is next to it.
                const double cosine = std::max(1e-6 * alpha, cosineOfCoordinate(x, alpha));
                table.row(layer, a)[c] =
                    static_cast<float>(value(cosine, alpha, layer) - base(cosine, alpha, layer));
            }
        refine(table, layer, step);
        fillAverages(table, layer, base);
    }
    return table;
}

struct Cell {
    int index;
    float fraction;
};
Cell cellOf(double place, int nodes) {
    const double x = std::clamp(place, 0.0, 1.0) * (nodes - 1);
    const int index = std::min(static_cast<int>(x), nodes - 2);
    return {index, static_cast<float>(x - index)};
}

CosineCurve<4> curveOf(const Table& table, double alpha, double n) {
    const Cell a = cellOf(std::sqrt(alpha), kAlphaNodes),
               t = cellOf(indexCoordinate(n), kIndexNodes);
    return {alpha,
            {table.row(t.index, a.index), table.row(t.index, a.index + 1),
             table.row(t.index + 1, a.index), table.row(t.index + 1, a.index + 1)},
            {(1 - t.fraction) * (1 - a.fraction), (1 - t.fraction) * a.fraction,
             t.fraction * (1 - a.fraction), t.fraction * a.fraction}};
}

double lossAt(double cosine, double alpha, double eta) {
    const Kept kept = Microsurface(cosine, alpha, eta).integrate(fewAzimuths());
    return 1 - kept.reflected - kept.transmitted;
}
double etaOfThinSide(int layer) { return 1 / indexOfLayer(layer); }

const Table& thinSideLoss() {
    static const Table table = makeTable(
        kIndexNodes, kDielectricStep,
        [](double cosine, double alpha, int layer) {
            return lossAt(cosine, alpha, etaOfThinSide(layer));
        },
        [](double cosine, double alpha, int layer) {
            return fresnelTerm(cosine, etaOfThinSide(layer)).reflectance * metalLoss(alpha)(cosine);
        });
    return table;
}
const Table& denseSideLoss() {
    static const Table table = makeTable(
        kIndexNodes, kDielectricStep,
        [](double cosine, double alpha, int layer) {
            return lossAt(cosine, alpha, indexOfLayer(layer));
        },
        [](double cosine, double alpha, int) { return metalLoss(alpha)(cosine); });
    return table;
}
const Table& coatTable() {
    static const Table table = makeTable(
        kIndexNodes, kDielectricStep,
        [](double cosine, double alpha, int layer) {
            return 1 - Microsurface(cosine, alpha, etaOfThinSide(layer))
                           .integrate(fewAzimuths())
                           .reflected;
        },
        [](double cosine, double alpha, int layer) {
            return 1 - fresnelTerm(cosine, etaOfThinSide(layer)).reflectance *
                           (1 - metalLoss(alpha)(cosine));
        });
    return table;
}

const Table& metalTable() {
    static const Table table = makeTable(
        1, 1,
        [](double cosine, double a, int) {
            return 1 - Microsurface(cosine, a, 0).integrate(manyAzimuths()).reflected;
        },
        [](double, double, int) { return 0.0; });
    return table;
}

}  // namespace

MetalCurve metalLoss(double alpha) {
    const Table& table = metalTable();
    // Cubic in roughness too: energy is conserved to 1e-4 by this curve.
    const double place = std::sqrt(std::clamp(alpha, 0.0, 1.0)) * (kAlphaNodes - 1);
    const int first = std::clamp(static_cast<int>(place) - 1, 0, kAlphaNodes - 4);
    const std::array<double, 4> w = cubicWeights(place - first - 1);
    return {alpha,
            {table.row(0, first), table.row(0, first + 1), table.row(0, first + 2),
             table.row(0, first + 3)},
            {static_cast<float>(w[0]), static_cast<float>(w[1]), static_cast<float>(w[2]),
             static_cast<float>(w[3])}};
}

DielectricLoss dielectricLoss(double alpha, double eta) {
    const double n = std::max(eta, 1 / eta);
    return {eta, metalLoss(alpha), curveOf(eta < 1 ? thinSideLoss() : denseSideLoss(), alpha, n)};
}

CoatPassing coatPassing(double alpha, double ior) {
    return {ior, metalLoss(alpha), curveOf(coatTable(), alpha, std::max(1.0, ior))};
}

CoatPassing::CoatPassing(double ior, const MetalCurve& metal, const CosineCurve<4>& residual)
    : eta_(1 / ior), metal_(metal), residual_(residual) {
    static const std::vector<QuadratureNode> nodes = gaussLegendre(48);
    for (const QuadratureNode& node : nodes) average_ += 2 * node.weight * node.x * (*this)(node.x);
}

double averageFresnel(double eta) {
    constexpr int kNodes = 129;
    static const std::vector<double> averages = [] {
        std::vector<double> all(kNodes, 0.0);
        for (int k = 1; k < kNodes; ++k) {
            const double t = static_cast<double>(k) / (kNodes - 1), s = t * t;
            const double inverse = (1 - s) / (1 + s);
            for (const QuadratureNode& node : gaussLegendre(64))
                all[static_cast<std::size_t>(k)] +=
                    2 * node.weight * node.x * fresnelTerm(node.x, inverse).reflectance;
        }
        return all;
    }();
    const double n = std::max(eta, 1 / eta), place = indexCoordinate(n) * (kNodes - 1);
    const int first = std::clamp(static_cast<int>(place) - 1, 0, kNodes - 4);
    const std::array<double, 4> w = cubicWeights(place - first - 1);
    double thin = 0;
    for (int k = 0; k < 4; ++k)
        thin += w[static_cast<std::size_t>(k)] * averages[static_cast<std::size_t>(first + k)];
    // The dense side's average follows from reciprocity: n^2 (1 - F) is equal on both sides.
    return eta > 1 ? 1 - (1 - thin) / (n * n) : thin;
}

}  // namespace glint
