#include "tracer/compile/binary_tree.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <numeric>
#include <span>
#include <thread>

#include "tracer/base/check.h"

namespace glint {

namespace {

constexpr int kBins = 16;
/// A range that is no larger is cut by looking at every cut, so that its leaves come out full; one
/// that is no larger than kManyAxes, along every axis.
constexpr std::uint32_t kSwept = 512, kManyAxes = 64;
/// A range of both kinds that is no larger is parted by kind, so that its leaves come out full.
constexpr std::uint32_t kPartByKind = 16;
/// From here on halves are taken by count, which bounds the depth by twice this (kMaxTreeDepth).
constexpr int kMedianDepth = kMaxTreeDepth / 2;
/// Below this many shapes threads cost more than they give.
constexpr std::size_t kParallelFrom = 20000;
/// Parts of the tree that threads build side by side.
constexpr std::size_t kParts = 16;

/// Shapes [begin, end) of the list.
struct Range {
    std::uint32_t begin = 0, end = 0;
    Bounds bounds, centers;
    bool balls = false, boxes = false;
    [[nodiscard]] std::uint32_t count() const { return end - begin; }
    [[nodiscard]] bool isLeaf() const { return count() <= kBlockSize && !(balls && boxes); }
};

/// Visits of blocks and nodes cost alike; this is what fewer shapes than a block cost too.
double blocks(std::uint32_t count) {
    const std::uint32_t whole = (count + kBlockSize - 1) / kBlockSize;
    return whole;
}

/// A range that shapes are added to one by one.
struct GrowingRange {
    Bounds bounds = {};
    std::uint32_t balls = 0, boxes = 0;
    /// Answers with the cost of all together.
    double add(const BoundedShape& s) {
        bounds.add(s.bounds());
        ++(s.index & kBallBit ? balls : boxes);
        return bounds.area() * (blocks(balls) + blocks(boxes));
    }
};

class Builder {
  public:
    explicit Builder(std::span<BoundedShape> shapes) : shapes_(shapes) {}

    BinaryTree build(int threads) {
        const bool parallel = threads > 1 && shapes_.size() >= kParallelFrom;
        grow(parallel ? threads : 1);
        return std::move(tree_);
    }

  private:
    [[nodiscard]] Range measure(std::uint32_t begin, std::uint32_t end) const {
        Range r{begin, end, {}, {}, false, false};
        for (const BoundedShape& s : shapes_.subspan(begin, end - begin)) {
            r.bounds.add(s.bounds());
            r.centers.add(s.center);
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
            bounds[bin].add(s.bounds());
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

    /// The cut of least cost between the shapes in their order along an axis.
    struct Sweep {
        double cost = kInfinity;
        std::uint32_t cut = 1;
        std::array<std::uint16_t, kSwept> order{};  ///< places in the range
    };
    [[nodiscard]] Sweep sweepAlong(const Range& r, int axis) const {
        const auto list = shapes_.subspan(r.begin, r.count());
        Sweep out;
        const auto order = std::span(out.order).first(list.size());
        std::iota(order.begin(), order.end(), std::uint16_t{0});
        std::ranges::stable_sort(order, {}, [&](std::uint16_t i) { return list[i].center[axis]; });
        std::array<double, kSwept> right;
        GrowingRange sum;
        for (std::uint32_t i = r.count(); i-- > 1;) right[i] = sum.add(list[order[i]]);
        sum = {};
        for (std::uint32_t i = 1; i < r.count(); ++i)
            if (const double cost = sum.add(list[order[i - 1]]) + right[i]; cost < out.cost)
                out.cost = cost, out.cut = i;
        return out;
    }

    /// Parts few shapes by the best of all cuts.
    std::pair<Range, Range> sweep(const Range& r, int longestAxis) {
        Sweep best = sweepAlong(r, longestAxis);
        for (int axis = 0; axis < 3 && r.count() <= kManyAxes; ++axis)
            if (axis != longestAxis)
                if (const Sweep other = sweepAlong(r, axis); other.cost < best.cost) best = other;
        const auto list = shapes_.subspan(r.begin, r.count());
        std::array<BoundedShape, kSwept> before;
        std::ranges::copy(list, before.begin());
        for (std::size_t i = 0; i < list.size(); ++i) list[i] = before[best.order[i]];
        return {measure(r.begin, r.begin + best.cut), measure(r.begin + best.cut, r.end)};
    }

    template <class GoesLeft>
    std::pair<Range, Range> part(const Range& r, GoesLeft&& goesLeft) {
        const auto list = shapes_.subspan(r.begin, r.count());
        const auto middle =
            r.begin + static_cast<std::uint32_t>(
                          std::partition(list.begin(), list.end(), goesLeft) - list.begin());
        return {measure(r.begin, middle), measure(middle, r.end)};
    }

    /// Parts a range in two, none of them empty.
    std::pair<Range, Range> split(const Range& r, int depth) {
        if (r.balls && r.boxes && r.count() <= kPartByKind)
            return part(r, [](const BoundedShape& s) { return (s.index & kBallBit) != 0; });
        const DVec3 extent = r.centers.upper - r.centers.lower;
        const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0
                         : extent.y >= extent.z                       ? 1
                                                                      : 2;
        const Binning binning{axis, r.centers.lower[axis], kBins * (1 - 1e-9) / extent[axis]};
        if (depth < kMedianDepth && std::isfinite(binning.scale)) {
            if (r.count() <= kSwept) return sweep(r, axis);
            if (const int cut = chooseCut(r, binning); cut > 0)
                return part(r, [&](const BoundedShape& s) { return binning.bin(s) < cut; });
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

    static std::uint32_t add(BinaryTree& tree, const Range& r) {
        GLINT_CHECK(tree.size() < kBallBit);
        tree.push_back({r.bounds, r.begin, r.count(), r.balls});
        return static_cast<std::uint32_t>(tree.size() - 1);
    }

    /// The binary tree over a range whose node is there already.
    void grow(BinaryTree& tree, std::uint32_t index, const Range& r, int depth) {
        GLINT_CHECK(depth < kMaxTreeDepth);
        if (!r.isLeaf()) {
            const auto [left, right] = split(r, depth);
            const std::uint32_t l = add(tree, left);
            grow(tree, l, left, depth + 1);
            const std::uint32_t at = add(tree, right);
            grow(tree, at, right, depth + 1);
            tree[index].left = l, tree[index].right = at;
        }
    }

    /// A part of the tree that is grown for itself.
    struct Part {
        Range range;
        std::uint32_t node;  ///< of tree_
        int depth;
        BinaryTree tree = {};
    };

    /// The whole binary tree. Its top is parted here; what is below on that many threads.
    void grow(int threads) {
        const Range all = measure(0, static_cast<std::uint32_t>(shapes_.size()));
        add(tree_, all);
        if (threads == 1) return grow(tree_, 0, all, 0);
        std::vector<Part> parts{{all, 0, 0}};
        while (parts.size() < kParts) {
            const auto largest = std::max_element(
                parts.begin(), parts.end(),
                [](const Part& a, const Part& b) { return a.range.count() < b.range.count(); });
            const auto [left, right] = split(largest->range, largest->depth);
            const std::uint32_t l = add(tree_, left), at = add(tree_, right);
            tree_[largest->node].left = l, tree_[largest->node].right = at;
            *largest = {left, l, largest->depth + 1};
            parts.push_back({right, at, largest->depth});
        }
        // Claims a part; joining the threads orders the results (relaxed is enough).
        std::atomic<std::size_t> next{0};
        const auto work = [&] {
            for (std::size_t i;
                 (i = next.fetch_add(1, std::memory_order_relaxed)) < parts.size();) {
                add(parts[i].tree, parts[i].range);
                grow(parts[i].tree, 0, parts[i].range, parts[i].depth);
            }
        };
        {
            std::vector<std::jthread> helpers;
            for (int i = 1; i < threads; ++i) helpers.emplace_back(work);
            work();
        }
        for (Part& p : parts) join(p);
    }

    /// Puts a part's tree where its node is.
    void join(Part& p) {
        const auto offset = static_cast<std::uint32_t>(tree_.size()) - 1;  // Its root stays out.
        const auto moved = [&](BinaryNode node) {
            if (!node.isLeaf()) node.left += offset, node.right += offset;
            return node;
        };
        tree_[p.node] = moved(p.tree[0]);
        for (std::size_t i = 1; i < p.tree.size(); ++i) tree_.push_back(moved(p.tree[i]));
        p.tree = {};
    }

    std::span<BoundedShape> shapes_;
    BinaryTree tree_;
};

}  // namespace

BinaryTree growBinaryTree(std::vector<BoundedShape>& shapes, int threads) {
    GLINT_CHECK(!shapes.empty() && shapes.size() < kBallBit);
    return Builder(shapes).build(threads);
}

}  // namespace glint
