// The small scenes that previews show. Pure functions.
#pragma once

#include <QSize>
#include <QString>

#include "tracer/scene/scene.h"

namespace glint {

/// A ball of the material, with what the material is made of, in a small studio: a soft key light,
/// a strip at the side, and a chequered wall that shows what glass does. `size` in device pixels.
[[nodiscard]] Scene materialPreview(const Scene& scene, MaterialId material, QSize size);
/// The scene with its film cut down to fit `size`, and samples for a thumbnail.
[[nodiscard]] Scene thumbnailOf(Scene scene, QSize size);
/// Equal for equal pictures.
[[nodiscard]] QString previewKey(const Scene& preview);

}  // namespace glint
