// Renderer: the bridge between a document and its render session. Publishes what changed, and says
// on the GUI thread when a newer frame is there. Nothing here waits.
#pragma once

#include <QObject>
#include <QPoint>
#include <QRectF>
#include <QSize>
#include <atomic>
#include <functional>
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
    [[nodiscard]] bool isPaused() const { return paused_; }
    [[nodiscard]] Channel channel() const { return view_.paint.channel; }
    /// Whether frame() shows what was asked for last; false while edits are on their way to the
    /// screen.
    [[nodiscard]] bool isCurrent() const { return frame_ && frame_->revision == published_; }
    [[nodiscard]] bool isFiltered() const { return view_.paint.filtered; }
    /// As a part of the picture: 0 to 1 both ways.
    [[nodiscard]] const std::optional<QRectF>& region() const { return region_; }
    [[nodiscard]] bool isIsolated() const { return !isolated_.empty(); }

    /// Size of the picture in device pixels.
    void setSize(QSize size);
    [[nodiscard]] QSize size() const { return {view_.width, view_.height}; }
    void setPaused(bool paused);
    /// Renders on at most so many threads from now on, 0 for one a processor. Nothing starts again.
    void setThreads(int threads);
    /// Draws the same scene again, from files that may have changed.
    void reload() { session_->readFilesAgain(); }
    void setChannel(Channel channel);
    void setFiltered(bool filtered);
    /// Only this part of the picture gets samples; nothing: all of it.
    void setRegion(const std::optional<QRectF>& region);
    /// Renders without the other objects, unless empty. The document stays as it is.
    void setIsolated(std::vector<ObjectId> objects);
    /// Shows this scene, from where the document is looked at, instead of the document's, until it
    /// is edited; nothing: the document.
    void setCompared(std::optional<Scene> scene);
    [[nodiscard]] bool isComparing() const { return compared_.has_value(); }
    /// Tells the linear light of a pixel of the picture when the next frame comes. A new question
    /// takes the place of one not yet answered.
    void probe(QPoint pixel, std::function<void(const Rgb& light)> answer);
    /// Out of sight nothing is rendered.
    void setShown(bool shown);

  signals:
    void frameReady();
    void pausedChanged(bool paused);
    /// Channel, filter, region, isolation or comparison are others.
    void viewChanged();

  private:
    void onDocumentChanged(const Scene& before);
    void publishScene();
    void publishView();
    void takeFrame();
    void answerProbe();
    void changeView();

    const Document& document_;
    bool paused_ = false, shown_ = true;
    std::optional<QRectF> region_;
    std::function<void(const Rgb&)>
        probeAnswer_;  ///< to the question in view_.paint.probe; null: there is none
    std::vector<ObjectId> isolated_;
    std::optional<Scene> compared_;
    ViewSettings view_;
    const SessionFrame* frame_ = nullptr;
    std::uint64_t published_ = 0;        ///< revision of the scene that was published last
    std::filesystem::path assetFolder_;  ///< as published
    /// An event is on its way. Set by the session's thread, cleared on the GUI thread before it
    /// takes the frame; both acquire and release, so that a frame whose event was spared is seen by
    /// that take.
    std::atomic<bool> eventPending_{false};
    std::unique_ptr<Session> session_;
};

}  // namespace glint
