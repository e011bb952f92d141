#include "tracer/compile/bvh8.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <span>
#include <thread>

#include "tracer/base/check.h"

namespace glint {

namespace {

constexpr int kBins = 16;
/// A range of both kinds that is no larger is parted by kind, so that its leaves come out full.
constexpr std::uint32_t kPartByKind = 16;
/// From here on halves are taken by count, which bounds the depth by twice this (kMaxTreeDepth).
constexpr int kMedianDepth = kMaxTreeDepth / 2;
/// Below this many shapes threads cost more than they give.
constexpr std::size_t kParallelFrom = 20000;

struct Bounds {
    DVec3 lower{kInfinity}, upper{-kInfinity};
    void add(const DVec3& p) { lower = glm::min(lower, p), upper = glm::max(upper, p); }
    void add(const Bounds& b) {
        lower = glm::min(lower, b.lower), upper = glm::max(upper, b.upper);
    }
    void add(const BoundedShape& s) {
        const DVec3 half(s.half[0], s.half[1], s.half[2]);
        lower = glm::min(lower, s.center - half), upper = glm::max(upper, s.center + half);
    }
    [[nodiscard]] double area() const {
        const DVec3 e = upper - lower;
        return e.x * e.y + e.y * e.z + e.z * e.x;
    }
};

struct Range {
    std::uint32_t begin = 0, end = 0;
    Bounds bounds;
    bool balls = false, boxes = false;
    [[nodiscard]] std::uint32_t count() const { return end - begin; }
    [[nodiscard]] bool isLeaf() const { return count() <= kBlockSize && !(balls && boxes); }
};

double blocks(std::uint32_t count) {
    return static_cast<double>((count + kBlockSize - 1) / kBlockSize);
}

class Builder {
  public:
    explicit Builder(std::span<BoundedShape> shapes) : shapes_(shapes) {}

    Hierarchy build(int threads) {
        const Range all = measure(0, static_cast<std::uint32_t>(shapes_.size()));
        if (threads < 2 || shapes_.size() < kParallelFrom) {
            Hierarchy out;
            addNode(out, all, 0);
            return out;
        }
        return buildParallel(all, threads);
    }

  private:
    [[nodiscard]] Range measure(std::uint32_t begin, std::uint32_t end) const {
        Range r{begin, end, {}, false, false};
        for (const BoundedShape& s : shapes_.subspan(begin, end - begin)) {
            r.bounds.add(s);
            (s.index & kBallBit ? r.balls : r.boxes) = true;
        }
        return r;
    }

    /// Bins of the centres along one axis.
    struct Binning {
        int axis = 0;
        double origin = 0, scale = 0;
        [[nodiscard]] int bin(const BoundedShape& s) const {
            return std::min(kBins - 1, static_cast<int>((s.center[axis] - origin) * scale));
        }
    };

    /// Where the surface-area heuristic cuts: shapes in bins below `cut` go left. 0: no cut parts
    /// them.
    int chooseCut(const Range& r, const Binning& binning) const {
        std::array<Bounds, kBins> bounds;
        std::array<std::uint32_t, kBins> counts{};
        for (const BoundedShape& s : shapes_.subspan(r.begin, r.count())) {
            const auto bin = static_cast<std::size_t>(binning.bin(s));
            bounds[bin].add(s);
            ++counts[bin];
        }
        std::array<double, kBins> right{};
        Bounds sum;
        std::uint32_t count = 0;
        for (std::size_t i = kBins - 1; i > 0; --i) {
            sum.add(bounds[i]);
            count += counts[i];
            right[i] = count ? sum.area() * blocks(count) : kInfinity;
        }
        sum = {}, count = 0;
        int cut = 0;
        double best = kInfinity;
        for (std::size_t i = 1; i < kBins; ++i) {
            sum.add(bounds[i - 1]);
            count += counts[i - 1];
            const double cost = count ? sum.area() * blocks(count) + right[i] : kInfinity;
            if (cost < best) best = cost, cut = static_cast<int>(i);
        }
        return cut;
    }

    template <class GoesLeft>
    std::uint32_t part(const Range& r, GoesLeft&& goesLeft) {
        const auto list = shapes_.subspan(r.begin, r.count());
        const auto middle = std::partition(list.begin(), list.end(), goesLeft);
        return r.begin + static_cast<std::uint32_t>(middle - list.begin());
    }

    /// Parts a range in two, none of them empty.
    std::pair<Range, Range> split(const Range& r, int depth) {
        if (r.balls && r.boxes && r.count() <= kPartByKind) {
            const auto middle =
                part(r, [](const BoundedShape& s) { return (s.index & kBallBit) != 0; });
            return {measure(r.begin, middle), measure(middle, r.end)};
        }
        Bounds centers;
        for (const BoundedShape& s : shapes_.subspan(r.begin, r.count())) centers.add(s.center);
        const DVec3 extent = centers.upper - centers.lower;
        const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0
                         : extent.y >= extent.z                       ? 1
                                                                      : 2;
        const Binning binning{axis, centers.lower[axis], kBins * (1 - 1e-9) / extent[axis]};
        if (depth < kMedianDepth && std::isfinite(binning.scale)) {
            if (const int cut = chooseCut(r, binning); cut > 0) {
                const auto middle =
                    part(r, [&](const BoundedShape& s) { return binning.bin(s) < cut; });
                return {measure(r.begin, middle), measure(middle, r.end)};
            }
        }
        return splitByCount(r, axis);
    }

    /// Halves of more than a block, in whole blocks.
    std::pair<Range, Range> splitByCount(const Range& r, int axis) {
        const std::uint32_t half = (r.count() / 2 + kBlockSize - 1) / kBlockSize * kBlockSize;
        const auto list = shapes_.subspan(r.begin, r.count());
        std::nth_element(list.begin(), list.begin() + half, list.end(),
                         [axis](const BoundedShape& a, const BoundedShape& b) {
                             return a.center[axis] < b.center[axis];
                         });
        return {measure(r.begin, r.begin + half), measure(r.begin + half, r.end)};
    }

    /// Splits the largest part until there are eight or all are leaves. In the order of their
    /// shapes.
    std::vector<Range> partition(const Range& r, int depth) {
        std::vector<Range> parts{r};
        while (parts.size() < kBlockSize) {
            const auto largest =
                std::max_element(parts.begin(), parts.end(), [](const Range& a, const Range& b) {
                    const bool aLeaf = a.isLeaf(), bLeaf = b.isLeaf();
                    return aLeaf != bLeaf ? aLeaf : a.bounds.area() < b.bounds.area();
                });
            if (largest->isLeaf()) break;
            const auto [left, right] = split(*largest, depth);
            *largest = left;
            parts.push_back(right);
        }
        std::sort(parts.begin(), parts.end(),
                  [](const Range& a, const Range& b) { return a.begin < b.begin; });
        return parts;
    }

    /// Adds the node of a range and all below it; answers with its index.
    std::uint32_t addNode(Hierarchy& out, const Range& r, int depth) {
        GLINT_CHECK(depth < kMaxTreeDepth);
        const std::vector<Range> parts = partition(r, depth);
        const auto index = static_cast<std::uint32_t>(out.nodes.size());
        out.nodes.push_back(makeNode(r.bounds, parts));
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const std::uint32_t child = addChild(out, parts[i], depth + 1);
            out.nodes[index].child[i] = child;
        }
        return index;
    }

    std::uint32_t addChild(Hierarchy& out, const Range& r, int depth) {
        if (!r.isLeaf()) return addNode(out, r, depth);
        out.leaves.push_back({r.begin, r.count()});
        return kLeafBit | (r.balls ? kBallBit : 0u) |
               static_cast<std::uint32_t>(out.leaves.size() - 1);
    }

    /// The root's children are built side by side and then joined in their order.
    Hierarchy buildParallel(const Range& all, int threads) {
        const std::vector<Range> parts = partition(all, 0);
        std::vector<Hierarchy> below(parts.size());
        std::vector<std::uint32_t> roots(parts.size());
        std::atomic<std::size_t> next{
            0};  // Claims a part; joining the threads orders the results (relaxed is enough).
        const auto work = [&] {
            for (std::size_t i; (i = next.fetch_add(1, std::memory_order_relaxed)) < parts.size();)
                roots[i] = addChild(below[i], parts[i], 1);
        };
        {
            std::vector<std::jthread> helpers;
            for (int i = 1; i < threads; ++i) helpers.emplace_back(work);
            work();
        }
        Hierarchy out;
        out.nodes.push_back(makeNode(all.bounds, parts));
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const auto nodeOffset = static_cast<std::uint32_t>(out.nodes.size()),
                       leafOffset = static_cast<std::uint32_t>(out.leaves.size());
            const auto moved = [&](std::uint32_t child) {
                return child + (child & kLeafBit ? leafOffset : nodeOffset);
            };
            out.nodes[0].child[i] = moved(roots[i]);
            for (Node8 node : below[i].nodes) {
                for (int c = 0; c < kBlockSize; ++c)
                    if (node.planes[0][c] <= node.planes[3][c])
                        node.child[c] = moved(node.child[c]);
                out.nodes.push_back(node);
            }
            out.leaves.insert(out.leaves.end(), below[i].leaves.begin(), below[i].leaves.end());
            below[i] = {};
        }
        return out;
    }

    static Node8 makeNode(const Bounds& bounds, const std::vector<Range>& parts) {
        Node8 node{};
        const DVec3 middle = 0.5 * (bounds.lower + bounds.upper);
        for (int axis = 0; axis < 3; ++axis) {
            const auto hi = static_cast<float>(middle[axis]);
            const auto lo = static_cast<float>(middle[axis] - static_cast<double>(hi));
            node.centerHi[axis] = hi, node.centerLo[axis] = lo;
            const double center = static_cast<double>(hi) + static_cast<double>(lo);
            for (std::size_t i = 0; i < kBlockSize; ++i) {
                const bool used = i < parts.size();
                node.planes[axis][i] = used ? face(parts[i].bounds.lower[axis] - center, -1)
                                            : std::numeric_limits<float>::infinity();
                node.planes[axis + 3][i] = used ? face(parts[i].bounds.upper[axis] - center, 1)
                                                : -std::numeric_limits<float>::infinity();
            }
        }
        return node;
    }
    /// A face of a child's box, moved outwards by the filter's margin and over its own rounding.
    static float face(double x, double outwards) {
        return static_cast<float>(x + outwards * std::abs(x) * (kFaceMargin + 0x1p-23));
    }

    std::span<BoundedShape> shapes_;
};

}  // namespace

Hierarchy buildHierarchy(std::vector<BoundedShape>& shapes, int threads) {
    GLINT_CHECK(!shapes.empty() && shapes.size() < kBallBit);
    return Builder(shapes).build(threads);
}

}  // namespace glint
