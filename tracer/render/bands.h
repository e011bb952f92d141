// How a render fits into memory: at once, or in bands of rows one after the other. A film takes six
// times the memory of the picture that it becomes, and a band's film is given up before the next
// one's is made. Samples belong to pixels, so bands change no bit.
#pragma once

#include "tracer/base/result.h"
#include "tracer/render/render.h"

namespace glint {

/// The rows of the request's rectangle that can be rendered at once with that many bytes: all, or a
/// multiple of Film::kTile. An error where not even a few can be, or where the picture has to be
/// rendered at once and does not fit.
[[nodiscard]] Result<int> rowsAtOnce(const RenderScene& scene, const RenderRequest& request,
                                     double bytes);

/// The request's rectangle in bands of that many rows. `renderPart(request, picture)` renders one
/// and puts it into the picture.
[[nodiscard]] Rendering renderInBands(
    const RenderScene& scene, const RenderRequest& request, int rows,
    const std::function<Rendering(const RenderRequest&, Image&)>& renderPart);

}  // namespace glint
