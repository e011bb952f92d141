// Autosave: keeps a copy of unsaved work on the disk, so that a crash or a kill loses at most half
// a minute, and finds the copies that earlier runs left behind. The person's own file is never
// touched.
#pragma once

#include <QDateTime>
#include <QFuture>
#include <QLockFile>
#include <QObject>
#include <QTimer>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "tracer/base/result.h"
#include "tracer/scene/scene.h"

namespace glint {

class Document;

class Autosave : public QObject {
    Q_OBJECT

  public:
    explicit Autosave(Document& document, QObject* parent = nullptr);
    /// Waits for a copy that is being written. The copy stays if the document is unsaved.
    ~Autosave() override;

    /// Keeps copies in `folder` from now on.
    void begin(const std::filesystem::path& folder);
    /// From an unsaved edit until its copy is begun; writing takes well below a second more. None:
    /// no copies are made.
    void setDelay(std::optional<std::chrono::milliseconds> delay);
    /// The person gave the unsaved changes up: removes the copy and ends.
    void end();

    /// A copy that a run left behind which is no longer there.
    struct Leftover {
        std::filesystem::path copy;
        std::filesystem::path original;  ///< the scene's file; empty: it was untitled
        QDateTime time;                  ///< of the copy
    };
    /// Newest first.
    [[nodiscard]] std::vector<Leftover> leftovers() const;
    /// Makes the copy the document, unsaved. It is removed as soon as this run has its own.
    Status recover(const Leftover& leftover);
    static void discard(const Leftover& leftover);

  signals:
    /// A copy could not be written, and why. Said once until it succeeds again.
    void failed(const QString& reason);

  private:
    void onChanged();
    void write();
    void onWritten(const Status& status);
    void removeCopy();

    Document& document_;
    std::filesystem::path folder_, copy_;  ///< empty before begin()
    std::unique_ptr<QLockFile>
        lock_;  ///< held while this run lives: tells a leftover from a copy in use
    QTimer timer_;
    QFuture<Status> writing_;
    Scene written_;                     ///< what the copy holds
    std::vector<Leftover> superseded_;  ///< recovered ones, removed with the next copy
    std::optional<std::chrono::milliseconds> delay_;
    bool hasCopy_ = false, failing_ = false;
};

}  // namespace glint
