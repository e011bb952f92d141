// What is drawn over the traced picture: glyphs of lights and cameras, grid, safe frame, gizmo.
// Functions from a scene and a view to strokes; nothing here changes anything.
#pragma once

#include <QPainter>
#include <vector>

#include "gui/app/item.h"
#include "gui/viewport/gizmo.h"

namespace glint {

/// Colours of the overlay: axes x, y, z, selection, active item, hovered handle.
struct OverlayColors {
    QColor axes[3] = {QColor(226, 82, 84), QColor(122, 182, 72), QColor(84, 142, 226)};
    QColor selected{245, 152, 52}, active{255, 196, 96}, handle{240, 240, 240},
        hovered{255, 228, 96};
};

/// Smallest convex polygon around the points (Andrew's monotone chain).
[[nodiscard]] QPolygonF convexHull(std::vector<QPointF> points);
/// The hull of an object on the screen, which holds all of it; for an infinite plane a square about
/// its origin. Empty if out of sight.
[[nodiscard]] QPolygonF outlineOf(const Scene& scene, const Object& object,
                                  const ViewProjection& view);

void paintGrid(QPainter& painter, const ViewProjection& view, const DVec3& around);
/// Marks where lights and other cameras are; `selected` ones stand out.
void paintGlyphs(QPainter& painter, const Scene& scene, const std::vector<Item>& selected,
                 const ViewProjection& view);
/// The part of the view that a picture of the film's size shows; what is outside is dimmed.
void paintSafeFrame(QPainter& painter, const FilmSettings& film, const ViewProjection& view);
void paintGizmo(QPainter& painter, const ViewProjection& view, const GizmoFrame& frame, Tool tool,
                Handle hovered);
/// The three axes in a corner, as the view sees them.
void paintAxesCorner(QPainter& painter, const ViewProjection& view);

/// The light or camera whose glyph is under the pointer.
[[nodiscard]] std::optional<Item> glyphAt(const Scene& scene, const ViewProjection& view,
                                          const QPointF& at);
/// Where the glyphs are.
struct Glyph {
    Item item;
    QPointF at;
};
[[nodiscard]] std::vector<Glyph> glyphsOf(const Scene& scene, const ViewProjection& view);

}  // namespace glint
