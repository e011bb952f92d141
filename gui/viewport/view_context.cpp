#include "gui/viewport/view_context.h"

#include <algorithm>

#include "gui/viewport/overlay.h"

namespace glint {

namespace {

/// Orthonormal axes nearest to the item's own.
DMat3 orthonormal(const DMat3& m) {
    const DVec3 x = glm::normalize(m[0]), y = glm::normalize(m[1] - x * glm::dot(x, m[1]));
    return {x, y, glm::cross(x, y)};
}

}  // namespace

ViewProjection ViewContext::projection() const {
    const Scene& scene = document.scene();
    const double width = widget.width(), height = widget.height();
    return {fittedCamera(scene.viewCamera(), scene.film, width, height), width, height};
}

std::optional<Pick> ViewContext::surfaceAt(const QPointF& at) const {
    const SessionFrame* frame = renderer.frame();
    if (!frame || !frame->scene || widget.height() == 0) return std::nullopt;
    // The picture keeps the widget's height: during a resize its width may still be another.
    const double scale = static_cast<double>(frame->height) / widget.height();
    const double x = frame->width / 2.0 + (at.x() - widget.width() / 2.0) * scale;
    return pick(*frame->scene, frame->width, frame->height, x, at.y() * scale);
}

std::optional<Item> ViewContext::itemAt(const QPointF& at) const {
    const Scene& scene = document.scene();
    if (const auto glyph = glyphAt(scene, projection(), at)) return glyph;
    const auto surface = surfaceAt(at);
    if (!surface || !scene.objects.find(surface->object)) return std::nullopt;
    const Item item = Item::of(surface->object);
    return isLockedInTree(scene, item) ? std::nullopt : std::optional(item);
}

std::vector<Item> ViewContext::itemsWithin(const QRectF& box) const {
    const Scene& scene = document.scene();
    const ViewProjection view = projection();
    std::vector<Item> out;
    scene.objects.forEach([&](ObjectId id, const Object& object) {
        if (!isVisible(scene, object) || isLockedInTree(scene, Item::of(id)) ||
            std::holds_alternative<Plane>(object.shape))
            return;
        const QPolygonF outline = outlineOf(scene, object, view);
        if (!outline.isEmpty() && box.contains(outline.boundingRect())) out.push_back(Item::of(id));
    });
    for (const Glyph& glyph : glyphsOf(scene, view))
        if (box.contains(glyph.at)) out.push_back(glyph.item);
    return out;
}

ViewContext::Placement ViewContext::placementAt(const QPointF& at) const {
    if (const auto surface = surfaceAt(at)) return {surface->position, surface->normal};
    const ViewRay ray = projection().ray(at);
    constexpr double kFarthest = 100;  // metres: beyond, the ground is at the horizon
    const double t = ray.direction.y != 0 ? -ray.origin.y / ray.direction.y : -1;
    if (t > 0 && t < kFarthest) return {ray.origin + ray.direction * t, {0, 1, 0}};
    return {document.scene().viewCamera().target, {0, 1, 0}};
}

std::vector<Item> ViewContext::movableItems() const {
    const Scene& scene = document.scene();
    std::vector<Item> items = topmost(scene, selection.items());
    const Item viewer =
        scene.activeCamera ? Item::of(scene.activeCamera) : Item{ItemKind::Camera, 0};
    std::erase_if(items, [&](Item item) { return item == viewer || isLockedInTree(scene, item); });
    return items;
}

std::optional<GizmoFrame> ViewContext::gizmoFrame() const {
    if (tools.tool == Tool::Select) return std::nullopt;
    const std::vector<Item> items = movableItems();
    if (items.empty()) return std::nullopt;
    const Scene& scene = document.scene();
    GizmoFrame frame;
    if (tools.pivot == Pivot::Active) {
        frame.origin = worldFromItem(scene, items.back()).translation;
    } else {
        for (const Item item : items)
            frame.origin +=
                worldFromItem(scene, item).translation / static_cast<double>(items.size());
    }
    // A scale along other axes than an object's own would shear it: with one object the scale tool
    // takes its own.
    const bool own = tools.localAxes || (tools.tool == Tool::Scale && items.size() == 1);
    if (own) frame.axes = orthonormal(worldFromItem(scene, items.back()).linear);
    return frame;
}

}  // namespace glint
