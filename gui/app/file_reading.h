// A scene file on its way from the disk: read on a background thread, taken by
// FileController::load().
#pragma once

#include <QFuture>
#include <filesystem>
#include <memory>

namespace glint {

struct LoadedFile;

struct FileReading {
    std::filesystem::path file;
    QFuture<std::shared_ptr<LoadedFile>> content;
};

/// Begins to read.
[[nodiscard]] FileReading readInBackground(const std::filesystem::path& file);

}  // namespace glint
