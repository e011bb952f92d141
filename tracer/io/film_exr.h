// EXR files: floats, any channels, text metadata. OpenEXR only; no other library.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tracer/io/image_file.h"

namespace glint {

/// One channel of an EXR file, e.g. "R", "albedo.G", "depth.Z".
struct ExrChannel {
    std::string name;
    std::vector<float> values;  ///< height x width, row-major, top row first
};

struct ExrFile {
    int width = 0, height = 0;
    std::vector<ExrChannel> channels;
    ImageMetadata metadata;
    bool halfColors =
        false;  ///< 16 bits for channels of colours (R, G, B, A); the others need all 32
};

/// Writes floats, ZIP compressed; whole or not at all.
[[nodiscard]] Status saveExr(const std::filesystem::path& path, const ExrFile& file);
/// Reads all channels of the first part as floats.
[[nodiscard]] Result<ExrFile> loadExr(const std::filesystem::path& path);

}  // namespace glint
