#include "gui/app/preview_renderer.h"

#include <pthread.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <utility>

#include "tracer/color/display.h"
#include "tracer/compile/compiler.h"
#include "tracer/render/render.h"

namespace glint {

namespace {

constexpr int kMostPictures = 1024;
constexpr int kDraftSpp = 4;
constexpr int kNiceness =
    5;  ///< as the render that the person looks at: lower, it would starve behind it

QImage trace(Scene scene, int spp, const std::filesystem::path& folder, AssetCache& assets,
             const std::atomic<bool>& stop) {
    scene.render.spp = spp;
    scene.render.timeSeconds = scene.render.errorPercent = 0;
    const auto compiled = compile(scene, folder, assets);
    if (!compiled.ok()) return {};
    RenderRequest request;
    request.threads = 1;
    request.stop = &stop;
    request.filter = true;  // A few samples must do for a small picture.
    const Rendering rendering = render(compiled.value().scene, request);
    return stop.load(std::memory_order_relaxed) ? QImage()
                                                : screenPicture(rendering.filtered, scene.display);
}

}  // namespace

QImage screenPicture(const Image& image, const Display& display) {
    const DisplayTransform transform({display.exposureEv, display.view});
    QImage out(image.width, image.height, QImage::Format_RGB32);
    const float* pixel = image.rgb.data();
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x, pixel += 3)
            out.setPixel(x, y, transform.apply({pixel[0], pixel[1], pixel[2]}));
    return out;
}

PreviewRenderer::PreviewRenderer(QObject* parent) : QObject(parent) {
    thread_ = std::jthread([this](const std::stop_token& end) { work(end); });
}

PreviewRenderer::~PreviewRenderer() {
    if (running_) running_->stop.store(true, std::memory_order_relaxed);
    thread_.request_stop();
    wake_.fetch_add(1, std::memory_order_release);
    wake_.notify_one();
}

void PreviewRenderer::request(PreviewJob job) {
    if (pictures_.contains(job.key) || (running_ && running_->job.key == job.key &&
                                        !running_->stop.load(std::memory_order_relaxed)))
        return;
    std::erase_if(waiting_, [&](const PreviewJob& other) {
        return other.slot == job.slot || other.key == job.key;
    });
    if (running_ && running_->job.slot == job.slot)
        running_->stop.store(true, std::memory_order_relaxed);
    waiting_.push_back(std::move(job));
    if (!running_ && !held_) startNext();
}

void PreviewRenderer::release() {
    if (!std::exchange(held_, false)) return;
    if (!running_) startNext();
    emit released();
}

void PreviewRenderer::startNext() {
    running_.reset();
    if (waiting_.empty()) return;
    // Every place gets its draft, the newest first, before any gets its finished picture, the
    // oldest first.
    const auto draft = std::find_if(waiting_.rbegin(), waiting_.rend(),
                                    [](const PreviewJob& job) { return !job.drafted; });
    const auto next = draft == waiting_.rend() ? waiting_.begin() : std::prev(draft.base());
    running_ = std::make_shared<Running>();
    running_->job = std::move(*next);
    waiting_.erase(next);
    inbox_.push(running_);
    wake_.fetch_add(1, std::memory_order_release);
    wake_.notify_one();
}

void PreviewRenderer::keep(const QString& key, const QImage& picture) {
    if (!pictures_.contains(key)) order_ << key;
    pictures_[key] = picture;
    while (order_.size() > kMostPictures) pictures_.remove(order_.takeFirst());
}

void PreviewRenderer::finish(const std::shared_ptr<Running>& done, const QImage& picture) {
    PreviewJob job = std::move(done->job);
    const QString key = job.key;
    const bool finished = job.drafted, stopped = done->stop.load(std::memory_order_relaxed);
    if (!finished && !stopped) {
        job.drafted = true;
        waiting_.push_back(std::move(job));
    }
    startNext();
    if (picture.isNull()) return;
    if (finished) keep(key, picture);
    emit ready(key, picture);
}

void PreviewRenderer::work(const std::stop_token& end) {
    pthread_setname_np(pthread_self(), "glint-preview");
    setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), kNiceness);
    AssetCache assets;
    for (int seen = 0; !end.stop_requested();) {
        wake_.wait(seen, std::memory_order_acquire);
        seen = wake_.load(std::memory_order_acquire);
        for (const std::shared_ptr<Running>& next : inbox_.takeAll()) {
            const PreviewJob& job = next->job;
            const int spp =
                job.drafted ? job.scene.render.spp : std::min(kDraftSpp, job.scene.render.spp);
            const QImage picture = trace(job.scene, spp, job.assetFolder, assets, next->stop);
            QMetaObject::invokeMethod(
                this, [this, next, picture] { finish(next, picture); }, Qt::QueuedConnection);
        }
    }
}

}  // namespace glint
