// Small pictures of environment images, made on background threads.
#pragma once

#include <QImage>
#include <QObject>
#include <QSize>
#include <filesystem>
#include <functional>
#include <vector>

namespace glint {

/// The image scaled down to fit `size`, exposed so that its middle grey is visible; null if it
/// cannot be read. Any thread.
[[nodiscard]] QImage makeThumbnail(const std::filesystem::path& path, const QSize& size);

/// Makes one in the background and calls `done` on the thread of `receiver`, unless that is gone.
void requestThumbnail(const std::filesystem::path& path, const QSize& size, QObject* receiver,
                      std::function<void(const QImage&)> done);

/// Files in `folder` that can be environments (.exr, .hdr and common picture formats), by name.
[[nodiscard]] std::vector<std::filesystem::path> environmentFiles(
    const std::filesystem::path& folder);
/// The ending is that of a picture file.
[[nodiscard]] bool isPicture(const std::filesystem::path& path);

}  // namespace glint
