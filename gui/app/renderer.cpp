#include "gui/app/renderer.h"

#include <algorithm>
#include <thread>

#include "gui/app/document.h"
#include "gui/viewport/projection.h"

namespace glint {

namespace {

int workerCount() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

DisplaySettings displaySettings(const Scene& scene) {
    return {scene.display.exposureEv, scene.display.view};
}

}  // namespace

Renderer::Renderer(const Document& document, QObject* parent)
    : QObject(parent), document_(document) {
    session_ = std::make_unique<Session>(workerCount(), [this] {
        if (!eventPending_.exchange(true, std::memory_order_acq_rel))
            QMetaObject::invokeMethod(this, &Renderer::takeFrame, Qt::QueuedConnection);
    });
    connect(&document, &Document::changed, this, &Renderer::onDocumentChanged);
    connect(&document, &Document::replaced, this, [this] {
        isolated_.clear();
        compared_.reset();
        changeView();
    });
    connect(&document, &Document::titleChanged, this, [this] {
        if (document_.assetFolder() != assetFolder_) publishScene();
    });
    publishScene();
    publishView();
}

// The session goes first: its threads call back into this object.
Renderer::~Renderer() { session_.reset(); }

void Renderer::setSize(QSize size) {
    size = size.expandedTo({0, 0});
    if (size == this->size()) return;
    view_.width = size.width();
    view_.height = size.height();
    publishScene();
}

void Renderer::setPaused(bool paused) {
    if (paused_ == paused) return;
    paused_ = paused;
    publishView();
    emit pausedChanged(paused);
}

void Renderer::setThreads(int threads) {
    if (view_.threads == threads) return;
    view_.threads = threads;
    publishView();
}

void Renderer::setShown(bool shown) {
    if (shown_ == shown) return;
    shown_ = shown;
    publishView();
}

void Renderer::changeView() {
    publishView();
    emit viewChanged();
}

void Renderer::setChannel(Channel channel) {
    view_.paint.channel = channel;
    changeView();
}

void Renderer::setFiltered(bool filtered) {
    view_.paint.filtered = filtered;
    changeView();
}

void Renderer::setRegion(const std::optional<QRectF>& region) {
    region_ = region;
    changeView();
}

void Renderer::setIsolated(std::vector<ObjectId> objects) {
    isolated_ = std::move(objects);
    publishScene();
    emit viewChanged();
}

void Renderer::setCompared(std::optional<Scene> scene) {
    compared_ = std::move(scene);
    publishScene();
    emit viewChanged();
}

void Renderer::onDocumentChanged(const Scene& before) {
    const Scene& after = document_.scene();
    // A step that is made or taken back is what the eye has to be on; looking around is not one.
    if (compared_ && !(withViewCamera(before, after.viewCamera()) == after)) {
        compared_.reset();
        emit viewChanged();
    }
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
    Scene seen = withViewCamera(compared_ ? *compared_ : scene, camera);
    if (isIsolated())
        for (const ObjectId id : seen.objects.ids()) {
            if (std::find(isolated_.begin(), isolated_.end(), id) != isolated_.end()) continue;
            Object object = seen.objects.at(id);
            if (!object.visible) continue;
            object.visible = false;
            seen.objects.set(id, std::move(object));
        }
    view_.paint.display = displaySettings(scene);
    published_ = session_->publish(std::move(seen), assetFolder_, view_);
}

void Renderer::publishView() {
    view_.paint.display = displaySettings(document_.scene());
    view_.paused = paused_ || !shown_;
    view_.region.reset();
    if (region_) {
        const QRectF r(region_->x() * view_.width, region_->y() * view_.height,
                       region_->width() * view_.width, region_->height() * view_.height);
        const QRect pixels = r.toAlignedRect();
        view_.region = PixelRect{pixels.x(), pixels.y(), pixels.width(), pixels.height()};
    }
    session_->publish(view_);
}

void Renderer::probe(QPoint pixel, std::function<void(const Rgb&)> answer) {
    view_.paint.probe = {pixel.x(), pixel.y()};
    probeAnswer_ = std::move(answer);
    publishView();
}

void Renderer::answerProbe() {
    if (!probeAnswer_ || !frame_->probe || frame_->probe->pixel != view_.paint.probe) return;
    view_.paint.probe.reset();
    std::exchange(probeAnswer_, {})(frame_->probe->light);
}

void Renderer::takeFrame() {
    eventPending_.exchange(false, std::memory_order_acq_rel);
    if (const SessionFrame* frame = session_->take()) {
        frame_ = frame;
        emit frameReady();
        answerProbe();
    }
}

}  // namespace glint
