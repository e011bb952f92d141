// Sorting shapes into blocks and the hierarchy.
#include <algorithm>
#include <array>
#include <thread>

#include "tracer/compile/bvh8.h"
#include "tracer/compile/shape_lists.h"

namespace glint {

bool ShapeInstance::holds(const DVec3& p) const {
    return std::visit([local = localPoint(p)](const auto& s) { return s.inside(local); }, shape);
}

DVec3 localHalf(const CanonicalShape& shape) {
    if (std::holds_alternative<CanonicalQuad>(shape) ||
        std::holds_alternative<CanonicalDisk>(shape))
        return {1, 0, 1};
    if (const auto* torus = std::get_if<CanonicalTorus>(&shape))
        return {1 + torus->ratio, torus->ratio, 1 + torus->ratio};
    return DVec3(1.0);
}

DVec3 ShapeInstance::halfSize() const {
    if (std::holds_alternative<CanonicalPlane>(shape)) return DVec3(kInfinity);
    const DVec3 half = localHalf(shape);
    return absolute(worldFromLocal[0]) * half.x + absolute(worldFromLocal[1]) * half.y +
           absolute(worldFromLocal[2]) * half.z;
}

namespace {

/// The filter's error model (shape_blocks.h) holds for sizes and coordinates within [1 / kLargest,
/// kLargest] metres.
constexpr double kLargest = 1e17;
/// ... and while rounding in a shape's local space, where all axes mix, is small against the
/// filter's margins: for ratios of its axes up to kMaxAspect, and for shears that stretch no axis
/// by more than kMaxSkew against the width of its slab.
constexpr double kMaxAspect = 1e6, kMaxSkew = 1e4;

/// The factor of a transform that only turns, mirrors and scales alike in all directions; 0 for any
/// other. Compared exactly: a sphere that is a hair away from round takes the general way, which is
/// right for both.
double similarityScale(const DMat3& m) {
    const double s = glm::dot(m[0], m[0]);
    const auto near = [s](double x, double y) { return std::abs(x - y) <= 4e-16 * s; };
    const bool similar = near(glm::dot(m[1], m[1]), s) && near(glm::dot(m[2], m[2]), s) &&
                         near(glm::dot(m[0], m[1]), 0) && near(glm::dot(m[0], m[2]), 0) &&
                         near(glm::dot(m[1], m[2]), 0);
    return similar ? std::sqrt(s) : 0;
}

DVec3 row(const DMat3& m, int i) { return {m[0][i], m[1][i], m[2][i]}; }

bool inRange(double x) { return x >= 1 / kLargest && x <= kLargest; }

/// Whether the error model holds for a shape.
bool isFilterable(const ShapeInstance& instance) {
    if (std::holds_alternative<CanonicalPlane>(instance.shape)) return false;
    if (!(maxComponent(absolute(instance.center)) <= kLargest)) return false;
    const DMat3 product = instance.localFromWorld * instance.worldFromLocal;
    const DVec3 half = localHalf(instance.shape);
    double least = kInfinity, most = 0;
    for (int i = 0; i < 3; ++i) {
        const double scale = glm::length(row(instance.localFromWorld, i)),
                     stretch = glm::length(instance.worldFromLocal[i]);
        for (int j = 0; j < 3; ++j)
            if (!(std::abs(product[i][j] - (i == j ? 1 : 0)) <= 1e-6)) return false;
        if (!inRange(scale) || !inRange(stretch) || !(half[i] * stretch <= kLargest) ||
            scale * stretch > kMaxSkew)
            return false;
        least = std::min(least, scale), most = std::max(most, scale);
    }
    return most <= kMaxAspect * least;
}

/// The shape's box in render space, every coordinate rounded up.
BoundedShape bounded(const ShapeInstance& instance, std::uint32_t index) {
    BoundedShape out{instance.center, {}, index};
    const DVec3 half = localHalf(instance.shape);
    const bool sphere = std::holds_alternative<CanonicalSphere>(instance.shape);
    for (int axis = 0; axis < 3; ++axis) {
        const DVec3 across = row(instance.worldFromLocal, axis);
        out.half[axis] = static_cast<float>(
            (sphere ? glm::length(across) : glm::dot(absolute(across), half)) * (1 + 1e-6));
    }
    return out;
}

template <Coordinates kCoordinates>
void setCenter(Centers<kCoordinates>& centers, std::size_t lane, const DVec3& center) {
    for (int axis = 0; axis < 3; ++axis) {
        const auto hi = static_cast<float>(center[axis]);
        centers.hi[axis][lane] = hi;
        if constexpr (kCoordinates == Coordinates::Pairs)
            centers.lo[axis][lane] = static_cast<float>(center[axis] - static_cast<double>(hi));
    }
}

}  // namespace

ShapeLists::ShapeLists(const std::vector<ShapeInstance>& instances) {
    sortByKind(instances);
    ballSlots_ = static_cast<std::uint32_t>(balls_.size());
    boxSlots_ = static_cast<std::uint32_t>(boxes_.size());
    const std::size_t filterable = balls_.size() + boxes_.size();
    unfiltered_ = filterable <= kUnfilteredShapes;
    const auto build = [&]<Coordinates kCoordinates>() {
        static_assert(sizeof(Ball) * kBlockSize == kBallShapeBytes);
        blocks_.emplace<Blocks<kCoordinates>>().kernels = blockKernels<kCoordinates>();
        filterable <= kFlatShapes ? buildFlat<kCoordinates>(instances)
                                  : buildTree<kCoordinates>(instances);
    };
    areNearZero() ? build.operator()<Coordinates::Single>()
                  : build.operator()<Coordinates::Pairs>();
}

std::optional<ShapeLists> ShapeLists::moved(const std::vector<ShapeInstance>& from,
                                            const std::vector<ShapeInstance>& to) const {
    if (nodes_.empty() || from.size() != to.size()) return std::nullopt;
    ShapeLists out = *this;
    std::vector<bool> isNew((ballSlots_ + boxSlots_) / kBlockSize);
    for (std::uint32_t i = 0; i < to.size(); ++i) {
        if (to[i].coincides(from[i])) continue;
        const Kind kind = kindOf(to[i]);
        if (kind != kindOf(slotOf_[i])) return std::nullopt;
        out.replace(to[i], i);
        if (kind != Kind::Always) isNew[slotOf_[i] / kBlockSize] = true;
        out.hasMoved_ = true;
    }
    return std::visit(
        [&]<Coordinates kCoordinates>(Blocks<kCoordinates>& blocks) -> std::optional<ShapeLists> {
            if (kCoordinates == Coordinates::Single && !out.areNearZero()) return std::nullopt;
            blocks.kernels = blockKernels<kCoordinates>();
            out.fillTree<kCoordinates>(to, [&](std::uint32_t leaf) {
                const std::uint32_t block = blockOf(leaf);
                return isNew[leaf & kBallBit ? block : ballSlots_ / kBlockSize + block];
            });
            if (boxArea(out.nodes_) > kMostGrowth * builtArea_) return std::nullopt;
            return std::move(out);
        },
        out.blocks_);
}

ShapeLists::Kind ShapeLists::kindOf(const ShapeInstance& instance) {
    if (!isFilterable(instance)) return Kind::Always;
    const bool sphere = std::holds_alternative<CanonicalSphere>(instance.shape);
    return sphere && similarityScale(instance.localFromWorld) > 0 ? Kind::Ball : Kind::Box;
}

ShapeLists::Kind ShapeLists::kindOf(std::uint32_t slot) const {
    if (slot == kNoShape) return Kind::Always;
    return slot < ballSlots_ ? Kind::Ball : Kind::Box;
}

ShapeLists::Ball ShapeLists::ballOf(const ShapeInstance& instance, std::uint32_t index) {
    return {instance.center, similarityScale(instance.localFromWorld), index, instance.dielectric};
}

ShapeLists::Entry ShapeLists::entryOf(const ShapeInstance& instance, std::uint32_t index) {
    const bool convex =
        std::visit([]<class Shape>(const Shape&) { return Shape::convex; }, instance.shape);
    return {instance.center,
            instance.localFromWorld,
            instance.shape,
            index,
            instance.dielectric,
            convex,
            std::holds_alternative<CanonicalPlane>(instance.shape)};
}

void ShapeLists::sortByKind(const std::vector<ShapeInstance>& instances) {
    for (std::uint32_t i = 0; i < instances.size(); ++i) {
        const Kind kind = kindOf(instances[i]);
        if (kind == Kind::Ball)
            balls_.push_back(ballOf(instances[i], i));
        else
            (kind == Kind::Box ? boxes_ : always_).push_back(entryOf(instances[i], i));
        if (kind != Kind::Always) measure(instances[i]);
    }
}

void ShapeLists::measure(const ShapeInstance& instance) {
    const DMat3& m = instance.worldFromLocal;
    reach_ = std::max(reach_, maxComponent(absolute(instance.center)));
    leastSize_ =
        std::min(leastSize_, std::max({glm::length(m[0]), glm::length(m[1]), glm::length(m[2])}));
}

/// Whether single coordinates make no shape seem larger by more than a thousandth.
bool ShapeLists::areNearZero() const {
    return 2 * reach_ * slackFactor(Coordinates::Single) <= 1e-3 * leastSize_;
}

/// Puts a shape in the place of the one with that index, of the same kind.
void ShapeLists::replace(const ShapeInstance& instance, std::uint32_t index) {
    const std::uint32_t slot = slotOf_[index];
    if (slot == kNoShape) {
        std::ranges::find(always_, index, &Entry::index)[0] = entryOf(instance, index);
        return;
    }
    if (slot < ballSlots_)
        balls_[slot] = ballOf(instance, index);
    else
        boxes_[slot - ballSlots_] = entryOf(instance, index);
    measure(instance);
}

template <Coordinates kCoordinates>
void ShapeLists::buildFlat(const std::vector<ShapeInstance>& instances) {
    std::stable_sort(boxes_.begin(), boxes_.end(), [](const Entry& a, const Entry& b) {
        return a.shape.index() < b.shape.index();
    });
    auto& blocks = std::get<Blocks<kCoordinates>>(blocks_);
    const auto count = [](std::size_t first, std::size_t end) {
        return std::min<std::size_t>(kBlockSize, end - first);
    };
    for (std::size_t i = 0; i < balls_.size(); i += kBlockSize)
        blocks.balls.push_back(ballBlock<kCoordinates>(i, count(i, balls_.size())));
    for (std::size_t i = 0; i < boxes_.size(); i += kBlockSize)
        blocks.boxes.push_back(boxBlock<kCoordinates>(i, count(i, boxes_.size()), instances));
    slotOf_.assign(instances.size(), kNoShape);
    std::uint32_t slot = 0;
    for (const Ball& ball : balls_) slotOf_[ball.index] = slot++;
    for (const Entry& entry : boxes_) slotOf_[entry.index] = slot++;
}

template <Coordinates kCoordinates>
void ShapeLists::buildTree(const std::vector<ShapeInstance>& instances) {
    std::vector<BoundedShape> shapes;
    shapes.reserve(balls_.size() + boxes_.size());
    for (const Ball& ball : balls_)
        shapes.push_back(bounded(instances[ball.index], ball.index | kBallBit));
    for (const Entry& entry : boxes_)
        shapes.push_back(bounded(instances[entry.index], entry.index));
    Hierarchy tree = buildHierarchy(shapes, static_cast<int>(std::thread::hardware_concurrency()));

    const auto isBall = [&](const Leaf& leaf) {
        return (shapes[leaf.begin].index & kBallBit) != 0;
    };
    const auto ballLeaves = static_cast<std::uint32_t>(std::ranges::count_if(tree.leaves, isBall));
    ballSlots_ = kBlockSize * ballLeaves;
    boxSlots_ = kBlockSize * (static_cast<std::uint32_t>(tree.leaves.size()) - ballLeaves);
    slotOf_.assign(instances.size(), kNoShape);
    std::uint32_t ball = 0, box = ballSlots_;
    for (const Leaf& leaf : tree.leaves) {
        std::uint32_t& first = isBall(leaf) ? ball : box;
        for (std::uint32_t i = 0; i < leaf.count; ++i)
            slotOf_[shapes[leaf.begin + i].index & ~kBallBit] = first + i;
        first += kBlockSize;
    }
    nodes_ = std::move(tree.nodes);
    sortBySlot();
    fillTree<kCoordinates>(instances, [](std::uint32_t) { return true; });
    builtArea_ = boxArea(nodes_);
}

/// Makes blocks and boxes of the shapes that lie in them, those of new leaves at least.
template <Coordinates kCoordinates>
void ShapeLists::fillTree(const std::vector<ShapeInstance>& instances,
                          const std::function<bool(std::uint32_t)>& isNew) {
    auto& blocks = std::get<Blocks<kCoordinates>>(blocks_);
    blocks.balls.resize(ballSlots_ / kBlockSize), blocks.boxes.resize(boxSlots_ / kBlockSize);
    refit(nodes_, kCoordinates, isNew, [&](std::uint32_t leaf) {
        const std::uint32_t block = blockOf(leaf), first = kBlockSize * block,
                            shapes = shapesOf(leaf);
        if (leaf & kBallBit)
            blocks.balls[block] = ballBlock<kCoordinates>(first, shapes);
        else
            blocks.boxes[block] = boxBlock<kCoordinates>(first, shapes, instances);
        Bounds out;
        for (std::uint32_t i = first; i < first + shapes; ++i) {
            const std::uint32_t index = leaf & kBallBit ? balls_[i].index : boxes_[i].index;
            out.add(bounded(instances[index], index).bounds());
        }
        return out;
    });
}

void ShapeLists::sortBySlot() {
    const auto sorted = [&](const auto& list, std::uint32_t first, std::uint32_t slots) {
        std::remove_cvref_t<decltype(list)> out(slots);
        for (const auto& shape : list) out[slotOf_[shape.index] - first] = shape;
        return out;
    };
    balls_ = sorted(balls_, 0, ballSlots_);
    boxes_ = sorted(boxes_, ballSlots_, boxSlots_);
}

template <Coordinates kCoordinates>
BallBlock<kCoordinates> ShapeLists::ballBlock(std::size_t first, std::size_t count) const {
    BallBlock<kCoordinates> block{};
    for (std::size_t lane = 0; lane < count; ++lane) {
        const Ball& ball = balls_[first + lane];
        setCenter(block.center, lane, ball.center);
        block.radius[lane] = static_cast<float>((1 + double{kBallMargin}) / ball.inverseRadius);
    }
    return block;
}

template <Coordinates kCoordinates>
BoxBlock<kCoordinates> ShapeLists::boxBlock(std::size_t first, std::size_t count,
                                            const std::vector<ShapeInstance>& instances) const {
    BoxBlock<kCoordinates> block{};
    for (std::size_t lane = 0; lane < count; ++lane) {
        const Entry& entry = boxes_[first + lane];
        const ShapeInstance& instance = instances[entry.index];
        const DVec3 half = localHalf(entry.shape);
        double radius = 0;
        for (int i = 0; i < 3; ++i) radius += half[i] * glm::length(instance.worldFromLocal[i]);
        setCenter(block.center, lane, entry.center);
        for (int slab = 0; slab < 3; ++slab) {
            const DVec3 normal = row(entry.localFromWorld, slab);
            const double scale = glm::length(normal);
            for (int axis = 0; axis < 3; ++axis)
                block.row[slab][axis][lane] = static_cast<float>(normal[axis] / scale);
            block.half[slab][lane] =
                static_cast<float>(half[slab] / scale + double{kBoxMargin} * radius);
        }
    }
    return block;
}

}  // namespace glint
