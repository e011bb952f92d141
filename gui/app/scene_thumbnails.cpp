#include "gui/app/scene_thumbnails.h"

#include <QDir>
#include <QStandardPaths>
#include <QThreadPool>
#include <QtConcurrent>
#include <optional>

#include "gui/app/preview_renderer.h"
#include "gui/app/preview_scenes.h"
#include "tracer/io/scene_json.h"

namespace glint {

namespace {

QString cacheFolder() {
    return QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + "/thumbnails";
}
QString cacheFile(const QString& key) { return cacheFolder() + '/' + key + ".png"; }

struct Loaded {
    Scene preview;
    QString key;
    QImage stored;  ///< from an earlier run
};

std::shared_ptr<const Loaded> load(const std::filesystem::path& file, QSize size, Memory memory) {
    auto scene = loadScene(file);
    if (!scene.ok()) return {};
    auto loaded = std::make_shared<Loaded>();
    loaded->preview = thumbnailOf(std::move(scene).value(), size);
    loaded->key = previewKey(loaded->preview);
    if (memory == Memory::Settings) loaded->stored.load(cacheFile(loaded->key));
    return loaded;
}

}  // namespace

SceneThumbnails::SceneThumbnails(PreviewRenderer& renderer, Memory memory, QObject* parent)
    : QObject(parent), renderer_(renderer), memory_(memory) {
    connect(&renderer, &PreviewRenderer::ready, this, &SceneThumbnails::onReady);
}

void SceneThumbnails::request(const std::filesystem::path& file, QSize size) {
    QtConcurrent::run([file, size, memory = memory_] {
        return load(file, size, memory);
    }).then(this, [this, file](const std::shared_ptr<const Loaded>& loaded) {
        if (loaded) onLoaded(file, loaded->preview, loaded->key, loaded->stored);
    });
}

void SceneThumbnails::onLoaded(const std::filesystem::path& file, const Scene& preview,
                               const QString& key, const QImage& stored) {
    const QImage known = stored.isNull() ? renderer_.picture(key) : stored;
    if (!known.isNull()) {
        emit ready(file, known);
        return;
    }
    files_[key] = file;
    renderer_.request(
        {key, "scene " + key, preview, std::filesystem::absolute(file).parent_path()});
}

void SceneThumbnails::onReady(const QString& key, const QImage& picture) {
    const auto found = files_.find(key);
    if (found == files_.end()) return;
    emit ready(found->second, picture);
    const bool finished = !renderer_.picture(key).isNull();
    if (!finished) return;
    files_.erase(found);
    if (memory_ == Memory::None) return;
    QThreadPool::globalInstance()->start([key, picture] {
        if (QDir().mkpath(cacheFolder())) picture.save(cacheFile(key));
    });
}

}  // namespace glint
