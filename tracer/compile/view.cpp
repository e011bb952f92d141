#include "tracer/compile/view.h"

#include <algorithm>

#include "tracer/compile/lengths.h"

namespace glint {

namespace {

/// From the largest to the smallest: of nested media the inner one is entered last.
void findCameraMedia(RenderScene& out) {
    const DVec3 reach = out.camera.reach(out.film.filterRadius);
    std::vector<std::uint32_t> around;
    for (std::uint32_t i = 0; i < out.shapes.size(); ++i) {
        const ShapeInstance& shape = out.shapes[i];
        if (shape.dielectric && shape.mayReach(out.camera.position(), reach)) around.push_back(i);
    }
    const auto volume = [&](std::uint32_t i) {
        const DVec3 half = out.shapes[i].halfSize();
        return half.x * half.y * half.z;
    };
    std::stable_sort(around.begin(), around.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return volume(a) > volume(b); });
    out.cameraMedia = {};
    out.cameraBoundaries.clear();
    if (reach != DVec3(0.0)) {
        out.cameraBoundaries = std::move(around);
        return;
    }
    for (const std::uint32_t i : around)
        if (out.shapes[i].holds(out.camera.position())) out.cameraMedia.cross(i);
}

}  // namespace

std::optional<Error> cameraProblem(const Camera& camera) {
    const DVec3 axis = camera.target - camera.position;
    if (!isFinite(axis) || !(largest(axis) > 0))
        return Error{.message = "the camera has no direction to look in",
                     .pointer = "/camera/target",
                     .remedy = "move its position or its target"};
    if (largest(axis) < kLeastLength ||
        !(std::max(largest(camera.position), largest(camera.target)) <= kMostLength))
        return Error{.message = "the camera is too near to its target or too far away",
                     .pointer = "/camera",
                     .remedy = kLengthRemedy};
    // Below this sine of the angle between view and up, rounding decides what is right and left.
    constexpr double kSmallestSine = 1e-9;
    if (!(glm::length(glm::cross(glm::normalize(axis), camera.up)) >
          kSmallestSine * glm::length(camera.up)))
        return Error{.message = "the camera's up lies along the view or has no direction",
                     .pointer = "/camera/up",
                     .remedy = "turn it"};
    const bool perspective = camera.projection == Projection::Perspective;
    if (perspective ? !(camera.verticalFovDegrees > 0 && camera.verticalFovDegrees < 180)
                    : !(camera.orthoHeight > 0))
        return Error{.message = "the camera's field of view is empty or too wide",
                     .pointer = "/camera",
                     .remedy = "use an angle above 0 and below 180 degrees"};
    return std::nullopt;
}

void setView(RenderScene& out, const Scene& scene) {
    out.film = scene.film;
    out.camera = CameraModel(scene.viewCamera(), out.origin, scene.film.width, scene.film.height);
    findCameraMedia(out);
    constexpr auto lens = static_cast<Features>(Feature::Lens);
    out.features = (out.features & ~lens) | (out.camera.hasLens() ? lens : 0u);
}

bool sameButView(const Scene& a, const Scene& b) {
    return a.objects == b.objects && a.groups == b.groups && a.materials == b.materials &&
           a.textures == b.textures && a.lights == b.lights && a.environment == b.environment &&
           a.render == b.render;
}

Result<std::shared_ptr<const RenderScene>> withView(const RenderScene& compiled,
                                                    const Scene& scene) {
    if (auto problem = cameraProblem(scene.viewCamera())) return std::move(*problem);
    auto out = std::make_shared<RenderScene>(compiled);
    setView(*out, scene);
    return std::shared_ptr<const RenderScene>(std::move(out));
}

}  // namespace glint
