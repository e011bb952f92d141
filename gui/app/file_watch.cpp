#include "gui/app/file_watch.h"

#include <chrono>
#include <set>
#include <variant>

#include "gui/app/document.h"
#include "gui/app/text.h"

namespace glint {

namespace fs = std::filesystem;

namespace {

constexpr std::chrono::milliseconds kQuiet{200};

std::set<fs::path> assetsOf(const Scene& scene, const fs::path& folder) {
    std::set<fs::path> out;
    const auto add = [&](const std::string& path) {
        if (!path.empty()) out.insert((folder / path).lexically_normal());
    };
    add(scene.environment.image);
    scene.textures.forEach([&](TextureId, const Texture& texture) { add(texture.file); });
    scene.objects.forEach([&](ObjectId, const Object& object) {
        if (const auto* mesh = std::get_if<Mesh>(&object.shape)) add(mesh->file);
    });
    return out;
}

std::optional<fs::file_time_type> timeOf(const fs::path& file) {
    std::error_code code;
    const auto time = fs::last_write_time(file, code);
    return code ? std::nullopt : std::optional(time);
}

}  // namespace

FileWatch::FileWatch(const Document& document, QObject* parent)
    : QObject(parent), document_(document) {
    for (QTimer* timer : {&listTimer_, &checkTimer_}) {
        timer->setSingleShot(true);
        timer->setInterval(kQuiet);
    }
    connect(&listTimer_, &QTimer::timeout, this, &FileWatch::updateList);
    connect(&checkTimer_, &QTimer::timeout, this, &FileWatch::check);
    const auto changed = [this] { checkTimer_.start(); };
    connect(&watcher_, &QFileSystemWatcher::fileChanged, this, changed);
    connect(&watcher_, &QFileSystemWatcher::directoryChanged, this, changed);
    const auto relist = [this] {
        if (!listTimer_.isActive()) listTimer_.start();
    };
    connect(&document, &Document::changed, this, relist);
    connect(&document, &Document::titleChanged, this, relist);
    connect(&document, &Document::replaced, this, [this] {
        noteSceneFile();
        updateList();
    });
}

void FileWatch::noteSceneFile() {
    sceneTime_ = document_.file().empty() ? std::nullopt : timeOf(document_.file());
}

void FileWatch::updateList() {
    std::map<fs::path, Time> assets;
    for (const fs::path& file : assetsOf(document_.scene(), document_.assetFolder())) {
        const auto known = assets_.find(file);
        assets[file] = known != assets_.end() ? known->second : timeOf(file);
    }
    assets_ = std::move(assets);
    // Folders too: many programs put a new file in the place of the old one, which ends the watch
    // on it.
    std::set<QString> wanted;
    const auto want = [&](const fs::path& file) {
        for (const fs::path& path : {file, fs::absolute(file).parent_path()})
            if (std::error_code code; fs::exists(path, code)) wanted.insert(pathText(path));
    };
    for (const auto& [file, time] : assets_) want(file);
    if (!document_.file().empty()) want(document_.file());
    const QStringList watched = watcher_.files() + watcher_.directories();
    for (const QString& path : watched)
        if (wanted.erase(path) == 0) watcher_.removePath(path);
    if (!wanted.empty()) watcher_.addPaths(QStringList(wanted.begin(), wanted.end()));
}

void FileWatch::check() {
    QStringList changed;
    for (auto& [file, time] : assets_)
        if (const Time now = timeOf(file); now != time) {
            time = now;
            changed << pathText(file);
        }
    updateList();
    if (!changed.isEmpty()) emit assetsChanged(changed);
    if (document_.file().empty()) return;
    const Time now = timeOf(document_.file());
    if (now && now != std::exchange(sceneTime_, now)) emit sceneFileChanged();
}

}  // namespace glint
