// A finished rendering to a picture file, with what is needed to make it again in the file's metadata.
#pragma once

#include <filesystem>

#include "tracer/base/result.h"
#include "tracer/render/render.h"

namespace glint {

/// Writes by the ending of `path`, whole or not at all: linear light to .exr and .hdr, else through the scene's display
/// settings. A rendering with layers becomes a multi-layer EXR, whatever the ending. Metadata: glint:sceneHash, glint:seed, glint:spp, glint:version.
[[nodiscard]] Status saveRendering(const std::filesystem::path& path, const Scene& scene, const Rendering& rendering);

}  // namespace glint
