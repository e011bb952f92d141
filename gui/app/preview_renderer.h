// PreviewRenderer: traces small pictures in the background, one at a time, on one thread of low
// priority, and keeps them. What is drawn, and under which key, is the caller's matter: see
// preview_scenes.h.
#pragma once

#include <QHash>
#include <QImage>
#include <QObject>
#include <QStringList>
#include <atomic>
#include <filesystem>
#include <memory>
#include <thread>
#include <vector>

#include "tracer/base/channel.h"
#include "tracer/scene/scene.h"

namespace glint {

/// A picture to make. Equal keys mean equal pictures. A newer job for the same slot (one shown
/// place) makes an older one void.
struct PreviewJob {
    QString key, slot;
    Scene scene;  ///< its film and spp are used as they are
    std::filesystem::path assetFolder;
    bool drafted = false;  ///< the coarse picture has been shown
};

class PreviewRenderer : public QObject {
    Q_OBJECT

  public:
    explicit PreviewRenderer(QObject* parent = nullptr);
    /// Stops at the next path vertex.
    ~PreviewRenderer() override;

    /// The finished picture, or null.
    [[nodiscard]] QImage picture(const QString& key) const { return pictures_.value(key); }
    /// Makes the picture unless it is there or on its way.
    void request(PreviewJob job);
    [[nodiscard]] bool isIdle() const { return !running_; }
    /// Nothing is begun until release(): at the start of the program the picture of the scene comes
    /// first.
    void hold() { held_ = true; }
    [[nodiscard]] bool isHeld() const { return held_; }
    void release();

  signals:
    /// From now on requests are served.
    void released();
    /// A coarse picture first, then the finished one.
    void ready(const QString& key, const QImage& picture);

  private:
    /// What both threads know of the job that runs.
    struct Running {
        PreviewJob job;
        std::atomic<bool> stop{false};  ///< set by the GUI thread, read by the render; relaxed:
                                        ///< nothing else hangs on it
    };
    void startNext();
    void keep(const QString& key, const QImage& picture);
    void finish(const std::shared_ptr<Running>& done, const QImage& picture);
    void work(const std::stop_token& end);

    QHash<QString, QImage> pictures_;
    QStringList order_;  ///< of pictures_, oldest first
    std::vector<PreviewJob> waiting_;
    std::shared_ptr<Running> running_;
    bool held_ = false;

    Inbox<std::shared_ptr<Running>> inbox_;
    std::atomic<int> wake_{
        0};  ///< raised with release after a push, awaited with acquire by work()
    std::jthread thread_;
};

/// A rendering as the screen shows it, at the scene's exposure.
struct Image;
[[nodiscard]] QImage screenPicture(const Image& image, const Display& display);

}  // namespace glint
