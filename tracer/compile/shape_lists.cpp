#include "tracer/compile/shape_lists.h"

#include <algorithm>
#include <bit>

namespace glint {

namespace {

constexpr std::size_t kLanesACall = kBlocksACall * kBlockSize;

/// Beyond this distance from zero [m] floats could overflow in the filter.
constexpr double kFilterRange = 1e17;

/// How the filter takes a ray.
enum class Fit {
    Filter,
    Unfit,  ///< too far away, or a direction of extreme length: every shape is decided
    Miss    ///< not finite, or without direction: meets only what it is known to be in
};

/// In a plane's own space: so high that isWithin() surely says no.
constexpr double kAbovePlane = 1e-300;

/// x rounded up to float, also where floats below 1.2e-38 are flushed to 0.
float roundUp(double x) { return static_cast<float>(x * (1 + 1e-7)); }

/// Fills everything of `out` but the limit. `length` is the direction's, exactly 1 where it is near
/// enough to it.
[[gnu::always_inline]] inline Fit prepare(const Ray& ray, double reach, Coordinates coordinates,
                                          FilterRay& out, double& length) {
    const double length2 = glm::dot(ray.direction, ray.direction), far = coordinateSum(ray.origin);
    DVec3 direction = ray.direction;
    length = 1;
    if (!(std::abs(length2 - 1) <= kUnitTolerance) || !(far <= kFilterRange)) {
        if (!isFinite(ray.origin) || !isFinite(direction) || direction == DVec3(0.0))
            return Fit::Miss;
        if (far > kFilterRange || !(length2 > 1e-200 && length2 < 1e200)) return Fit::Unfit;
        length = std::sqrt(length2);
        direction /= length;
    }
    for (int axis = 0; axis < 3; ++axis) {
        out.originHi[axis] = static_cast<float>(ray.origin[axis]);
        out.originLo[axis] = 0;
        out.direction[axis] = static_cast<float>(direction[axis]);
    }
    if (coordinates == Coordinates::Pairs) {
        for (int axis = 0; axis < 3; ++axis)
            out.originLo[axis] =
                static_cast<float>(ray.origin[axis] - static_cast<double>(out.originHi[axis]));
    }
    out.slack = static_cast<float>((far + reach) * slackFactor(coordinates) + 1e-30);
    return Fit::Filter;
}

}  // namespace

/// The ray, and the slots that are decided ahead of the others because the path is on those shapes
/// or inside of them.
struct ShapeLists::Asking {
    Asking(const Ray& r, const MediaStack& m, WorkCounts& w)
        : ray(r), media(m), work(w) {}  // Leaves `known` as it is: no time for zeros.

    const Ray& ray;
    const MediaStack& media;
    WorkCounts& work;
    double length = 1;  ///< of the ray's direction
    int knownCount = 0;
    std::array<std::uint32_t, MediaStack::kCapacity + 1> known;

    [[nodiscard]] bool isKnown(std::uint32_t slot) const {
        for (int i = 0; i < knownCount; ++i)
            if (known[static_cast<std::size_t>(i)] == slot) return true;
        return false;
    }
    template <class Shape>
    [[nodiscard]] Start start(const Shape& shape) const {
        return startOf(ray, media, shape.index, shape.dielectric);
    }
    void count(const Ball&) const { ++work[Work::BallTests]; }
    void count(const Entry&) const { ++work[Work::ShapeTests], ++work[Work::MatrixTests]; }
};

// The two questions.

struct ShapeLists::Nearest {
    const ShapeLists* lists;
    double place, tMax;  ///< of the ray's origin; hits from tMax on are none
    // The best hit so far. Shape and face lie apart, so that they are loaded one by one as they are
    // stored; at once, the processor would wait for the stores to end.
    double bestT = tMax, bestOrder = tMax;
    std::uint32_t bestShape = kNoShape;
    bool bestIsDielectric = false;
    int bestFace = 0;

    [[nodiscard]] bool found() const { return bestShape != kNoShape; }
    [[nodiscard]] ShapeHit best() const { return {bestT, bestShape, bestFace}; }

    /// Hits this far from the best one may coincide with it.
    [[nodiscard]] double range() const { return kTieRange * (bestOrder + place); }
    [[nodiscard]] double limit() const {
        return found() ? std::min(tMax, bestOrder + range()) : tMax;
    }
    [[nodiscard]] static bool done() { return false; }
    template <class Shape>
    void decide(const Shape& shape, const Ray& ray, Start start) {
        const Crossing c = firstHit(shape, ray, start);
        const double order = hitOrder(c.t, ray, start, shape.dielectric);
        if (!(order < limit())) {
            if (!(order == bestOrder && found() && shape.index < bestShape)) return;
        } else if (found() && order > bestOrder - range()) {
            if (!winsTie(c, order, shape.index, shape.dielectric, ray)) return;
        }
        bestT = c.t, bestShape = shape.index, bestFace = c.face;
        bestOrder = order;
        bestIsDielectric = shape.dielectric;
    }
    /// Media have their own rule, hitOrder(), which is an order of numbers too.
    [[nodiscard, gnu::noinline]] bool winsTie(const Crossing& c, double order, std::uint32_t index,
                                              bool dielectric, const Ray& ray) const {
        const double mine = dielectric ? order : lists->tieOrderOf({c.t, index, c.face}, ray);
        const double other = bestIsDielectric ? bestOrder : lists->tieOrderOf(best(), ray);
        return mine < other || (mine == other && index < bestShape);
    }
};

struct ShapeLists::Any {
    double tMax;
    std::uint32_t ignored;
    bool passesMedia;
    bool hit = false;
    [[nodiscard]] double limit() const { return tMax; }
    [[nodiscard]] bool done() const { return hit; }
    template <class Shape>
    void decide(const Shape& shape, const Ray& ray, Start start) {
        hit = shape.index != ignored && !(passesMedia && shape.dielectric) &&
              firstHit(shape, ray, start).t < tMax;
    }
};

/// use(placed) of the shape with that index.
template <class Use>
auto ShapeLists::withShape(std::uint32_t index, const Use& use) const {
    const std::uint32_t slot = slotOf_[index];
    if (slot < ballSlots_) {
        const CanonicalSphere sphere;
        const DMat3 localFromWorld(balls_[slot].inverseRadius);
        return use(Placed<CanonicalSphere>{sphere, localFromWorld, balls_[slot].center, index});
    }
    const Entry& entry = slot != kNoShape
                             ? boxes_[slot - ballSlots_]
                             : *std::find_if(always_.begin(), always_.end(),
                                             [&](const Entry& e) { return e.index == index; });
    return std::visit(
        [&]<class Shape>(const Shape& shape) {
            return use(Placed<Shape>{shape, entry.localFromWorld, entry.center, index});
        },
        entry.shape);
}

double ShapeLists::tieOrderOf(const ShapeHit& hit, const Ray& ray) const {
    return withShape(hit.shape, [&](const auto& placed) {
        return tieOrder(placed, ray, Crossing{hit.t, hit.face});
    });
}

/// Flattened: a call within costs as much as the sphere itself.
[[gnu::flatten]] inline Crossing ShapeLists::firstHit(const Ball& ball, const Ray& ray,
                                                      Start start) {
    if (start == Start::Leaving) return {};
    const DVec3 o = (ray.origin - ball.center) * ball.inverseRadius,
                d = ray.direction * ball.inverseRadius;
    const CanonicalSphere sphere;
    const DMat3 localFromWorld(ball.inverseRadius);
    return firstHitOf(Placed<CanonicalSphere>{sphere, localFromWorld, ball.center, ball.index}, ray,
                      o, d, start);
}

/// What firstHitOf() says of a plane, told in a few steps, for a ray that starts well above it.
inline std::optional<Crossing> ShapeLists::fromAbove(const Entry& plane, const Ray& ray,
                                                     Start start) {
    if (ray.passed != 0 || start == Start::Entering || start == Start::KnownInside) return {};
    const DMat3& m = plane.localFromWorld;
    const DVec3 up(m[0].y, m[1].y, m[2].y), from = ray.origin - plane.center;
    const double height = glm::dot(up, from), rise = glm::dot(up, ray.direction);
    if (!(height > kAbovePlane)) return {};
    if (rise >= 0) return Crossing{};
    const double t = -height / rise;
    const double place = coordinateSum(ray.origin) + coordinateSum(plane.center);
    return t > kTouchRange * place ? std::optional(Crossing{t}) : std::nullopt;
}

/// Shadow rays mostly leave a convex shape, or go upwards from a plane.
[[gnu::always_inline]] inline Crossing ShapeLists::firstHit(const Entry& entry, const Ray& ray,
                                                            Start start) {
    if (start == Start::Leaving && entry.convex) return {};
    if (entry.isPlane)
        if (const std::optional<Crossing> known = fromAbove(entry, ray, start)) return *known;
    return firstHitOfAny(entry, ray, start);
}

[[gnu::noinline]] Crossing ShapeLists::firstHitOfAny(const Entry& entry, const Ray& ray,
                                                     Start start) {
    const DVec3 o = entry.localFromWorld * (ray.origin - entry.center),
                d = entry.localFromWorld * ray.direction;
    return std::visit(
        [&]<class Shape>(const Shape& shape) {
            return firstHitOf(Placed<Shape>{shape, entry.localFromWorld, entry.center, entry.index},
                              ray, o, d, start);
        },
        entry.shape);
}

/// Decides the shape of a slot that the path is neither on nor inside of.
template <class Question>
inline void ShapeLists::decideSlot(const Asking& asking, Question& question,
                                   std::uint32_t slot) const {
    const auto start = [](bool dielectric) {
        return dielectric ? Start::KnownOutside : Start::Elsewhere;
    };
    if (slot < ballSlots_) {
        asking.count(balls_[slot]);
        return question.decide(balls_[slot], asking.ray, start(balls_[slot].dielectric));
    }
    const Entry& entry = boxes_[slot - ballSlots_];
    asking.count(entry);
    question.decide(entry, asking.ray, start(entry.dielectric));
}

/// Near ones first, so that mostly one is decided. Leaves off where the answer cannot change.
template <class Question>
[[gnu::noinline]] void ShapeLists::decideInOrder(const Asking& asking, Question& question,
                                                 Candidate* candidates, int count) const {
    while (count > 0 && !question.done()) {
        Candidate* nearest = candidates;
        for (Candidate* c = candidates + 1; c != candidates + count; ++c)
            if (c->tLo < nearest->tLo) nearest = c;
        if (static_cast<double>(nearest->tLo) > question.limit() * asking.length) break;
        if (!asking.isKnown(nearest->slot)) decideSlot(asking, question, nearest->slot);
        *nearest = candidates[--count];
    }
}

template <class Question, class List>
[[gnu::always_inline]] inline void ShapeLists::decideEach(const Asking& asking, Question& question,
                                                          const List& list) {
    for (const auto& shape : list) {
        if (question.done()) break;
        if (shape.index == kNoShape) continue;
        asking.count(shape);
        question.decide(shape, asking.ray, asking.start(shape));
    }
}

template <class Question>
[[gnu::noinline]] void ShapeLists::decideAll(const Asking& asking, Question& question) const {
    decideEach(asking, question, balls_);
    decideEach(asking, question, boxes_);
}

/// The filter knows nothing of where a ray starts, so shapes whose answer depends on it come first.
template <class Question>
[[gnu::noinline]] void ShapeLists::decideKnown(Asking& asking, Question& question) const {
    const auto decide = [&](std::uint32_t index) {
        const std::uint32_t slot = index < slotOf_.size() ? slotOf_[index] : kNoShape;
        if (slot == kNoShape || asking.isKnown(slot) || question.done()) return;
        asking.known[static_cast<std::size_t>(asking.knownCount++)] = slot;
        const auto decideShape = [&](const auto& shape) {
            asking.count(shape);
            question.decide(shape, asking.ray, asking.start(shape));
        };
        slot < ballSlots_ ? decideShape(balls_[slot]) : decideShape(boxes_[slot - ballSlots_]);
    };
    decide(asking.ray.fromShape);
    for (int i = 0; i < asking.media.size(); ++i) decide(asking.media[i]);
}

/// The shapes of a flat list of blocks; slotOf(lane) of the list's lanes.
template <class Question, class Block, class Kernel, class SlotOf>
[[gnu::always_inline]] inline void ShapeLists::askFlat(const Asking& asking, Question& question,
                                                       const LargeVector<Block>& blocks,
                                                       std::size_t shapes, Kernel kernel,
                                                       FilterRay& ray, SlotOf slotOf) const {
    for (std::size_t i = 0; i < blocks.size() && !question.done(); i += kBlocksACall) {
        float tLo[kLanesACall];
        ray.limit = roundUp(question.limit() * asking.length);
        std::uint64_t found =
            kernel(&blocks[i], std::min(blocks.size() - i, kBlocksACall), ray, tLo);
        const std::size_t first = i * kBlockSize, lanes = std::min(shapes - first, kLanesACall);
        found &= ~std::uint64_t{0} >> (kLanesACall - lanes);
        if (found == 0) continue;
        if ((found & (found - 1)) == 0) {
            const std::uint32_t slot =
                slotOf(first + static_cast<std::size_t>(std::countr_zero(found)));
            if (!asking.isKnown(slot)) decideSlot(asking, question, slot);
            continue;
        }
        Candidate candidates[kLanesACall];
        int count = 0;
        for (; found != 0; found &= found - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(found));
            candidates[count++] = {tLo[lane], slotOf(first + lane)};
        }
        decideInOrder(asking, question, candidates, count);
    }
}

template <Coordinates kCoordinates, class Question>
[[gnu::noinline]] void ShapeLists::askTree(const Asking& asking, Question& question,
                                           FilterRay& ray) const {
    struct Walk {
        const ShapeLists& lists;
        const Asking& asking;
        Question& question;
    } walk{*this, asking, question};
    const auto decideLeaf = [](void* context, Candidate* candidates, int count) {
        Walk& w = *static_cast<Walk*>(context);
        w.lists.decideInOrder(w.asking, w.question, candidates, count);
        return w.question.done() ? -1.0f : roundUp(w.question.limit() * w.asking.length);
    };
    ray.limit = roundUp(question.limit() * asking.length);
    const auto& blocks = *std::get_if<Blocks<kCoordinates>>(&blocks_);
    const auto kernel =
        nodes_.size() > kCachedNodes ? blocks.kernels.walkAhead : blocks.kernels.walk;
    const WalkCounts counts =
        kernel({nodes_.data(), blocks.balls.data(), blocks.boxes.data(), ballSlots_, balls_.data()},
               ray, decideLeaf, &walk);
    asking.work[Work::NodeVisits] += counts.nodes;
    asking.work[Work::BallBlocks] += counts.ballBlocks;
    asking.work[Work::BoxBlocks] += counts.boxBlocks;
}

template <Coordinates kCoordinates, class Question>
[[gnu::always_inline]] inline void ShapeLists::askBlocks(const Asking& asking, Question& question,
                                                         FilterRay& ray,
                                                         const FewShapes* few) const {
    if (!few && !nodes_.empty()) return askTree<kCoordinates>(asking, question, ray);
    const auto& blocks = *std::get_if<Blocks<kCoordinates>>(few ? &few->blocks : &blocks_);
    asking.work[Work::BallBlocks] += blocks.balls.size();
    asking.work[Work::BoxBlocks] += blocks.boxes.size();
    const auto slot = [](std::size_t lane) { return static_cast<std::uint32_t>(lane); };
    if (few) {
        askFlat(asking, question, blocks.balls, few->balls.size(), blocks.kernels.balls, ray,
                [&](std::size_t lane) { return few->balls[lane]; });
        return askFlat(asking, question, blocks.boxes, few->boxes.size(), blocks.kernels.boxes, ray,
                       [&](std::size_t lane) { return few->boxes[lane]; });
    }
    askFlat(asking, question, blocks.balls, ballSlots_, blocks.kernels.balls, ray, slot);
    return askFlat(asking, question, blocks.boxes, boxSlots_, blocks.kernels.boxes, ray,
                   [&](std::size_t lane) { return ballSlots_ + slot(lane); });
}

template <class Question>
[[gnu::always_inline]] inline void ShapeLists::ask(const Ray& ray, const MediaStack& media,
                                                   Question& question, WorkCounts& work,
                                                   const FewShapes* few) const {
    Asking asking(ray, media, work);
    if (!always_.empty()) decideEach(asking, question, always_);
    if (question.done()) return;
    FilterRay filterRay;
    const bool single = blocks_.index() == 0;
    const Coordinates coordinates = single ? Coordinates::Single : Coordinates::Pairs;
    // Where a tile sees nothing, as often, no more is to be known of the ray.
    const Fit fit = unfiltered_ ? Fit::Unfit
                    : few && few->isEmpty()
                        ? Fit::Miss
                        : prepare(ray, reach_, coordinates, filterRay, asking.length);
    if (fit == Fit::Unfit) return decideAll(asking, question);
    const bool startsOnListed =
        ray.fromShape < slotOf_.size() && slotOf_[ray.fromShape] != kNoShape;
    if (startsOnListed || !media.empty()) decideKnown(asking, question);
    if (fit == Fit::Miss || question.done()) return;
    return single ? askBlocks<Coordinates::Single>(asking, question, filterRay, few)
                  : askBlocks<Coordinates::Pairs>(asking, question, filterRay, few);
}

ShapeHit ShapeLists::closest(const Ray& ray, const MediaStack& media, double tMax, WorkCounts& work,
                             const FewShapes* few) const {
    Nearest question{this, coordinateSum(ray.origin), tMax};
    ask(ray, media, question, work, few);
    return question.best();
}
ShapeHit ShapeLists::closest(const Ray& ray, const MediaStack& media, double tMax) const {
    WorkCounts uncounted;
    return closest(ray, media, tMax, uncounted);
}

bool ShapeLists::occluded(const Ray& ray, const MediaStack& media, double tMax,
                          std::uint32_t ignored, WorkCounts& work, const FewShapes* few,
                          bool passesMedia) const {
    Any question{tMax, ignored, passesMedia};
    ask(ray, media, question, work, few);
    return question.hit;
}
bool ShapeLists::occluded(const Ray& ray, const MediaStack& media, double tMax,
                          std::uint32_t ignored) const {
    WorkCounts uncounted;
    return occluded(ray, media, tMax, ignored, uncounted);
}

ShapeLists::Memory ShapeLists::memory() const {
    const auto bytes = [](const auto& list) { return list.size() * sizeof(list[0]); };
    const std::size_t blocks =
        std::visit([&](const auto& b) { return bytes(b.balls) + bytes(b.boxes); }, blocks_);
    return {bytes(nodes_) + bytes(slotOf_),
            bytes(always_) + bytes(balls_) + bytes(boxes_) + blocks};
}

Crossing hitShape(const ShapeInstance& instance, std::uint32_t index, const Ray& ray,
                  const MediaStack& media) {
    return std::visit(
        [&]<class Shape>(const Shape& shape) {
            return firstHitOf(Placed<Shape>{shape, instance.localFromWorld, instance.center, index},
                              ray, instance.localPoint(ray.origin),
                              instance.localVector(ray.direction),
                              startOf(ray, media, index, instance.dielectric));
        },
        instance.shape);
}

}  // namespace glint
