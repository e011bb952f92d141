// A finished rendering to a picture file, with what is needed to make it again in the file's
// metadata.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "tracer/base/result.h"
#include "tracer/render/render.h"

namespace glint {

/// What a picture file shall hold beyond the scene's own settings.
struct PictureOptions {
    int bits = 0;              ///< a channel: 8, 16 or 32; 0: what is usual for the format
    bool transparent = false;  ///< the environment behind the objects becomes an alpha channel
    bool layers = false;       ///< light, albedo, normal ... beside the picture, see layers.h
    bool filter = false;       ///< denoised for a preview: layers filtered.R, .G, .B of an .exr,
                               ///< elsewhere in place of the picture
    std::optional<PixelRect> crop;  ///< the rest stays black, or clear
    bool operator==(const PictureOptions&) const = default;
};

/// Whether a file of that name can hold it, and if not, what can. Says nothing about the disk.
[[nodiscard]] Status checkPicture(const std::filesystem::path& path, const PictureOptions& options);

/// The scene to compile for such a picture: without the environment behind the objects if it is to
/// be transparent. The light of a sun's disc stays, in pixels with alpha 0.
[[nodiscard]] Scene sceneFor(Scene scene, const PictureOptions& options);
/// What to ask of render() for it.
[[nodiscard]] RenderRequest requestFor(const PictureOptions& options);

/// Writes by the ending of `path`, whole or not at all: linear light to .exr and .hdr, else through
/// `scene`'s display settings. Colours are multiplied by alpha in .exr and not in others, as is
/// usual. `scene` is the one before sceneFor(). Metadata: glint:sceneHash (of worldOf()),
/// glint:settings, glint:spp, glint:seed, glint:version, glint:features, and where they apply
/// glint:bits, glint:crop, glint:layers, glint:transparent, glint:filtered, glint:biased,
/// glint:uneven.
[[nodiscard]] Status saveRendering(const std::filesystem::path& path, const Scene& scene,
                                   const Rendering& rendering, const PictureOptions& options = {},
                                   const std::string& features = {});

/// What a picture's metadata says of how it was made.
struct PictureRecipe {
    std::string sceneHash, settings, version, features;
    int spp = 0;
    PictureOptions options;
    bool even = true;  ///< every pixel has exactly `spp` samples
};
/// Errors: no metadata (a .hdr has room for none), or not Glint's.
[[nodiscard]] Result<PictureRecipe> recipeOf(const ImageMetadata& metadata,
                                             const std::filesystem::path& picture);

/// The scene without what a picture's own settings say (camera, film, render, display) and what is
/// never seen (views, editor).
[[nodiscard]] Scene worldOf(Scene scene);

}  // namespace glint
