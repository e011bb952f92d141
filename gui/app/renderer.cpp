#include "gui/app/renderer.h"

#include <algorithm>
#include <thread>

#include "gui/app/document.h"
#include "gui/viewport/projection.h"

namespace glint {

namespace {

int workerCount(int wanted) { return wanted > 0 ? wanted : std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

DisplaySettings displaySettings(const Scene& scene) { return {scene.display.exposureEv, scene.display.view}; }

}  // namespace

Renderer::Renderer(const Document& document, QObject* parent) : QObject(parent), document_(document) {
    startSession();
    connect(&document, &Document::changed, this, &Renderer::onDocumentChanged);
    connect(&document, &Document::titleChanged, this, [this] {
        if (document_.assetFolder() != assetFolder_) publishScene();
    });
}

void Renderer::startSession() {
    // The old session goes first: its frames are the ones that frame_ points to.
    frame_ = nullptr;
    session_.reset();
    session_ = std::make_unique<Session>(workerCount(threads_), [this] {
        if (!eventPending_.exchange(true, std::memory_order_acq_rel))
            QMetaObject::invokeMethod(this, &Renderer::takeFrame, Qt::QueuedConnection);
    });
    publishScene();
    publishView();
}

void Renderer::setThreads(int threads) {
    if (threads == threads_) return;
    threads_ = threads;
    startSession();
}

// The session goes first: its threads call back into this object.
Renderer::~Renderer() { session_.reset(); }

void Renderer::setSize(QSize size) {
    view_.width = std::max(0, size.width());
    view_.height = std::max(0, size.height());
    publishView();
    publishScene();
}

void Renderer::setPaused(bool paused) {
    if (view_.paused == paused) return;
    view_.paused = paused;
    publishView();
    emit pausedChanged(paused);
}

void Renderer::onDocumentChanged(const Scene& before) {
    const Scene& after = document_.scene();
    if (before.display != after.display) publishView();
    // Exposure and the like are applied to the film that is there: no restart.
    Scene traced = before;
    traced.display = after.display;
    if (!(traced == after)) publishScene();
}

void Renderer::publishScene() {
    assetFolder_ = document_.assetFolder();
    const Scene& scene = document_.scene();
    const Camera camera = fittedCamera(scene.viewCamera(), scene.film, view_.width, view_.height);
    session_->publish(withViewCamera(scene, camera), assetFolder_);
}

void Renderer::publishView() {
    view_.paint.display = displaySettings(document_.scene());
    session_->publish(view_);
}

void Renderer::takeFrame() {
    eventPending_.exchange(false, std::memory_order_acq_rel);
    if (const SessionFrame* frame = session_->take()) {
        frame_ = frame;
        emit frameReady();
    }
}

}  // namespace glint
