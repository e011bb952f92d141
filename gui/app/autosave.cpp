#include "gui/app/autosave.h"

#include <QUuid>
#include <QtConcurrent>
#include <algorithm>

#include "gui/app/asset_paths.h"
#include "gui/app/document.h"
#include "gui/app/text.h"
#include "tracer/io/atomic_file.h"
#include "tracer/io/scene_json.h"

namespace glint {

namespace fs = std::filesystem;

namespace {

const std::string kCopyEnding = ".glint.json", kOriginEnding = ".origin", kLockEnding = ".lock";

/// The file beside a copy with another ending.
fs::path besideCopy(const fs::path& copy, const std::string& ending) {
    std::string name = copy.filename().string();
    return copy.parent_path() / (name.substr(0, name.size() - kCopyEnding.size()) + ending);
}

/// The lock of a copy; it counts as left behind only when its process is gone.
std::unique_ptr<QLockFile> lockOf(const fs::path& copy) {
    auto lock = std::make_unique<QLockFile>(pathText(besideCopy(copy, kLockEnding)));
    lock->setStaleLockTime(0);
    return lock;
}

void removeFiles(const fs::path& copy) {
    std::error_code ignored;
    fs::remove(copy, ignored);
    fs::remove(besideCopy(copy, kOriginEnding), ignored);
}

/// The origin first: a copy never stands without one. Its assets are named by absolute paths, for
/// it lies elsewhere.
Status writeCopy(const fs::path& copy, const fs::path& original, Scene scene,
                 const fs::path& assetFolder) {
    const std::string origin = original.empty() ? std::string() : fs::absolute(original).string();
    if (Status written = writeWhole(besideCopy(copy, kOriginEnding), origin); !written)
        return written;
    return saveScene(withAssetsFrom(std::move(scene), assetFolder, {}), copy);
}

}  // namespace

Autosave::Autosave(Document& document, QObject* parent) : QObject(parent), document_(document) {
    timer_.setSingleShot(true);
    connect(&timer_, &QTimer::timeout, this, &Autosave::write);
    connect(&document, &Document::changed, this, &Autosave::onChanged);
    // The undo stack counts a new step only after changed().
    connect(&document, &Document::titleChanged, this, &Autosave::onChanged);
}

Autosave::~Autosave() {
    writing_.waitForFinished();
    if (!copy_.empty() && !document_.isModified()) removeFiles(copy_);
}

void Autosave::setDelay(std::optional<std::chrono::milliseconds> delay) {
    delay_ = delay;
    timer_.stop();
    onChanged();
}

void Autosave::begin(const fs::path& folder) {
    std::error_code ignored;
    fs::create_directories(folder, ignored);
    folder_ = folder;
    copy_ =
        folder / (QUuid::createUuid().toString(QUuid::WithoutBraces).toStdString() + kCopyEnding);
    lock_ = lockOf(copy_);
    lock_->tryLock(0);
    onChanged();
}

void Autosave::end() {
    timer_.stop();
    if (copy_.empty()) return;
    writing_.waitForFinished();
    removeFiles(copy_);
    copy_.clear();
    lock_.reset();
}

void Autosave::onChanged() {
    if (copy_.empty()) return;
    if (!document_.isModified()) return removeCopy();
    if (delay_ && !timer_.isActive() && !(hasCopy_ && document_.committed() == written_))
        timer_.start(*delay_);
}

void Autosave::removeCopy() {
    timer_.stop();
    for (const Leftover& old : std::exchange(superseded_, {})) discard(old);
    // One that is being written is removed when it stands.
    if (!hasCopy_ || writing_.isRunning()) return;
    removeFiles(copy_);
    hasCopy_ = false;
}

void Autosave::write() {
    constexpr std::chrono::milliseconds kBusy{200};
    if (writing_.isRunning()) return timer_.start(kBusy);
    if (!document_.isModified()) return;
    written_ = document_.committed();
    hasCopy_ = true;
    writing_ =
        QtConcurrent::run(writeCopy, copy_, document_.file(), written_, document_.assetFolder());
    writing_.then(this, [this](const Status& status) { onWritten(status); });
}

void Autosave::onWritten(const Status& status) {
    if (copy_.empty()) return;
    if (!status) {
        hasCopy_ = false;
        if (!std::exchange(failing_, true)) emit failed(toQString(status.error()));
    } else {
        failing_ = false;
        for (const Leftover& old : std::exchange(superseded_, {})) discard(old);
    }
    // What changed meanwhile is still to be written, or the copy is not needed any more.
    onChanged();
}

std::vector<Autosave::Leftover> Autosave::leftovers() const {
    std::vector<Leftover> out;
    std::error_code code;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_, code)) {
        const fs::path& path = entry.path();
        if (path == copy_ || !path.filename().string().ends_with(kCopyEnding)) continue;
        const auto lock = lockOf(path);
        if (!lock->tryLock(0)) continue;  // Its process lives.
        const auto origin = readWhole(besideCopy(path, kOriginEnding), std::size_t{1} << 16U);
        const QFileInfo info(pathText(path));
        out.push_back({path, origin ? fs::path(origin.value()) : fs::path(), info.lastModified()});
    }
    std::sort(out.begin(), out.end(),
              [](const Leftover& a, const Leftover& b) { return a.time > b.time; });
    return out;
}

Status Autosave::recover(const Leftover& leftover) {
    auto loaded = loadScene(leftover.copy);
    if (!loaded) return loaded.error();
    superseded_.push_back(leftover);
    document_.replace(
        withAssetsFrom(std::move(loaded).value(), leftover.copy.parent_path(), leftover.original),
        leftover.original, Document::Origin::Recovered);
    timer_.stop();
    write();
    return Done{};
}

void Autosave::discard(const Leftover& leftover) { removeFiles(leftover.copy); }

}  // namespace glint
