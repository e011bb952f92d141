// Renderer: the bridge between a document and its render session. Publishes what changed, and says on the GUI thread when a
// newer frame is there. Nothing here waits.
#pragma once

#include <QObject>
#include <QSize>
#include <atomic>
#include <memory>

#include "tracer/render/session.h"

namespace glint {

class Document;

class Renderer : public QObject {
    Q_OBJECT

  public:
    explicit Renderer(const Document& document, QObject* parent = nullptr);
    ~Renderer() override;

    /// The newest frame, or null before the first. Valid until the next frameReady().
    [[nodiscard]] const SessionFrame* frame() const { return frame_; }
    [[nodiscard]] bool isPaused() const { return view_.paused; }

    /// Size of the picture in device pixels.
    void setSize(QSize size);
    void setPaused(bool paused);
    /// Renders on so many threads from now on, 0 for one a processor; the picture starts again.
    void setThreads(int threads);
    /// Draws the same scene again, from files that may have changed.
    void reload() { publishScene(); }

  signals:
    void frameReady();
    void pausedChanged(bool paused);

  private:
    void onDocumentChanged(const Scene& before);
    void publishScene();
    void publishView();
    void takeFrame();
    void startSession();

    const Document& document_;
    int threads_ = 0;  ///< as asked for
    ViewSettings view_;
    const SessionFrame* frame_ = nullptr;
    std::filesystem::path assetFolder_;  ///< as published
    /// An event is on its way. Set by the session's thread, cleared on the GUI thread before it takes the frame; both
    /// acquire and release, so that a frame whose event was spared is seen by that take.
    std::atomic<bool> eventPending_{false};
    std::unique_ptr<Session> session_;
};

}  // namespace glint
