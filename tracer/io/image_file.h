// Pictures in files. EXR goes through OpenEXR directly; every other format through the module
// `glint_image` (OpenImageIO), opened with the first picture that needs it because it takes 0.3 s
// to load.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "tracer/base/result.h"
#include "tracer/textures/texture.h"

namespace glint {

/// A linear Rec.709 picture.
struct Image {
    int width = 0, height = 0;
    std::vector<float> rgb;  ///< height x width x 3, row-major, top row first
};

/// Larger pictures are refused before memory is taken for them.
inline constexpr std::int64_t kMostImagePixels = std::int64_t{1} << 30;

/// Text stored in a picture file: scene hash, seed, spp, version ...
using ImageMetadata = std::map<std::string, std::string>;

/// Reads any picture. ColorSpace::Auto takes integer formats as sRGB and float formats as linear.
/// Grey becomes RGB, alpha is dropped. Errors: cannot be opened, not a picture, truncated, larger
/// than kMostImagePixels, a value that is not finite, no module. May be called from any thread.
[[nodiscard]] Result<std::shared_ptr<const Image>> loadImage(const std::filesystem::path& path,
                                                             ColorSpace space = ColorSpace::Auto);

/// A picture as a screen takes it, from the display transform.
struct DisplayImage {
    int width = 0, height = 0;
    int channels = 3;                  ///< 4: with alpha, by which the colours are not multiplied
    int bits = 8;                      ///< or 16
    std::vector<std::uint16_t> codes;  ///< height x width x channels, row-major, top row first
};

/// Writes a picture by the ending of `path`, whole or not at all: .exr and .hdr linear, .png .jpg
/// .tif for the screen.
[[nodiscard]] Status saveLinear(const std::filesystem::path& path, const Image& image,
                                const ImageMetadata& metadata);
[[nodiscard]] Status saveDisplay(const std::filesystem::path& path, const DisplayImage& display,
                                 const ImageMetadata& metadata);

/// A picture as it stands in its file, for comparing bits: every channel, nothing decoded.
struct RawImage {
    int width = 0, height = 0;
    std::map<std::string, std::vector<float>> channels;  ///< by name; height x width each
    ImageMetadata metadata;                              ///< empty where the format holds none
};
/// Errors as for loadImage, which this differs from by what it leaves alone.
[[nodiscard]] Result<RawImage> loadRaw(const std::filesystem::path& path);

/// Bits a channel that a format can be written with, the usual choice first; for a name that is not
/// writable: none.
[[nodiscard]] std::vector<int> bitDepths(const std::filesystem::path& path);
/// The format holds an alpha channel.
[[nodiscard]] bool holdsAlpha(const std::filesystem::path& path);
/// The ending names a format that holds linear light (.exr, .hdr).
[[nodiscard]] bool isLinearFormat(const std::filesystem::path& path);
/// The ending, in upper or lower case, is one of writableEndings().
[[nodiscard]] bool isWritableFormat(const std::filesystem::path& path);
/// Endings that can be written, with the dot.
[[nodiscard]] const std::vector<std::string>& writableEndings();

}  // namespace glint
