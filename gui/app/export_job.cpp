#include "gui/app/export_job.h"

#include <pthread.h>

#include "gui/app/text.h"
#include "tracer/compile/compiler.h"
#include "tracer/io/rendering_file.h"

namespace glint {

ExportJob::ExportJob(ExportRequest request, QObject* parent) : QObject(parent), request_(std::move(request)) {
    thread_ = std::jthread([this] { run(); });
}

ExportJob::~ExportJob() { cancel(); }

void ExportJob::run() {
    pthread_setname_np(pthread_self(), "glint-export");
    // Emitting from this thread is safe: receivers live on the GUI thread and get queued events.
    const QString error = renderToFile();
    emit finished(error, error.isEmpty() && stop_.load(std::memory_order_relaxed));
}

QString ExportJob::renderToFile() {
    AssetCache assets;
    const auto compiled = compile(request_.scene, request_.assetFolder, assets);
    if (!compiled.ok()) return toQString(compiled.error());
    RenderRequest request;
    request.stop = &stop_;
    request.progress = [this](const RenderProgress& p) { emit progressed(p.fraction, p.remainingSeconds, p.spp); };
    const Rendering rendering = render(compiled.value().scene, request);
    if (stop_.load(std::memory_order_relaxed)) return {};
    const Status saved = saveRendering(request_.output, request_.scene, rendering);
    return saved.ok() ? QString() : toQString(saved.error());
}

}  // namespace glint
