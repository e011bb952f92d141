// Blocks of eight shapes, and the float test that says which of them a ray can possibly hit, and
// from where on. It decides nothing: every shape that it cannot rule out is a Candidate, which
// ShapeLists decides in double. So the answer to a ray is the same on every instruction set, and
// the test may be as coarse as it likes, but never too strict.
//
// Error model. u = 2^-24. Centres and ray origins are kept as float pairs (hi + lo, 48 bits), so
// the vector f from origin to centre has an error of 2u|f| + slack, slack = 16u^2 (coordinates of
// origin and list) + 1e-30: relative to the distance, however far both are from zero. Lists near
// zero use the hi parts alone; the slack is then 4u (coordinates). Directions are unit vectors with
// an error of u.
// - Balls: the computed distance |p| of the centre from the line exceeds the true one by at most
// 11u(|b| + r) + slack
//   wherever the true one is at most r (b: distance along the ray; six roundings of f.d, two of p,
//   three of p.p). A direction that is kUnitTolerance off adds 24u. The test takes 48u, which
//   leaves more than the double predicate's own rounding; the same margin covers the ends of the
//   interval.
// - Boxes: a shape lies within three slabs |row.(x - centre)| <= half, rows of unit length. At a
// hit, t <= |f| + R with R
//   the shape's radius, so the computed slab coordinate is off by at most 15u|f| + 9uR + slack,
//   divisions included when they are read as errors of the slab's faces. The test takes 24u of |f|
//   (1-norm) and R (within `half` already).
// - Nodes, axis by axis: 16u of the origin's distance from the node's corner (Single: from zero),
// 20u
//   of each face's and 8u of the farthest face's, which nothing in between exceeds (both within the
//   face already). A coordinate of the direction below kLeastDirection counts as that much, so that
//   no product overflows. Up to a hit, at most |f| + the node's size away, that shifts the ray by
//   less than the slack and a margin of kLeastDirection times the size (within the face, too).
// Comparisons are written so that NaN, from overflow or 0 * infinity, leaves a candidate standing.
// Underflow to zero, with or without FTZ, loses at most 1e-38, which the slack holds.
#pragma once

#include <cstddef>
#include <cstdint>

namespace glint {

inline constexpr float kBallMargin = 48 * 0x1p-24f, kBoxMargin = 24 * 0x1p-24f,
                       kNodeMargin = 16 * 0x1p-24f;
inline constexpr double kFaceMargin = 20 * 0x1p-24;
inline constexpr float kLeastDirection = 0x1p-64f;
/// How far the squared length of a direction may be from 1; that of directions that were made in
/// floats is.
inline constexpr double kUnitTolerance = 0x1p-20;

inline constexpr int kBlockSize = 8;
inline constexpr std::size_t kBlocksACall = 8;

/// How centres and ray origins are kept. Single takes a tenth less time (glint-bench rays, 64
/// balls), and is good enough where no shape is tiny against its distance from zero.
enum class Coordinates { Single, Pairs };

/// What FilterRay::slack is in proportion to: the largest coordinates of the ray's origin and the
/// list, added.
[[nodiscard]] constexpr double slackFactor(Coordinates coordinates) {
    return coordinates == Coordinates::Single ? 0x1p-22 : 0x1p-44;
}

/// The centres of eight shapes, by coordinate.
template <Coordinates>
struct Centers {
    float hi[3][kBlockSize];
};
template <>
struct Centers<Coordinates::Pairs> {
    float hi[3][kBlockSize], lo[3][kBlockSize];
};

/// Eight balls: columns of floats. Lanes past the block's shapes may hold anything.
template <Coordinates kCoordinates>
struct alignas(64) BallBlock {
    Centers<kCoordinates> center;
    float radius[kBlockSize];  ///< r (1 + kBallMargin)
};

/// Eight shapes of any kind by their bounding boxes in local space, which shear may have turned
/// into parallelepipeds.
template <Coordinates kCoordinates>
struct alignas(32) BoxBlock {
    Centers<kCoordinates> center;
    float row[3][3][kBlockSize];  ///< unit normals of the slabs: row[slab][coordinate]
    float half[3][kBlockSize];    ///< half the slabs' widths [m] + kBoxMargin R
};

/// A node of the hierarchy in two cache lines: the boxes of up to eight children, with eight bits a
/// plane (Ylitie, Karras, Laine, "Efficient Incoherent Ray Traversal on GPUs Through Compressed
/// Wide BVHs", HPG 2017, 3.2).
struct alignas(64) Node8 {
    std::uint8_t planes[6][kBlockSize];  ///< lower x, y, z, upper x, y, z, in steps from the corner
    float cornerHi[3], cornerLo[3];   ///< lower ends of all boxes; lo: 0 with Coordinates::Single
    float step[3];                    ///< [m]
    std::uint32_t children;           ///< a bit each, the lowest
    std::uint32_t child[kBlockSize];  ///< a node's index or leafChild()
    [[nodiscard]] bool has(std::size_t i) const { return children >> i & 1; }
};
static_assert(sizeof(Node8) == 128);
inline constexpr double kMostSteps = 255;
inline constexpr std::uint32_t kLeafBit = 1u << 31;  ///< the child is a block
inline constexpr std::uint32_t kBallBit = 1u << 30;  ///< of balls, else of boxes
/// A block has an index below this.
inline constexpr std::uint32_t kMostBlocks = 1u << 27;

/// A leaf as a node's child: a block with `count` shapes, 1 to kBlockSize.
[[nodiscard]] constexpr std::uint32_t leafChild(bool balls, std::uint32_t block,
                                                std::uint32_t count) {
    return kLeafBit | (balls ? kBallBit : 0u) | ((count - 1) * kMostBlocks) | block;
}
[[nodiscard]] constexpr std::uint32_t blockOf(std::uint32_t leaf) {
    return leaf & (kMostBlocks - 1);
}
[[nodiscard]] constexpr std::uint32_t shapesOf(std::uint32_t leaf) {
    return (leaf / kMostBlocks) % kBlockSize + 1;
}

/// Walks of trees of more nodes (1 MB) look ahead, but not to the nodes of the top levels, which
/// stay in the cache: so many lie before the others.
inline constexpr std::size_t kCachedNodes = 8192;
inline constexpr std::uint32_t kTopNodes = 512;

/// Paths from the root may not be longer.
inline constexpr int kMaxTreeDepth = 56;

/// A ray as the float tests see it.
struct FilterRay {
    float originHi[3], originLo[3];
    float direction[3];  ///< unit length, to kUnitTolerance
    float slack;         ///< see the error model [m]
    float limit;         ///< hits beyond are of no interest; rounded up
};

/// A shape that may be hit, at no less than tLo.
struct Candidate {
    float tLo;
    std::uint32_t slot;
};

/// Slots are kBlockSize times the block's index, plus the lane; those of boxes count from boxSlots.
template <Coordinates kCoordinates>
struct BlockTree {
    const Node8* nodes;
    const BallBlock<kCoordinates>* balls;
    const BoxBlock<kCoordinates>* boxes;
    std::uint32_t boxSlots;
    const void*
        ballShapes;  ///< what decides the balls of block after block, in kBallShapeBytes each
};
inline constexpr std::size_t kBallShapeBytes = std::size_t{40} * kBlockSize;

/// What a walk visited.
struct WalkCounts {
    std::uint32_t nodes = 0, ballBlocks = 0, boxBlocks = 0;
};

/// Decides the candidates of one leaf and answers with the new limit; a negative one ends the walk.
using DecideLeaf = float (*)(void* query, Candidate* candidates, int count);

/// The block tests for one instruction set.
template <Coordinates kCoordinates>
struct BlockKernels {
    const char* name;  ///< of the instruction set
    /// Tests up to eight blocks. Answers with a bit for each lane that may be hit (bit 0: lane 0 of
    /// the first block) and sets those lanes' tLo. Lanes without a shape may come out as hit.
    std::uint64_t (*balls)(const BallBlock<kCoordinates>* blocks, std::size_t count,
                           const FilterRay& ray, float* tLo);
    std::uint64_t (*boxes)(const BoxBlock<kCoordinates>* blocks, std::size_t count,
                           const FilterRay& ray, float* tLo);
    using Walk = WalkCounts (*)(const BlockTree<kCoordinates>& tree, const FilterRay& ray,
                                DecideLeaf decide, void* query);
    /// Visits the leaves along the ray from near to far.
    Walk walk;
    /// The same where memory is what takes the time (0.86 times that of `walk` among 1e7 balls):
    /// the node after the next child is visited ahead of it, so that the children of both come in
    /// at once. It is in vain where the next child ends the ray; 1.13 times as many nodes are
    /// visited.
    Walk walkAhead;
};

/// The kernels for the best instruction set that Highway reports now (tests narrow that by
/// SetSupportedTargetsForTest).
template <Coordinates kCoordinates>
[[nodiscard]] BlockKernels<kCoordinates> blockKernels();
template <>
[[nodiscard]] BlockKernels<Coordinates::Single> blockKernels();
template <>
[[nodiscard]] BlockKernels<Coordinates::Pairs> blockKernels();

}  // namespace glint
