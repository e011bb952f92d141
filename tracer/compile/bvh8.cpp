#include "tracer/compile/bvh8.h"

#include <algorithm>
#include <array>
#include <bit>
#include <span>

#include "tracer/base/check.h"

namespace glint {

namespace {

/// How the up to i + 1 children of a wide node that hold all below a binary one cost least.
struct Collapse {
    std::array<float, kBlockSize> cost{};
    /// How many of them hold what is below `left`; 0: the same as with one less.
    std::array<std::uint8_t, kBlockSize> leftShare{};
};

/// Makes the binary tree a wide one.
class Widening {
  public:
    explicit Widening(BinaryTree tree) : tree_(std::move(tree)), best_(tree_.size()) {}

    Hierarchy run() {
        for (std::size_t i = tree_.size(); i-- > 0;) weigh(i);
        addNode(0);
        topFirst();
        return std::move(out_);
    }

  private:
    /// Costs of a node from those of its children.
    void weigh(std::size_t index) {
        const BinaryNode& node = tree_[index];
        Collapse& best = best_[index];
        const auto area = static_cast<float>(node.bounds.area());
        if (node.isLeaf()) return best.cost.fill(area);
        const Collapse &left = best_[node.left], &right = best_[node.right];
        for (std::size_t i = 1; i < kBlockSize; ++i) {
            best.cost[i] = std::numeric_limits<float>::infinity();
            for (std::size_t k = 0; k < i; ++k)
                if (const float cost = left.cost[k] + right.cost[i - 1 - k]; cost < best.cost[i])
                    best.cost[i] = cost, best.leftShare[i] = static_cast<std::uint8_t>(k + 1);
        }
        best.cost[0] = area + best.cost[kBlockSize - 1];
        for (std::size_t i = 1; i < kBlockSize; ++i)
            if (best.cost[i - 1] <= best.cost[i])
                best.cost[i] = best.cost[i - 1], best.leftShare[i] = 0;
    }

    /// The binary nodes that become the up to `most` children of a wide one, in the order of their
    /// shapes.
    void collect(std::uint32_t index, std::size_t most, std::vector<std::uint32_t>& to) const {
        const BinaryNode& node = tree_[index];
        const Collapse& best = best_[index];
        if (!node.isLeaf())
            while (most > 1 && best.leftShare[most - 1] == 0) --most;
        if (node.isLeaf() || most == 1) return to.push_back(index);
        const std::size_t share = best.leftShare[most - 1];
        collect(node.left, share, to);
        collect(node.right, most - share, to);
    }

    /// Adds the wide node of a binary one and all below it; answers with its index.
    std::uint32_t addNode(std::uint32_t binary) {
        std::vector<std::uint32_t> children;
        const BinaryNode& node = tree_[binary];
        const Collapse& best = best_[binary];
        if (node.isLeaf()) {
            children.push_back(binary);
        } else {
            // All eight places are this node's own to give away, so cost[7] may not stand for the
            // node itself.
            std::size_t most = kBlockSize;
            while (most > 2 && best.leftShare[most - 1] == 0) --most;
            const std::size_t share = std::max<std::size_t>(best.leftShare[most - 1], 1);
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

    BinaryTree tree_;
    std::vector<Collapse> best_;  ///< of each of its nodes
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
    return Widening(growBinaryTree(shapes, threads)).run();
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
