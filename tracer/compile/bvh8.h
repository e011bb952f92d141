// Builds the hierarchy over blocks of shapes: up to eight children a node, up to eight shapes of
// one kind a leaf. A binary tree by the surface-area heuristic, which counts blocks instead of
// shapes, binned (Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies", 2007) down
// to some hundred shapes and exact below, is made wide where that costs least (Ylitie, Karras,
// Laine, "Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs", HPG 2017, 3.1).
// Where shapes have only moved, refit() does.
#pragma once

#include <functional>
#include <vector>

#include "tracer/base/large_vector.h"
#include "tracer/compile/shape_blocks.h"
#include "tracer/math/types.h"

namespace glint {

/// A shape to sort into the hierarchy: its box, and who it is.
struct BoundedShape {
    DVec3 center;
    float half[3];        ///< of the box's lengths, rounded up
    std::uint32_t index;  ///< in the caller's list; kBallBit is set for balls
};

/// An axis-aligned box; empty to begin with.
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
    /// Of half its surface.
    [[nodiscard]] double area() const {
        const DVec3 e = upper - lower;
        return e.x * e.y + e.y * e.z + e.z * e.x;
    }
};

/// Shapes [begin, begin + count) of the sorted list, all balls or none.
struct Leaf {
    std::uint32_t begin, count;
};

struct Hierarchy {
    /// Without boxes, which refit() makes. Parents come before their children, in large trees the
    /// top levels before all others (kTopNodes). Children that are leaves name blocks, which are
    /// numbered by kind in the order of `leaves`.
    LargeVector<Node8> nodes;
    std::vector<Leaf> leaves;  ///< in the order of their shapes
};

/// Sorts `shapes` (not empty, fewer than 2^30) into leaf order. Large lists are built on up to
/// `threads` threads; the result is the same for any number.
[[nodiscard]] Hierarchy buildHierarchy(std::vector<BoundedShape>& shapes, int threads);

/// The box of a node's child as it is kept, somewhat larger than what it was made from.
[[nodiscard]] Bounds childBounds(const Node8& node, std::size_t child);

/// Makes the boxes of all nodes anew that are above new leaves. `leafBounds` is asked for those of
/// their children that are leaves, whether new or not.
void refit(LargeVector<Node8>& nodes, Coordinates coordinates,
           const std::function<bool(std::uint32_t leaf)>& isNew,
           const std::function<Bounds(std::uint32_t leaf)>& leafBounds);

/// Of all boxes, which rays' visits are in proportion to [m^2].
[[nodiscard]] double boxArea(const LargeVector<Node8>& nodes);

}  // namespace glint
