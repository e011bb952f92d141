// Builds the hierarchy over blocks of shapes: up to eight children a node, up to eight shapes of
// one kind a leaf. Binned surface-area heuristic (Wald, "On fast Construction of SAH-based Bounding
// Volume Hierarchies", 2007) that counts blocks instead of shapes; the children of a node come from
// splitting the largest until there are eight.
#pragma once

#include <vector>

#include "tracer/compile/shape_blocks.h"
#include "tracer/math/types.h"

namespace glint {

/// A shape to sort into the hierarchy: its box, and who it is.
struct BoundedShape {
    DVec3 center;
    float half[3];        ///< of the box's lengths, rounded up
    std::uint32_t index;  ///< in the caller's list; kBallBit is set for balls
};

/// Shapes [begin, begin + count) of the sorted list, all balls or none.
struct Leaf {
    std::uint32_t begin, count;
};

struct Hierarchy {
    std::vector<Node8> nodes;  ///< the root first; children of leaves name `leaves` by kLeafBit |
                               ///< kBallBit? | index
    std::vector<Leaf> leaves;  ///< in the order of their shapes
};

/// Sorts `shapes` (not empty, fewer than 2^30) into leaf order. Large lists are built on up to
/// `threads` threads; the result is the same for any number.
[[nodiscard]] Hierarchy buildHierarchy(std::vector<BoundedShape>& shapes, int threads);

}  // namespace glint
