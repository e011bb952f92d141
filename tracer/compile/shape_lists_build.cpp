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

DVec3 ShapeInstance::halfSize() const {
    if (std::holds_alternative<CanonicalPlane>(shape)) return DVec3(kInfinity);
    DVec3 half(1.0);
    if (const auto* torus = std::get_if<CanonicalTorus>(&shape))
        half = {1 + torus->ratio, torus->ratio, 1 + torus->ratio};
    return glm::abs(worldFromLocal[0]) * half.x + glm::abs(worldFromLocal[1]) * half.y +
           glm::abs(worldFromLocal[2]) * half.z;
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

/// Half the lengths of a shape's box in its local space.
DVec3 localHalf(const CanonicalShape& shape) {
    if (std::holds_alternative<CanonicalQuad>(shape) ||
        std::holds_alternative<CanonicalDisk>(shape))
        return {1, 0, 1};
    if (const auto* torus = std::get_if<CanonicalTorus>(&shape))
        return {1 + torus->ratio, torus->ratio, 1 + torus->ratio};
    return DVec3(1.0);
}

DVec3 row(const DMat3& m, int i) { return {m[0][i], m[1][i], m[2][i]}; }

bool inRange(double x) { return x >= 1 / kLargest && x <= kLargest; }

/// Whether the error model holds for a shape.
bool isFilterable(const ShapeInstance& instance) {
    if (std::holds_alternative<CanonicalPlane>(instance.shape)) return false;
    if (!(maxComponent(glm::abs(instance.center)) <= kLargest)) return false;
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
            (sphere ? glm::length(across) : glm::dot(glm::abs(across), half)) * (1 + 1e-6));
    }
    return out;
}

template <class Block>
void setCenter(Block& block, std::size_t lane, const DVec3& center) {
    for (int axis = 0; axis < 3; ++axis) {
        block.centerHi[axis][lane] = static_cast<float>(center[axis]);
        block.centerLo[axis][lane] =
            static_cast<float>(center[axis] - static_cast<double>(block.centerHi[axis][lane]));
    }
}

}  // namespace

ShapeLists::ShapeLists(const std::vector<ShapeInstance>& instances) {
    sortByKind(instances);
    ballCount_ = static_cast<std::uint32_t>(balls_.size());
    boxCount_ = static_cast<std::uint32_t>(boxes_.size());
    const std::size_t filterable = balls_.size() + boxes_.size();
    unfiltered_ = filterable <= kUnfilteredShapes;
    coordinates_ = filterable <= kFlatShapes ? chooseCoordinates(instances) : Coordinates::Pairs;
    kernels_ = blockKernels(coordinates_);
    if (filterable <= kFlatShapes)
        buildFlat(instances);
    else
        buildTree(instances);
    findSlots(instances.size());
}

void ShapeLists::sortByKind(const std::vector<ShapeInstance>& instances) {
    for (std::size_t i = 0; i < instances.size(); ++i) {
        const ShapeInstance& instance = instances[i];
        const auto index = static_cast<std::uint32_t>(i);
        const bool filterable = isFilterable(instance);
        const bool sphere = std::holds_alternative<CanonicalSphere>(instance.shape);
        const double scale = sphere && filterable ? similarityScale(instance.localFromWorld) : 0;
        if (scale > 0) {
            balls_.push_back({instance.center, scale, index, instance.dielectric});
        } else {
            (filterable ? boxes_ : always_)
                .push_back({instance.center, instance.localFromWorld, instance.shape, index,
                            instance.dielectric});
        }
        if (filterable) reach_ = std::max(reach_, maxComponent(glm::abs(instance.center)));
    }
}

/// Single where it makes no shape seem larger by more than a thousandth.
Coordinates ShapeLists::chooseCoordinates(const std::vector<ShapeInstance>& instances) const {
    double least = kInfinity;
    const auto measure = [&](const auto& list) {
        for (const auto& shape : list) {
            const DMat3& m = instances[shape.index].worldFromLocal;
            least = std::min(least,
                             std::max({glm::length(m[0]), glm::length(m[1]), glm::length(m[2])}));
        }
    };
    measure(balls_);
    measure(boxes_);
    return 2 * reach_ * slackFactor(Coordinates::Single) <= 1e-3 * least ? Coordinates::Single
                                                                         : Coordinates::Pairs;
}

void ShapeLists::buildFlat(const std::vector<ShapeInstance>& instances) {
    std::stable_sort(boxes_.begin(), boxes_.end(), [](const Entry& a, const Entry& b) {
        return a.shape.index() < b.shape.index();
    });
    for (std::size_t i = 0; i < balls_.size(); i += kBlockSize)
        addBallBlock(i, std::min<std::size_t>(kBlockSize, balls_.size() - i));
    for (std::size_t i = 0; i < boxes_.size(); i += kBlockSize)
        addBoxBlock(i, std::min<std::size_t>(kBlockSize, boxes_.size() - i), instances);
}

void ShapeLists::buildTree(const std::vector<ShapeInstance>& instances) {
    std::vector<BoundedShape> shapes;
    shapes.reserve(balls_.size() + boxes_.size());
    for (std::size_t i = 0; i < balls_.size(); ++i)
        shapes.push_back(
            bounded(instances[balls_[i].index], static_cast<std::uint32_t>(i) | kBallBit));
    for (std::size_t i = 0; i < boxes_.size(); ++i)
        shapes.push_back(bounded(instances[boxes_[i].index], static_cast<std::uint32_t>(i)));
    Hierarchy tree = buildHierarchy(shapes, static_cast<int>(std::thread::hardware_concurrency()));

    std::vector<Ball> balls;
    std::vector<Entry> boxes;
    balls.reserve(balls_.size());
    boxes.reserve(boxes_.size());
    for (const BoundedShape& shape : shapes) {
        if (shape.index & kBallBit)
            balls.push_back(balls_[shape.index & kChildMask]);
        else
            boxes.push_back(boxes_[shape.index]);
    }
    balls_ = std::move(balls);
    boxes_ = std::move(boxes);
    nodes_ = std::move(tree.nodes);

    // Leaves are numbered in the order of their shapes; their blocks by kind.
    std::vector<std::uint32_t> blockOf;
    blockOf.reserve(tree.leaves.size());
    std::size_t ball = 0, box = 0;
    for (const Leaf& leaf : tree.leaves) {
        if (shapes[leaf.begin].index & kBallBit) {
            blockOf.push_back(static_cast<std::uint32_t>(ballBlocks_.size()));
            addBallBlock(ball, leaf.count);
            ball += leaf.count;
        } else {
            blockOf.push_back(static_cast<std::uint32_t>(boxBlocks_.size()));
            addBoxBlock(box, leaf.count, instances);
            box += leaf.count;
        }
    }
    for (Node8& node : nodes_)
        for (std::uint32_t& child : node.child)
            if (child & kLeafBit) child = (child & ~kChildMask) | blockOf[child & kChildMask];
}

void ShapeLists::addBallBlock(std::size_t first, std::size_t count) {
    BallBlock& block = ballBlocks_.emplace_back();
    block.first = static_cast<std::uint32_t>(first);
    block.count = static_cast<std::uint32_t>(count);
    for (std::size_t lane = 0; lane < count; ++lane) {
        const Ball& ball = balls_[first + lane];
        setCenter(block, lane, ball.center);
        block.radius[lane] = static_cast<float>((1 + double{kBallMargin}) / ball.inverseRadius);
    }
}

void ShapeLists::addBoxBlock(std::size_t first, std::size_t count,
                             const std::vector<ShapeInstance>& instances) {
    BoxBlock& block = boxBlocks_.emplace_back();
    block.first = static_cast<std::uint32_t>(balls_.size() + first);
    block.count = static_cast<std::uint32_t>(count);
    for (std::size_t lane = 0; lane < count; ++lane) {
        const Entry& entry = boxes_[first + lane];
        const ShapeInstance& instance = instances[entry.index];
        const DVec3 half = localHalf(entry.shape);
        double radius = 0;
        for (int i = 0; i < 3; ++i) radius += half[i] * glm::length(instance.worldFromLocal[i]);
        setCenter(block, lane, entry.center);
        for (int slab = 0; slab < 3; ++slab) {
            const DVec3 normal = row(entry.localFromWorld, slab);
            const double scale = glm::length(normal);
            for (int axis = 0; axis < 3; ++axis)
                block.row[slab][axis][lane] = static_cast<float>(normal[axis] / scale);
            block.half[slab][lane] =
                static_cast<float>(half[slab] / scale + double{kBoxMargin} * radius);
        }
    }
}

void ShapeLists::findSlots(std::size_t instanceCount) {
    slotOf_.assign(instanceCount, kNoShape);
    std::uint32_t slot = 0;
    for (const Ball& ball : balls_) slotOf_[ball.index] = slot++;
    for (const Entry& entry : boxes_) slotOf_[entry.index] = slot++;
}

}  // namespace glint
