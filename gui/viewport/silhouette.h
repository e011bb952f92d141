// Silhouette: which pixels of the picture show selected objects, by exact rays, and the line around
// them. Pure functions; the viewport runs them in the background, see SelectionOutline.
#pragma once

#include <QColor>
#include <QImage>
#include <QPoint>
#include <cstdint>
#include <memory>
#include <vector>

#include "tracer/scene/ids.h"

namespace glint {

struct RenderScene;

/// What is asked for: a picture of `width` x `height` pixels, and who is selected.
struct SilhouetteRequest {
    std::shared_ptr<const RenderScene> scene;
    int width = 0, height = 0;
    std::vector<ObjectId> selected;  ///< sorted
    ObjectId active;                 ///< none: no one stands out
    std::vector<QPoint>
        seeds;  ///< pixels where selected objects may lie: finds those smaller than a cell
    bool operator==(const SilhouetteRequest&) const = default;
};

enum class Shown : std::uint8_t { Other, Selected, Active };

/// Of every pixel: width x height, row-major, top row first; by the ray through its middle. Rays
/// are spared where a whole cell of 8 x 8 pixels and all around it is alike, so an object or gap
/// that no cell corner, seed or neighbouring boundary touches may be missed.
[[nodiscard]] std::vector<Shown> silhouette(const SilhouetteRequest& request);

/// The line: pixels within `thickness` outside of what is selected, with a dark rim of one pixel.
[[nodiscard]] QImage outlineImage(const std::vector<Shown>& shown, int width, int height,
                                  int thickness, const QColor& selected, const QColor& active);

}  // namespace glint
