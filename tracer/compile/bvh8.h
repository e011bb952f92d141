// Builds the hierarchy over blocks of shapes: up to eight children a node, up to eight shapes of
// one kind a leaf. A binary tree (binary_tree.h) is made wide where that costs least (Ylitie,
// Karras, Laine, "Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs", HPG
// 2017, 3.1). Where shapes have only moved, refit() does.
#pragma once

#include <functional>
#include <vector>

#include "tracer/base/large_vector.h"
#include "tracer/compile/binary_tree.h"

namespace glint {

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
