// Sorts shapes into a binary tree by the surface-area heuristic, which counts blocks of eight
// shapes of one kind instead of shapes: binned (Wald, "On fast Construction of SAH-based Bounding
// Volume Hierarchies", 2007) down to some hundred shapes and exact below. bvh8.h makes wide nodes
// of it.
#pragma once

#include <vector>

#include "tracer/compile/shape_blocks.h"
#include "tracer/math/bounds.h"

namespace glint {

/// A shape to sort into the hierarchy: its box, and who it is.
struct BoundedShape {
    DVec3 center;
    float half[3];        ///< of the box's lengths, rounded up
    std::uint32_t index;  ///< in the caller's list; kBallBit is set for balls

    [[nodiscard]] Bounds bounds() const {
        return Bounds::around(center, {half[0], half[1], half[2]});
    }
};

/// A node of the binary tree, over shapes [begin, begin + count) of the sorted list.
struct BinaryNode {
    Bounds bounds;
    std::uint32_t begin = 0, count = 0;
    bool balls = false;                 ///< some of the shapes are
    std::uint32_t left = 0, right = 0;  ///< 0: a leaf, of one kind and no more than a block

    [[nodiscard]] bool isLeaf() const { return left == 0; }
};
/// The root is the first, and children come after their parents.
using BinaryTree = std::vector<BinaryNode>;

/// Sorts `shapes` (not empty, fewer than 2^30) into the order of the tree's leaves. Large lists are
/// sorted on up to `threads` threads; the result is the same for any number. No path from the root
/// is longer than kMaxTreeDepth.
[[nodiscard]] BinaryTree growBinaryTree(std::vector<BoundedShape>& shapes, int threads);

}  // namespace glint
