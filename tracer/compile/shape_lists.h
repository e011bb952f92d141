// ShapeLists: the analytic shapes of a scene, and the two questions that rays ask of them. Both
// questions share one predicate (firstHit, in double), so a point that is seen can never shadow
// itself. Which shapes come before the predicate is a matter of speed alone (16 balls: 43 Mray/s
// filtered, 10 all in double): float tests of eight shapes at once rule out the rest
// (shape_blocks.h), in one flat list or, above kFlatShapes, in a hierarchy (bvh8.h).
#pragma once

#include <functional>
#include <optional>
#include <variant>
#include <vector>

#include "tracer/base/large_vector.h"
#include "tracer/base/work.h"
#include "tracer/compile/coincidence.h"
#include "tracer/compile/media.h"
#include "tracer/compile/shape_blocks.h"
#include "tracer/math/ray.h"
#include "tracer/math/ray_bundle.h"
#include "tracer/scene/ids.h"
#include "tracer/shapes/all.h"

namespace glint {

/// Half the lengths of a shape's box in its local space; of a plane's, a part.
[[nodiscard]] DVec3 localHalf(const CanonicalShape& shape);

/// One object's shape in render space (the scene's origin is subtracted). Local space is the
/// shape's canonical space.
struct ShapeInstance {
    CanonicalShape shape;
    DMat3 localFromWorld{1.0};
    DMat3 worldFromLocal{1.0};
    DVec3 center{0.0};           ///< of local space, in render space
    double normalScale = 1;      ///< makes unit normals times localFromWorld unit again, where all
                                 ///< axes have one scale
    std::uint32_t material = 0;  ///< index into RenderScene::materials
    std::uint32_t light = ~0u;   ///< index into LightTable::lights, ~0: does not emit
    ObjectId object;
    bool dielectric =
        false;  ///< closed, and its material has an inside: paths track it in a MediaStack

    /// Whether rays meet the other where they meet this one.
    [[nodiscard]] bool coincides(const ShapeInstance& other) const {
        return shape == other.shape && localFromWorld == other.localFromWorld &&
               center == other.center && dielectric == other.dielectric;
    }
    [[nodiscard]] DVec3 localPoint(const DVec3& p) const { return localFromWorld * (p - center); }
    [[nodiscard]] DVec3 localVector(const DVec3& v) const { return localFromWorld * v; }
    /// Whether a point of render space is inside a closed shape.
    [[nodiscard]] bool holds(const DVec3& p) const;
    /// Half the size of the axis-aligned box about `center` around the shape; infinite for a plane.
    [[nodiscard]] DVec3 halfSize() const;
    /// Whether that box meets the box `half` about `p`.
    [[nodiscard]] bool mayReach(const DVec3& p, const DVec3& half) const {
        return glm::all(glm::lessThanEqual(absolute(p - center), half + halfSize()));
    }
};

struct ShapeHit {
    double t = kInfinity;
    std::uint32_t shape = kNoShape;
    int face = 0;
    [[nodiscard]] bool found() const { return shape != kNoShape; }
};

/// Where a ray starts as seen from the shape `index`.
[[nodiscard]] inline Start startOf(const Ray& ray, const MediaStack& media, std::uint32_t index,
                                   bool dielectric) {
    if (ray.fromShape == index) return ray.fromInside ? Start::Entering : Start::Leaving;
    if (dielectric) return media.contains(index) ? Start::KnownInside : Start::KnownOutside;
    return Start::Elsewhere;
}

/// Up to this many shapes lie in one flat list of blocks; more get a hierarchy. Measured
/// (glint-bench rays, AVX2): 128 balls take 81 ns a ray flat and 129 take 97 ns in the hierarchy,
/// mixed shapes 151 and 142.
inline constexpr std::size_t kFlatShapes = 128;
/// A hierarchy whose boxes have grown by more than this factor is built anew.
inline constexpr double kMostGrowth = 1.2;
/// Up to this many are decided one after the other without the filter, which is the faster way from
/// two on (53 against 38 Mray/s for three balls).
inline constexpr std::size_t kUnfilteredShapes = 1;

/// What hits are ordered by: t, but where a boundary that the path leaves and one that it enters
/// coincide up to rounding, the entry comes first. So media that touch share one boundary, with no
/// gap between them.
[[nodiscard]] inline double hitOrder(double t, const Ray& ray, Start start, bool dielectric) {
    if (!dielectric || (start != Start::Entering && start != Start::KnownInside)) return t;
    const double place = std::abs(ray.origin.x) + std::abs(ray.origin.y) + std::abs(ray.origin.z);
    return t + 0x1p-48 * (t + place);  // Some ten roundings of the coordinates that t came from.
}

/// The filtered shapes of a list in blocks of eight, and what tests them.
template <Coordinates kCoordinates>
struct Blocks {
    LargeVector<BallBlock<kCoordinates>> balls;
    LargeVector<BoxBlock<kCoordinates>> boxes;
    BlockKernels<kCoordinates> kernels{};
};

/// The shapes of a list that a bundle of rays can meet, in blocks of their own. Its memory serves
/// one bundle after the other.
struct FewShapes {
    std::variant<Blocks<Coordinates::Single>, Blocks<Coordinates::Pairs>> blocks;
    std::vector<std::uint32_t> balls, boxes;  ///< slots, in the order of the blocks' lanes
    [[nodiscard]] bool isEmpty() const { return balls.empty() && boxes.empty(); }
};
/// Of more shapes than that there is no such list.
inline constexpr std::size_t kMostFew = 64;

class ShapeLists {
  public:
    ShapeLists() = default;
    explicit ShapeLists(const std::vector<ShapeInstance>& instances);
    /// The lists after some of the shapes, `from`, have moved, with the same hierarchy (glint-bench
    /// scale: what it takes). None where there is no hierarchy, where shapes have come, gone or
    /// changed their kind, or where the boxes have grown by more than kMostGrowth since it was
    /// built.
    [[nodiscard]] std::optional<ShapeLists> moved(const std::vector<ShapeInstance>& from,
                                                  const std::vector<ShapeInstance>& to) const;

    /// The nearest hit with t < tMax. Of hits that coincide up to rounding tieOrder() decides; of
    /// equal ones the shape with the lower index wins. Adds what it took to `work`. `few`: what
    /// cull() found for a bundle that holds the ray; null: all shapes.
    [[nodiscard]] ShapeHit closest(const Ray& ray, const MediaStack& media, double tMax,
                                   WorkCounts& work, const FewShapes* few = nullptr) const;
    [[nodiscard]] ShapeHit closest(const Ray& ray, const MediaStack& media,
                                   double tMax = kInfinity) const;
    /// Whether anything but `ignored` is hit before tMax; with `passesMedia`, anything but
    /// dielectrics. `few` as in closest().
    [[nodiscard]] bool occluded(const Ray& ray, const MediaStack& media, double tMax,
                                std::uint32_t ignored, WorkCounts& work,
                                const FewShapes* few = nullptr, bool passesMedia = false) const;
    [[nodiscard]] bool occluded(const Ray& ray, const MediaStack& media, double tMax,
                                std::uint32_t ignored) const;

    /// Finds the shapes that rays of the bundle can meet. False if they are more than kMostFew, or
    /// all shapes are so few that it is not worth while.
    [[nodiscard]] bool cull(const RayBundle& bundle, FewShapes& few) const;

    /// Bytes of the hierarchy (nodes and the map from shapes to slots), and of the shapes' own
    /// data.
    struct Memory {
        std::size_t hierarchy = 0, shapes = 0;
    };
    [[nodiscard]] Memory memory() const;

    /// Blocks of the filter; none where so few shapes are there that all are decided.
    struct BlockCounts {
        std::size_t balls = 0, boxes = 0;
        [[nodiscard]] std::size_t total() const { return balls + boxes; }
    };
    [[nodiscard]] BlockCounts blockCounts() const {
        if (unfiltered_) return {};
        return std::visit(
            [](const auto& blocks) {
                return BlockCounts{blocks.balls.size(), blocks.boxes.size()};
            },
            blocks_);
    }
    [[nodiscard]] bool hasHierarchy() const { return !nodes_.empty(); }
    /// Whether the hierarchy was built for other places of the shapes: see moved().
    [[nodiscard]] bool hasMoved() const { return hasMoved_; }
    /// Whether some shape needs a 3 x 3 matrix.
    [[nodiscard]] bool hasMatrices() const { return !boxes_.empty() || !always_.empty(); }

  private:
    /// A sphere under a similarity: needs no matrix, because turning a ball changes nothing.
    struct Ball {
        DVec3 center;
        double inverseRadius;
        std::uint32_t index = kNoShape;
        bool dielectric;
    };
    /// Any other shape: what intersection needs of an instance.
    struct Entry {
        DVec3 center;
        DMat3 localFromWorld;
        CanonicalShape shape;
        std::uint32_t index = kNoShape;
        bool dielectric, convex, isPlane;
    };
    enum class Kind { Ball, Box, Always };
    struct Asking;
    struct Nearest;
    struct Any;

    template <class Use>
    auto withShape(std::uint32_t index, const Use& use) const;
    [[nodiscard]] double tieOrderOf(const ShapeHit& hit, const Ray& ray) const;

    static Crossing firstHit(const Ball& ball, const Ray& ray, Start start);
    static Crossing firstHit(const Entry& entry, const Ray& ray, Start start);
    static Crossing firstHitOfAny(const Entry& entry, const Ray& ray, Start start);
    static std::optional<Crossing> fromAbove(const Entry& plane, const Ray& ray, Start start);
    static Kind kindOf(const ShapeInstance& instance);
    [[nodiscard]] Kind kindOf(std::uint32_t slot) const;
    static Ball ballOf(const ShapeInstance& instance, std::uint32_t index);
    static Entry entryOf(const ShapeInstance& instance, std::uint32_t index);
    void sortByKind(const std::vector<ShapeInstance>& instances);
    void measure(const ShapeInstance& instance);
    [[nodiscard]] bool areNearZero() const;
    void replace(const ShapeInstance& instance, std::uint32_t index);
    template <Coordinates kCoordinates>
    bool cullBlocks(const RayBundle& bundle, FewShapes& few) const;
    template <Coordinates kCoordinates>
    void buildFlat(const std::vector<ShapeInstance>& instances);
    template <Coordinates kCoordinates>
    void buildTree(const std::vector<ShapeInstance>& instances);
    template <Coordinates kCoordinates>
    [[nodiscard]] BallBlock<kCoordinates> ballBlock(std::size_t first, std::size_t count) const;
    template <Coordinates kCoordinates>
    [[nodiscard]] BoxBlock<kCoordinates> boxBlock(
        std::size_t first, std::size_t count, const std::vector<ShapeInstance>& instances) const;
    template <Coordinates kCoordinates>
    void fillTree(const std::vector<ShapeInstance>& instances,
                  const std::function<bool(std::uint32_t leaf)>& isNew);
    void sortBySlot();

    // A Question is Nearest or Any, and knows the answer for the shapes that have been decided.
    template <class Question>
    void ask(const Ray& ray, const MediaStack& media, Question& question, WorkCounts& work,
             const FewShapes* few) const;
    template <class Question, class List>
    static void decideEach(const Asking& asking, Question& question, const List& list);
    template <class Question>
    void decideAll(const Asking& asking, Question& question) const;
    template <class Question>
    void decideKnown(Asking& asking, Question& question) const;
    template <class Question, class Block, class Kernel, class SlotOf>
    void askFlat(const Asking& asking, Question& question, const LargeVector<Block>& blocks,
                 std::size_t shapes, Kernel kernel, FilterRay& ray, SlotOf slotOf) const;
    template <Coordinates kCoordinates, class Question>
    void askBlocks(const Asking& asking, Question& question, FilterRay& ray,
                   const FewShapes* few) const;
    template <Coordinates kCoordinates, class Question>
    void askTree(const Asking& asking, Question& question, FilterRay& ray) const;
    template <class Question>
    void decideInOrder(const Asking& asking, Question& question, Candidate* candidates,
                       int count) const;
    template <class Question>
    void decideSlot(const Asking& asking, Question& question, std::uint32_t slot) const;

    LargeVector<Entry>
        always_;  ///< decided for every ray: planes, and shapes too skewed for the filter
    // In the order of their blocks; without an index where a block is not full. Slots of boxes
    // follow those of balls.
    LargeVector<Ball> balls_;
    LargeVector<Entry> boxes_;
    std::variant<Blocks<Coordinates::Single>, Blocks<Coordinates::Pairs>> blocks_;
    LargeVector<Node8> nodes_;           ///< empty: the list is flat
    LargeVector<std::uint32_t> slotOf_;  ///< of each shape instance
    double builtArea_ = 0;               ///< of the hierarchy's boxes when it was built [m^2]
    // Of the filtered shapes, since the hierarchy was built: bounds of the absolute coordinates and
    // of the sizes [m].
    double reach_ = 0, leastSize_ = kInfinity;
    std::uint32_t ballSlots_ = 0, boxSlots_ = 0;  ///< lengths of the two lists
    bool unfiltered_ = true;                      ///< so few shapes that all are decided
    bool hasMoved_ = false;
};

/// The first hit of a ray on one given shape, by the same predicate as the lists.
[[nodiscard]] Crossing hitShape(const ShapeInstance& instance, std::uint32_t index, const Ray& ray,
                                const MediaStack& media);

}  // namespace glint
