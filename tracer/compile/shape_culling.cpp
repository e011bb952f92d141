// Which shapes a bundle of rays can meet. One search for a tile of the film serves all of its
// camera rays. No packets of rays: in float alone and with no hit described they would take 0.34 (4
// balls), 0.59 (16), 1.3 (64) and 2.3 (128) of the time of such single rays (glint-bench rays).
#include <cstring>

#include "tracer/compile/bvh8.h"
#include "tracer/compile/shape_lists.h"

namespace glint {

namespace {

/// Copies one shape's column of floats.
template <class Block>
void copyLane(Block& to, std::size_t toLane, const Block& from, std::size_t fromLane) {
    static_assert(sizeof(Block) % (kBlockSize * sizeof(float)) == 0);
    for (std::size_t row = 0; row < sizeof(Block) / sizeof(float); row += kBlockSize)
        std::memcpy(reinterpret_cast<char*>(&to) + sizeof(float) * (row + toLane),
                    reinterpret_cast<const char*>(&from) + sizeof(float) * (row + fromLane),
                    sizeof(float));
}

template <class Block>
void addLane(LargeVector<Block>& blocks, std::vector<std::uint32_t>& slots, const Block& from,
             std::size_t lane, std::uint32_t slot) {
    if (slots.size() % kBlockSize == 0) blocks.emplace_back();
    copyLane(blocks.back(), slots.size() % kBlockSize, from, lane);
    slots.push_back(slot);
}

/// More than what rounding takes off an extent.
constexpr double kExtentMargin = 1 + 1e-5;

}  // namespace

template <Coordinates kCoordinates>
bool ShapeLists::cullBlocks(const RayBundle& bundle, FewShapes& few) const {
    using Few = Blocks<kCoordinates>;
    if (!std::holds_alternative<Few>(few.blocks)) few.blocks.emplace<Few>();
    Few& to = std::get<Few>(few.blocks);
    const Few& from = std::get<Few>(blocks_);
    to.balls.clear(), to.boxes.clear(), few.balls.clear(), few.boxes.clear();
    to.kernels = from.kernels;

    const auto addBall = [&](const BallBlock<kCoordinates>& block, std::size_t lane,
                             std::uint32_t slot) {
        const Ball& ball = balls_[slot];
        const double radius = kExtentMargin / ball.inverseRadius;
        if (!bundle.misses(ball.center, [&](const DVec3&) { return radius; }))
            addLane(to.balls, few.balls, block, lane, slot);
    };
    const auto addBox = [&](const BoxBlock<kCoordinates>& block, std::size_t lane,
                            std::uint32_t slot) {
        const Entry& entry = boxes_[slot - ballSlots_];
        const DMat3 axes = glm::inverse(entry.localFromWorld);
        const DVec3 half = kExtentMargin * localHalf(entry.shape);
        const auto extent = [&](const DVec3& normal) {
            return glm::dot(absolute(normal * axes), half);
        };
        if (!bundle.misses(entry.center, extent)) addLane(to.boxes, few.boxes, block, lane, slot);
    };

    if (nodes_.empty()) {
        for (std::uint32_t i = 0; i < ballSlots_; ++i)
            addBall(from.balls[i / kBlockSize], i % kBlockSize, i);
        for (std::uint32_t i = 0; i < boxSlots_; ++i)
            addBox(from.boxes[i / kBlockSize], i % kBlockSize, ballSlots_ + i);
        return few.balls.size() + few.boxes.size() <= kMostFew;
    }
    std::uint32_t waiting[7 * kMaxTreeDepth + 8] = {0};
    for (std::size_t count = 1; count > 0;) {
        const Node8& node = nodes_[waiting[--count]];
        for (std::size_t i = 0; i < kBlockSize && node.has(i); ++i) {
            const std::uint32_t child = node.child[i];
            const Bounds box = childBounds(node, i);
            const DVec3 half = 0.5 * (box.upper - box.lower);
            const auto extent = [&](const DVec3& normal) {
                return kExtentMargin * glm::dot(absolute(normal), half);
            };
            if (bundle.misses(0.5 * (box.lower + box.upper), extent)) continue;
            if (!(child & kLeafBit)) {
                waiting[count++] = child;
                continue;
            }
            const std::uint32_t block = blockOf(child), first = kBlockSize * block;
            for (std::uint32_t lane = 0; lane < shapesOf(child); ++lane)
                child& kBallBit ? addBall(from.balls[block], lane, first + lane)
                                : addBox(from.boxes[block], lane, ballSlots_ + first + lane);
        }
        if (few.balls.size() + few.boxes.size() > kMostFew) return false;
    }
    return true;
}

bool ShapeLists::cull(const RayBundle& bundle, FewShapes& few) const {
    if (unfiltered_) return false;
    return std::holds_alternative<Blocks<Coordinates::Single>>(blocks_)
               ? cullBlocks<Coordinates::Single>(bundle, few)
               : cullBlocks<Coordinates::Pairs>(bundle, few);
}

}  // namespace glint
