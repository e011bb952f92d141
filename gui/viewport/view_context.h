// ViewContext: what a viewport's gestures work on, and what lies under its pixels.
#pragma once

#include <QWidget>

#include "gui/app/document.h"
#include "gui/app/renderer.h"
#include "gui/app/selection.h"
#include "gui/viewport/gizmo.h"
#include "gui/viewport/view_history.h"
#include "tracer/render/pick.h"

namespace glint {

enum class Pivot { Median, Active, Individual };

struct ToolOptions {
    Tool tool = Tool::Select;
    bool localAxes = false;
    Pivot pivot = Pivot::Median;
    bool snap = false;
    bool operator==(const ToolOptions&) const = default;
};

/// How a person likes to move the view.
struct NavigationOptions {
    bool invertWheel = false;  ///< the wheel towards the hand comes closer
    bool orbitSelection =
        false;  ///< orbit about the selection instead of the point under the pointer
};

struct ViewContext {
    Document& document;
    Selection& selection;
    Renderer& renderer;
    QWidget& widget;
    ViewHistory history;
    ToolOptions tools;
    NavigationOptions navigation{};

    /// In the widget's own (logical) pixels.
    [[nodiscard]] ViewProjection projection() const;
    /// The surface under a pixel of the picture that is shown.
    [[nodiscard]] std::optional<Pick> surfaceAt(const QPointF& at) const;
    /// The item under a pixel: a glyph, or an object that is not locked.
    [[nodiscard]] std::optional<Item> itemAt(const QPointF& at) const;
    /// Items that lie wholly within a rectangle of pixels.
    [[nodiscard]] std::vector<Item> itemsWithin(const QRectF& box) const;
    /// Where a new thing would stand: on the surface under the pixel, on the ground, or at the
    /// camera's target.
    struct Placement {
        DVec3 position{0.0};
        DVec3 normal{0, 1, 0};
    };
    [[nodiscard]] Placement placementAt(const QPointF& at) const;
    /// The gizmo for the selection, or nothing while no tool or item is chosen.
    [[nodiscard]] std::optional<GizmoFrame> gizmoFrame() const;
    /// The selected items that a tool may change.
    [[nodiscard]] std::vector<Item> movableItems() const;
};

}  // namespace glint
