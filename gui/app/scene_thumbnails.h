// SceneThumbnails: small traced pictures of scene files, made in the background and kept on disk
// between runs.
#pragma once

#include <QImage>
#include <QObject>
#include <QSize>
#include <filesystem>
#include <map>

#include "gui/app/memory.h"

namespace glint {

class PreviewRenderer;
struct Scene;

class SceneThumbnails : public QObject {
    Q_OBJECT

  public:
    /// Memory::None keeps nothing on disk.
    SceneThumbnails(PreviewRenderer& renderer, Memory memory, QObject* parent = nullptr);

    /// Asks for the picture of a scene file, to fit `size` device pixels; ready() brings it.
    /// Nothing comes of a broken file.
    void request(const std::filesystem::path& file, QSize size);

  signals:
    void ready(const std::filesystem::path& file, const QImage& picture);

  private:
    void onLoaded(const std::filesystem::path& file, const Scene& preview, const QString& key,
                  const QImage& stored);
    void onReady(const QString& key, const QImage& picture);

    PreviewRenderer& renderer_;
    Memory memory_;
    std::map<QString, std::filesystem::path> files_;  ///< on their way, by preview key
};

}  // namespace glint
