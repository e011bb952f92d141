#include "tracer/compile/media_contacts.h"

#include <algorithm>
#include <vector>

#include "tracer/math/bounds.h"

namespace glint {
namespace {

/// A little larger than the shape, for the rounding of places that should coincide.
Bounds boundsOf(const ShapeInstance& shape) {
    constexpr double kSlack = 1e-9;
    const DVec3 half = shape.halfSize(), slack = kSlack * (half + absolute(shape.center));
    return Bounds::around(shape.center, half + slack);
}

std::vector<Bounds> boundsOfMedia(const RenderScene& scene) {
    std::vector<Bounds> boxes;
    for (const ShapeInstance& shape : scene.shapes)
        if (shape.dielectric) boxes.push_back(boundsOf(shape));
    std::sort(boxes.begin(), boxes.end(),
              [](const Bounds& a, const Bounds& b) { return a.lower.x < b.lower.x; });
    return boxes;
}

/// The most of `boxes` that share a place, on the axes from `axis` on. One of them begins there on
/// each axis.
int mostAtOnePlace(const std::vector<Bounds>& boxes, int axis, int enough) {
    const int all = static_cast<int>(boxes.size());
    if (axis == 3 || all <= 1) return all;
    int most = 0;
    for (const Bounds& first : boxes) {
        std::vector<Bounds> there;
        for (const Bounds& box : boxes)
            if (box.lower[axis] <= first.lower[axis] && first.lower[axis] <= box.upper[axis])
                there.push_back(box);
        if (static_cast<int>(there.size()) > most)
            most = std::max(most, mostAtOnePlace(there, axis + 1, enough));
        if (most > enough) break;
    }
    return most;
}

}  // namespace

bool mediaMayMatch(const RenderScene& scene) {
    for (const ShapeInstance& shape : scene.shapes)
        if (shape.dielectric && scene.materials[shape.material].medium.ior == 1) return true;
    const std::vector<Bounds> boxes = boundsOfMedia(scene);
    // From left to right, each against those that begin before it ends.
    for (std::size_t i = 0; i < boxes.size(); ++i)
        for (std::size_t j = i + 1; j < boxes.size() && boxes[j].lower.x <= boxes[i].upper.x; ++j)
            if (boxes[i].touches(boxes[j])) return true;
    return false;
}

int mostMediaAtOnePlace(const RenderScene& scene, int enough) {
    constexpr std::size_t kMostCrossings = 20'000'000;
    std::size_t steps = 0;
    int most = 0;
    std::vector<Bounds> begun;
    for (const Bounds& box : boundsOfMedia(scene)) {
        std::erase_if(begun, [&](const Bounds& other) { return other.upper.x < box.lower.x; });
        std::vector<Bounds> there{box};
        for (const Bounds& other : begun)
            if (box.touches(other)) there.push_back(other);
        begun.push_back(box);
        if (static_cast<int>(there.size()) > most)
            most = std::max(most, mostAtOnePlace(there, 1, enough));
        if (most > enough || (steps += begun.size()) > kMostCrossings) break;
    }
    return most;
}

}  // namespace glint
