#include "tracer/compile/bvh8.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
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
    return static_cast<double>((count + kBlockSize - 1) / kBlockSize);
}

/// A range that shapes are added to one by one.
struct GrowingRange {
    Bounds bounds = {};
    std::uint32_t balls = 0, boxes = 0;
    /// Answers with the cost of all together.
    double add(const BoundedShape& s) {
        bounds.add(s);
        ++(s.index & kBallBit ? balls : boxes);
        return bounds.area() * (blocks(balls) + blocks(boxes));
    }
};

/// A node of the binary tree, which the wide one is made from.
struct BinaryNode {
    Bounds bounds;
    std::uint32_t begin = 0, count = 0;
    bool balls = false;
    std::uint32_t left = 0, right = 0;  ///< 0: a leaf
    /// cost[i]: of the least expensive up to i + 1 children of a wide node that hold all below;
    /// leftShare[i]: how many of these hold what is below `left`, 0: the same as with one less.
    std::array<float, kBlockSize> cost{};
    std::array<std::uint8_t, kBlockSize> leftShare{};

    [[nodiscard]] bool isLeaf() const { return left == 0; }
};
using BinaryTree = std::vector<BinaryNode>;

class Builder {
  public:
    explicit Builder(std::span<BoundedShape> shapes) : shapes_(shapes) {}

    Hierarchy build(int threads) {
        const bool parallel = threads > 1 && shapes_.size() >= kParallelFrom;
        grow(parallel ? threads : 1);
        addNode(0);
        topFirst();
        return std::move(out_);
    }

  private:
    [[nodiscard]] Range measure(std::uint32_t begin, std::uint32_t end) const {
        Range r{begin, end, {}, {}, false, false};
        for (const BoundedShape& s : shapes_.subspan(begin, end - begin)) {
            r.bounds.add(s);
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
        weigh(tree, index);
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
        const std::size_t top = tree_.size();
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
        for (std::size_t i = top; i-- > 0;)
            if (tree_[i].cost[0] == 0) weigh(tree_, static_cast<std::uint32_t>(i));
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

    /// Costs of a node from those of its children (Ylitie et al., 3.1).
    static void weigh(BinaryTree& tree, std::uint32_t index) {
        BinaryNode& node = tree[index];
        const auto area = static_cast<float>(node.bounds.area());
        if (node.isLeaf()) return node.cost.fill(area);
        const BinaryNode &left = tree[node.left], &right = tree[node.right];
        for (std::size_t i = 1; i < kBlockSize; ++i) {
            node.cost[i] = std::numeric_limits<float>::infinity();
            for (std::size_t k = 0; k < i; ++k)
                if (const float cost = left.cost[k] + right.cost[i - 1 - k]; cost < node.cost[i])
                    node.cost[i] = cost, node.leftShare[i] = static_cast<std::uint8_t>(k + 1);
        }
        node.cost[0] = area + node.cost[kBlockSize - 1];
        for (std::size_t i = 1; i < kBlockSize; ++i)
            if (node.cost[i - 1] <= node.cost[i])
                node.cost[i] = node.cost[i - 1], node.leftShare[i] = 0;
    }

    /// The binary nodes that become the up to `most` children of a wide one, in the order of their
    /// shapes.
    void collect(std::uint32_t index, std::size_t most, std::vector<std::uint32_t>& to) const {
        const BinaryNode& node = tree_[index];
        if (!node.isLeaf())
            while (most > 1 && node.leftShare[most - 1] == 0) --most;
        if (node.isLeaf() || most == 1) return to.push_back(index);
        const std::size_t share = node.leftShare[most - 1];
        collect(node.left, share, to);
        collect(node.right, most - share, to);
    }

    /// Adds the wide node of a binary one and all below it; answers with its index.
    std::uint32_t addNode(std::uint32_t binary) {
        std::vector<std::uint32_t> children;
        const BinaryNode& node = tree_[binary];
        if (node.isLeaf()) {
            children.push_back(binary);
        } else {
            // All eight places are this node's own to give away, so cost[7] may not stand for the
            // node itself.
            std::size_t most = kBlockSize;
            while (most > 2 && node.leftShare[most - 1] == 0) --most;
            const std::size_t share = std::max<std::size_t>(node.leftShare[most - 1], 1);
            collect(node.left, share, children);
            collect(node.right, most - share, children);
        }
        const auto index = static_cast<std::uint32_t>(out_.nodes.size());
        out_.nodes.emplace_back().children = (1u << children.size()) - 1;
        for (std::size_t i = 0; i < children.size(); ++i) {
            const std::uint32_t child = addChild(children[i]);
            out_.nodes[index].child[i] = child;
        }
        return index;
    }

    std::uint32_t addChild(std::uint32_t binary) {
        const BinaryNode& node = tree_[binary];
        if (!node.isLeaf()) return addNode(binary);
        out_.leaves.push_back({node.begin, node.count});
        std::uint32_t& blocks = node.balls ? ballBlocks_ : boxBlocks_;
        GLINT_CHECK(blocks < kMostBlocks);
        return leafChild(node.balls, blocks++, node.count);
    }

    /// Moves about kTopNodes, level by level, in front of the others, which keep their order.
    void topFirst() {
        const LargeVector<Node8>& from = out_.nodes;
        if (from.size() <= kCachedNodes) return;
        const auto below = [&](std::uint32_t node, const auto& use) {
            for (std::size_t i = 0; i < kBlockSize && from[node].has(i); ++i)
                if (!(from[node].child[i] & kLeafBit)) use(from[node].child[i]);
        };
        std::vector<std::uint32_t> order{0};
        for (std::size_t i = 0; order.size() < kTopNodes; ++i)
            below(order[i], [&](std::uint32_t child) { order.push_back(child); });
        std::vector<bool> isTop(from.size());
        for (const std::uint32_t node : order) isTop[node] = true;
        for (std::uint32_t node = 0; node < from.size(); ++node)
            if (!isTop[node]) order.push_back(node);
        std::vector<std::uint32_t> newOf(from.size());
        for (std::uint32_t i = 0; i < order.size(); ++i) newOf[order[i]] = i;
        LargeVector<Node8> to(from.size());
        for (std::uint32_t i = 0; i < order.size(); ++i) {
            to[i] = from[order[i]];
            for (std::uint32_t& child : to[i].child)
                if (!(child & kLeafBit)) child = newOf[child];
        }
        out_.nodes = std::move(to);
    }

    std::span<BoundedShape> shapes_;
    BinaryTree tree_;
    Hierarchy out_;
    std::uint32_t ballBlocks_ = 0, boxBlocks_ = 0;
};

/// The largest float up to x.
float roundDown(double x) {
    const auto near = static_cast<float>(x);
    return static_cast<double>(near) > x
               ? std::nextafter(near, -std::numeric_limits<float>::infinity())
               : near;
}

/// The node's planes: whole steps, outwards by the filter's margins (shape_blocks.h).
void setBoxes(Node8& node, Coordinates coordinates, std::span<const Bounds> children) {
    Bounds all;
    for (const Bounds& child : children) all.add(child);
    constexpr double kFarthestMargin = 8 * 0x1p-24, kLeastStep = 1e-30;
    const double sizeMargin = double{kLeastDirection} * coordinateSum(all.upper - all.lower);
    const bool single = coordinates == Coordinates::Single;
    for (int axis = 0; axis < 3; ++axis) {
        const double lowest = all.lower[axis], highest = all.upper[axis],
                     from = single ? 0.0 : lowest,
                     farthest = std::max(std::abs(lowest - from), std::abs(highest - from)),
                     margin = kFarthestMargin * farthest + sizeMargin;
        const auto face = [&](double x, double outwards) {
            return x + outwards * (kFaceMargin * std::abs(x - from) + margin);
        };
        const float hi = roundDown(face(lowest, -1)),
                    lo = single ? 0.0f : roundDown(face(lowest, -1) - static_cast<double>(hi));
        const double corner = static_cast<double>(hi) + static_cast<double>(lo);
        const double least = (face(highest, 1) - corner) / kMostSteps;
        // Rounded up, so that the quotients below stay within eight bits.
        const float step = -roundDown(-std::max(least * (1 + 0x1p-50), kLeastStep));
        node.cornerHi[axis] = hi, node.cornerLo[axis] = lo, node.step[axis] = step;
        const auto steps = [&](double x) { return (x - corner) / static_cast<double>(step); };
        for (std::size_t i = 0; i < children.size(); ++i) {
            node.planes[axis][i] =
                static_cast<std::uint8_t>(steps(face(children[i].lower[axis], -1)));
            node.planes[axis + 3][i] =
                static_cast<std::uint8_t>(std::ceil(steps(face(children[i].upper[axis], 1))));
        }
    }
}

/// Coordinate of the plane that many steps from the node's corner.
double planeAt(const Node8& node, int axis, double steps) {
    return double{node.cornerHi[axis]} + double{node.cornerLo[axis]} +
           double{node.step[axis]} * steps;
}

/// A box around all of the node's children. It depends on them through a margin alone, not on the
/// steps between the planes, so that boxes do not grow by being made again and again.
Bounds allBounds(const Node8& node) {
    Bounds out;
    for (int axis = 0; axis < 3; ++axis) {
        out.lower[axis] = planeAt(node, axis, 0);
        out.upper[axis] = planeAt(node, axis, kMostSteps);
    }
    return out;
}

}  // namespace

Hierarchy buildHierarchy(std::vector<BoundedShape>& shapes, int threads) {
    GLINT_CHECK(!shapes.empty() && shapes.size() < kBallBit);
    return Builder(shapes).build(threads);
}

Bounds childBounds(const Node8& node, std::size_t child) {
    Bounds out;
    for (int axis = 0; axis < 3; ++axis) {
        out.lower[axis] = planeAt(node, axis, node.planes[axis][child]);
        out.upper[axis] = planeAt(node, axis, node.planes[axis + 3][child]);
    }
    return out;
}

void refit(LargeVector<Node8>& nodes, Coordinates coordinates,
           const std::function<bool(std::uint32_t)>& isNew,
           const std::function<Bounds(std::uint32_t)>& leafBounds) {
    std::vector<bool> remade(nodes.size());
    for (std::size_t n = nodes.size(); n-- > 0;) {
        Node8& node = nodes[n];
        const std::span children(node.child,
                                 static_cast<std::size_t>(std::popcount(node.children)));
        remade[n] = std::ranges::any_of(children, [&](std::uint32_t child) {
            return child & kLeafBit ? isNew(child) : remade[child];
        });
        if (!remade[n]) continue;
        std::array<Bounds, kBlockSize> bounds;
        for (std::size_t i = 0; i < children.size(); ++i)
            bounds[i] =
                children[i] & kLeafBit ? leafBounds(children[i]) : allBounds(nodes[children[i]]);
        setBoxes(node, coordinates, std::span(bounds).first(children.size()));
    }
}

double boxArea(const LargeVector<Node8>& nodes) {
    double area = 0;
    for (const Node8& node : nodes)
        for (std::size_t i = 0; i < kBlockSize && node.has(i); ++i)
            area += childBounds(node, i).area();
    return area;
}

}  // namespace glint
