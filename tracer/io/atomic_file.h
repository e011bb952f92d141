// Files that are written whole or not at all: to a hidden sibling first, which then takes the
// file's place.
#pragma once

#include <cstdio>
#include <filesystem>
#include <string_view>

#include "tracer/base/result.h"

namespace glint {

/// A file beside `target` that replaces it on commit() and vanishes otherwise.
class SiblingFile {
  public:
    /// Makes the sibling. Errors: no such folder, no permission, `target` is something else than a
    /// file.
    [[nodiscard]] static Result<SiblingFile> create(const std::filesystem::path& target);

    SiblingFile(SiblingFile&& other) noexcept;
    SiblingFile& operator=(SiblingFile&&) = delete;
    ~SiblingFile();

    /// Open for writing and seeking. Owned by this.
    [[nodiscard]] std::FILE* stream() const { return stream_; }
    /// Flushes to the disk and renames. Errors: the disk is full, and whatever else had failed on
    /// the stream.
    [[nodiscard]] Status commit();

  private:
    SiblingFile(std::filesystem::path shown, std::filesystem::path target,
                std::filesystem::path sibling, std::FILE* stream);

    std::filesystem::path shown_;  ///< the target as it was given, for errors
    std::filesystem::path target_, sibling_;
    std::FILE* stream_;
};

/// Writes `bytes` as the file's content.
[[nodiscard]] Status writeWhole(const std::filesystem::path& path, std::string_view bytes);

/// Whether a file could be written there, found out by making its sibling and removing it.
[[nodiscard]] Status checkWritable(const std::filesystem::path& path);

/// The content of a file of at most `limit` bytes. Errors: cannot be read, a folder, too large.
[[nodiscard]] Result<std::string> readWhole(const std::filesystem::path& path, std::size_t limit);

}  // namespace glint
