// Compiled once an instruction set: AVX2 (eight lanes), SSE4 (four, twice) and plain code as the
// last resort.
#include "tracer/compile/shape_blocks.h"

#include <algorithm>
#include <bit>
#include <cmath>

#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/compile/shape_blocks.cpp"
#include <hwy/foreach_target.h>
// foreach_target.h has to come first.
#include <hwy/highway.h>

#include <hwy/cache_control.h>

HWY_BEFORE_NAMESPACE();
namespace glint::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::CappedTag<float, kBlockSize>;
using V = hn::Vec<Tag>;
using M = hn::Mask<Tag>;
constexpr Tag kTag;

/// The ray in every lane.
struct RayLanes {
    V hi[3], lo[3], d[3], slack, limit;
};
HWY_INLINE RayLanes spread(const FilterRay& ray) {
    const auto set = [](float x) HWY_ATTR { return hn::Set(kTag, x); };
    return {{set(ray.originHi[0]), set(ray.originHi[1]), set(ray.originHi[2])},
            {set(ray.originLo[0]), set(ray.originLo[1]), set(ray.originLo[2])},
            {set(ray.direction[0]), set(ray.direction[1]), set(ray.direction[2])},
            set(ray.slack),
            set(ray.limit)};
}

/// From the ray's origin to the centres, along one axis.
template <Coordinates kCoordinates>
HWY_INLINE V toCenter(const Centers<kCoordinates>& center, const RayLanes& ray, int axis,
                      std::size_t lane) {
    const V hi = hn::Sub(hn::Load(kTag, center.hi[axis] + lane), ray.hi[axis]);
    if constexpr (kCoordinates == Coordinates::Single)
        return hi;
    else
        return hn::Add(hi, hn::Sub(hn::Load(kTag, center.lo[axis] + lane), ray.lo[axis]));
}
HWY_INLINE V dot(V x, V y, V z, V ax, V ay, V az) {
    return hn::MulAdd(z, az, hn::MulAdd(y, ay, hn::Mul(x, ax)));
}

/// The part of the ray within a shape's bounds; `miss` where there surely is none before the limit.
struct Interval {
    V tLo;
    M miss;
};
HWY_INLINE Interval interval(V t0, V t1, M outside, const RayLanes& ray) {
    const V zero = hn::Zero(kTag);
    return {hn::Max(t0, zero), hn::Or(outside, hn::Or(hn::Lt(t1, zero), hn::Gt(t0, ray.limit)))};
}

/// Perpendicular distance against the radius, as in CanonicalSphere.
template <Coordinates kCoordinates>
HWY_INLINE Interval test(const BallBlock<kCoordinates>& block, const RayLanes& ray,
                         std::size_t lane) {
    const V fx = toCenter(block.center, ray, 0, lane), fy = toCenter(block.center, ray, 1, lane),
            fz = toCenter(block.center, ray, 2, lane);
    const V radius = hn::Load(kTag, block.radius + lane), margin = hn::Set(kTag, kBallMargin);
    const V b = dot(fx, fy, fz, ray.d[0], ray.d[1], ray.d[2]);
    const V px = hn::NegMulAdd(b, ray.d[0], fx), py = hn::NegMulAdd(b, ray.d[1], fy),
            pz = hn::NegMulAdd(b, ray.d[2], fz);
    const V error = hn::MulAdd(margin, hn::Abs(b), ray.slack), reach = hn::Add(radius, error);
    const M outside = hn::Gt(dot(px, py, pz, px, py, pz), hn::Mul(reach, reach));
    // The ends b -/+ reach instead of those on the ball spare a square root: 14 against 12 Mray/s
    // with 128 balls, and no loss in the hierarchy.
    const V half = hn::MulAdd(margin, radius, reach);
    return interval(hn::Sub(b, half), hn::Add(b, half), outside, ray);
}

/// Three slabs.
template <Coordinates kCoordinates>
HWY_INLINE Interval test(const BoxBlock<kCoordinates>& block, const RayLanes& ray,
                         std::size_t lane) {
    const V fx = toCenter(block.center, ray, 0, lane), fy = toCenter(block.center, ray, 1, lane),
            fz = toCenter(block.center, ray, 2, lane);
    const V length = hn::Add(hn::Abs(fx), hn::Add(hn::Abs(fy), hn::Abs(fz)));
    const V error = hn::MulAdd(hn::Set(kTag, kBoxMargin), length, ray.slack),
            one = hn::Set(kTag, 1.0f);
    V t0[3], t1[3];
#pragma GCC unroll 3
    for (int slab = 0; slab < 3; ++slab) {
        const auto& row = block.row[slab];
        const V nx = hn::Load(kTag, row[0] + lane), ny = hn::Load(kTag, row[1] + lane),
                nz = hn::Load(kTag, row[2] + lane);
        const V q = dot(fx, fy, fz, nx, ny, nz),
                half = hn::Add(hn::Load(kTag, block.half[slab] + lane), error);
        const V inverse = hn::Div(one, dot(ray.d[0], ray.d[1], ray.d[2], nx, ny, nz));
        const V a = hn::Mul(hn::Sub(q, half), inverse), b = hn::Mul(hn::Add(q, half), inverse);
        t0[slab] = hn::Min(a, b), t1[slab] = hn::Max(a, b);
    }
    const V enter = hn::Max(hn::Max(t0[0], t0[1]), t0[2]),
            leave = hn::Min(hn::Min(t1[0], t1[1]), t1[2]);
    return interval(enter, leave, hn::Gt(enter, leave), ray);
}

HWY_INLINE std::uint32_t bitsOf(M mask) {
    std::uint8_t bytes[8];
    hn::StoreMaskBits(kTag, mask, bytes);
    return bytes[0] & ((1u << hn::Lanes(kTag)) - 1);
}

template <class Block>
HWY_INLINE std::uint32_t scanBlock(const Block& block, const RayLanes& ray, float* tLo) {
    std::uint32_t missed = 0;
    for (std::size_t lane = 0; lane < kBlockSize; lane += hn::Lanes(kTag)) {
        const Interval result = test(block, ray, lane);
        missed |= bitsOf(result.miss) << lane;
        hn::StoreU(result.tLo, kTag, tLo + lane);
    }
    return ~missed & 0xFFu;
}

template <class Block>
std::uint64_t scan(const Block* blocks, std::size_t count, const FilterRay& ray, float* tLo) {
    const RayLanes lanes = spread(ray);
    std::uint64_t candidates = 0;
    for (std::size_t i = 0; i < count; ++i)
        candidates |= std::uint64_t{scanBlock(blocks[i], lanes, tLo + kBlockSize * i)}
                      << (kBlockSize * i);
    return candidates;
}

/// What the walk knows of the ray beside its lanes.
struct NodeRay {
    V inverse[3];
    float sign[3];  ///< of the direction's coordinates
    int nearPlane[3], farPlane[3];
};

/// When the ray passes the three planes through some point, early for faces that it enters by and
/// late for those that it leaves by.
struct PlaneTimes {
    V enter[3], leave[3];
    /// `o`: the ray's origin as seen from that point.
    HWY_INLINE void set(const FilterRay& ray, const NodeRay& walk, int axis, float o) {
        const float error = std::copysign(kNodeMargin * std::abs(o) + ray.slack, walk.sign[axis]);
        enter[axis] = hn::Mul(hn::Set(kTag, -o - error), walk.inverse[axis]);
        leave[axis] = hn::Mul(hn::Set(kTag, error - o), walk.inverse[axis]);
    }
};

/// Eight bits a lane as floats.
HWY_INLINE V steps(const std::uint8_t* from) {
    constexpr hn::RebindToSigned<Tag> kInts;
    constexpr hn::Rebind<std::uint8_t, Tag> kBytes;
    return hn::ConvertTo(kTag, hn::PromoteTo(kInts, hn::LoadU(kBytes, from)));
}

/// Which children the ray meets, and where from. `times`: of zero with Single coordinates, else of
/// the node's corner.
template <Coordinates kCoordinates>
HWY_INLINE std::uint32_t testNode(const Node8& node, const PlaneTimes& times, const NodeRay& walk,
                                  float limit, float* tNear) {
    std::uint32_t hits = 0;
    for (std::size_t lane = 0; lane < kBlockSize; lane += hn::Lanes(kTag)) {
        V enter = hn::Zero(kTag), leave = hn::Set(kTag, limit);
#pragma GCC unroll 3
        for (int axis = 0; axis < 3; ++axis) {
            const V inverse = walk.inverse[axis];
            const V step = hn::Mul(hn::Set(kTag, node.step[axis]), inverse);
            V first = times.enter[axis], last = times.leave[axis];
            if constexpr (kCoordinates == Coordinates::Single) {
                const V corner = hn::Set(kTag, node.cornerHi[axis]);
                first = hn::MulAdd(corner, inverse, first),
                last = hn::MulAdd(corner, inverse, last);
            }
            const std::uint8_t *front = node.planes[walk.nearPlane[axis]] + lane,
                               *back = node.planes[walk.farPlane[axis]] + lane;
            enter = hn::Max(hn::MulAdd(steps(front), step, first), enter);
            leave = hn::Min(hn::MulAdd(steps(back), step, last), leave);
        }
        hn::Store(enter, kTag, tNear + lane);
        hits |= bitsOf(hn::Le(enter, leave)) << lane;
    }
    return hits & node.children;
}

/// A child whose turn will come, in one word: halves that are stored one by one and loaded at once
/// stall the processor (6 % of the time of shadow rays among 1000 balls). The upper half is tNear,
/// whose bits have its order because it is not negative.
struct Waiting {
    std::uint64_t bits;
    HWY_INLINE static Waiting of(float tNear, std::uint32_t child) {
        return {std::uint64_t{std::bit_cast<std::uint32_t>(tNear)} << 32U | child};
    }
    [[nodiscard]] HWY_INLINE float tNear() const {
        return std::bit_cast<float>(static_cast<std::uint32_t>(bits >> 32U));
    }
    [[nodiscard]] HWY_INLINE std::uint32_t child() const {
        return static_cast<std::uint32_t>(bits);
    }
};

template <std::size_t kBytes>
HWY_INLINE void prefetch(const void* from) {
#pragma GCC unroll 16
    for (std::size_t at = 0; at < kBytes; at += 64)
        hwy::Prefetch(static_cast<const char*>(from) + at);
}

/// Has a child brought into the cache before its turn comes: 1.5 times the rays from 1e5 balls on,
/// no loss at 1e3.
template <Coordinates kCoordinates>
HWY_INLINE void prefetch(const BlockTree<kCoordinates>& tree, std::uint32_t child) {
    if (!(child & kLeafBit)) return prefetch<sizeof(Node8)>(tree.nodes + child);
    const std::uint32_t block = blockOf(child);
    if (!(child & kBallBit)) return prefetch<sizeof(BoxBlock<kCoordinates>)>(tree.boxes + block);
    prefetch<sizeof(BallBlock<kCoordinates>)>(tree.balls + block);
}

/// Puts the children that are hit on the stack, the nearest on top of all from `base` on.
template <Coordinates kCoordinates>
HWY_INLINE Waiting* pushHits(const BlockTree<kCoordinates>& tree, const Node8& node,
                             std::uint32_t hits, const float* tNear, Waiting* base, Waiting* top) {
    for (; hits != 0; hits &= hits - 1) {
        const auto i = static_cast<std::uint32_t>(std::countr_zero(hits));
        const Waiting added = Waiting::of(tNear[i], node.child[i]);
        prefetch(tree, node.child[i]);
        Waiting* at = top++;
        for (; at != base && at[-1].bits < added.bits; --at) *at = at[-1];
        *at = added;
    }
    return top;
}

/// Decides the candidates of a leaf, whose slots begin with `first`; answers with the new limit.
template <class Block>
HWY_INLINE float visitLeaf(const Block& block, std::uint32_t first, std::uint32_t shapes,
                           const RayLanes& ray, float limit, DecideLeaf decide, void* query) {
    alignas(64) float tLo[kBlockSize];
    std::uint32_t bits = scanBlock(block, ray, tLo);
    if (bits == 0) return limit;
    bits &= (1u << shapes) - 1;
    Candidate found[kBlockSize];
    int count = 0;
    for (; bits != 0; bits &= bits - 1) {
        const auto lane = static_cast<std::uint32_t>(std::countr_zero(bits));
        found[count++] = {tLo[lane], first + lane};
    }
    return decide(query, found, count);
}

/// Puts the children of a node that the ray meets on the stack.
template <Coordinates kCoordinates>
HWY_INLINE Waiting* visitNode(const BlockTree<kCoordinates>& tree, std::uint32_t index,
                              const FilterRay& ray, const NodeRay& walk, PlaneTimes& times,
                              float limit, Waiting* base, Waiting* top) {
    alignas(64) float tNear[kBlockSize];
    const Node8& node = tree.nodes[index];
    if constexpr (kCoordinates == Coordinates::Pairs)
        for (int axis = 0; axis < 3; ++axis)
            times.set(ray, walk, axis,
                      (ray.originHi[axis] - node.cornerHi[axis]) +
                          (ray.originLo[axis] - node.cornerLo[axis]));
    const std::uint32_t hits = testNode<kCoordinates>(node, times, walk, limit, tNear);
    return pushHits(tree, node, hits, tNear, base, top);
}

/// Whether a node is visited ahead of the child before it: one that the cache may not hold.
HWY_INLINE bool isWorthAhead(const Waiting& second, float limit) {
    return !(second.child() & kLeafBit) && second.child() >= kTopNodes && second.tNear() <= limit;
}

enum class Ahead { No, Yes };

template <Coordinates kCoordinates, Ahead kAhead>
WalkCounts walkTree(const BlockTree<kCoordinates>& tree, const FilterRay& ray, DecideLeaf decide,
                    void* query) {
    RayLanes lanes = spread(ray);
    float limit = ray.limit;
    NodeRay walk;
    PlaneTimes times;
    for (int axis = 0; axis < 3; ++axis) {
        const float d = ray.direction[axis];
        walk.inverse[axis] =
            hn::Set(kTag, 1.0f / std::copysign(std::max(std::abs(d), kLeastDirection), d));
        walk.sign[axis] = d;
        if constexpr (kCoordinates == Coordinates::Single)
            times.set(ray, walk, axis, ray.originHi[axis]);
        walk.nearPlane[axis] = std::signbit(d) ? axis + 3 : axis;
        walk.farPlane[axis] = std::signbit(d) ? axis : axis + 3;
    }
    // Each level leaves up to 7 children waiting, or 15 of two nodes that were visited at once.
    Waiting stack[kAhead == Ahead::Yes ? 15 * kMaxTreeDepth + 16 : 7 * kMaxTreeDepth + 8];
    Waiting* top = stack;
    *top++ = Waiting::of(0, 0);
    WalkCounts counts;
    while (top != stack) {
        const Waiting next = *--top;
        if (next.tNear() > limit) continue;
        const std::uint32_t child = next.child();
        Waiting* base = top;
        if (kAhead == Ahead::Yes && top != stack && isWorthAhead(top[-1], limit)) {
            base = --top;
            ++counts.nodes;
            top = visitNode(tree, base->child(), ray, walk, times, limit, base, top);
        }
        if (child & kLeafBit) {
            const std::uint32_t block = blockOf(child), first = kBlockSize * block,
                                shapes = shapesOf(child);
            const bool balls = (child & kBallBit) != 0;
            ++(balls ? counts.ballBlocks : counts.boxBlocks);
            // What decides the balls comes in while their block is tested: 1.2 times the rays among
            // 1e7; with the block already, for leaves that are never visited too, 1.1 times.
            if (balls)
                prefetch<kBallShapeBytes>(static_cast<const char*>(tree.ballShapes) +
                                          kBallShapeBytes * block);
            limit = balls ? visitLeaf(tree.balls[block], first, shapes, lanes, limit, decide, query)
                          : visitLeaf(tree.boxes[block], tree.boxSlots + first, shapes, lanes,
                                      limit, decide, query);
            if (limit < 0) return counts;
            lanes.limit = hn::Set(kTag, limit);
        } else {
            ++counts.nodes;
            top = visitNode(tree, child, ray, walk, times, limit, base, top);
        }
    }
    return counts;
}

}  // namespace

template <Coordinates kCoordinates>
BlockKernels<kCoordinates> kernels() {
    return {hwy::TargetName(HWY_TARGET), scan<BallBlock<kCoordinates>>,
            scan<BoxBlock<kCoordinates>>, walkTree<kCoordinates, Ahead::No>,
            walkTree<kCoordinates, Ahead::Yes>};
}
BlockKernels<Coordinates::Single> singleKernels() { return kernels<Coordinates::Single>(); }
BlockKernels<Coordinates::Pairs> pairsKernels() { return kernels<Coordinates::Pairs>(); }

}  // namespace glint::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace glint {

HWY_EXPORT(singleKernels);
HWY_EXPORT(pairsKernels);

template <>
BlockKernels<Coordinates::Single> blockKernels() {
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    return HWY_DYNAMIC_DISPATCH(singleKernels)();
}
template <>
BlockKernels<Coordinates::Pairs> blockKernels() {
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    return HWY_DYNAMIC_DISPATCH(pairsKernels)();
}

}  // namespace glint
#endif
