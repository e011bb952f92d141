// Pictures that scenes name or ask to be computed, kept from one compile to the next.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "tracer/base/result.h"
#include "tracer/io/image_file.h"
#include "tracer/scene/scene.h"

namespace glint {

/// Keeps loaded images between compiles, by path and time of change. One thread uses it at a time.
class AssetCache {
  public:
    /// The picture, loaded at the first call and when its file has changed.
    Result<std::shared_ptr<const Image>> image(const std::filesystem::path& path, ColorSpace space,
                                               int& loads);
    /// The picture of a computed sky; the last one asked for is kept.
    std::shared_ptr<const Image> sky(const Sky& sky);

  private:
    struct Entry {
        std::filesystem::file_time_type time;
        std::shared_ptr<const Image> image;
    };
    std::map<std::pair<std::string, ColorSpace>, Entry> images_;
    Sky sky_;
    std::shared_ptr<const Image> skyImage_;
};

/// A picture that says "missing": a magenta and black checker.
[[nodiscard]] std::shared_ptr<const Image> missingImage();

}  // namespace glint
