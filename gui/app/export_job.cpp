#include "gui/app/export_job.h"

#include <pthread.h>

#include "gui/app/document.h"
#include "gui/app/text.h"
#include "tracer/compile/compiler.h"
#include "tracer/io/scene_json.h"

namespace glint {

namespace {

/// The scene as it comes back from its file, whose ids have no gaps: the ids in a picture's layers
/// are those that `glint-render --verify` finds.
Scene asFromFile(const Scene& scene) {
    auto parsed = parseScene(formatScene(scene), "scene");
    return parsed.ok() ? std::move(parsed).value() : scene;
}

std::string joined(const std::vector<std::string>& names) {
    std::string out;
    for (const std::string& name : names) out += (out.empty() ? "" : ", ") + name;
    return out;
}

}  // namespace

ExportJob::ExportJob(ExportRequest request, QObject* parent)
    : QObject(parent), request_(std::move(request)) {
    thread_ = std::jthread([this] { run(); });
}

ExportJob::~ExportJob() { cancel(); }

void ExportJob::run() {
    pthread_setname_np(pthread_self(), "glint-export");
    // Emitting from this thread is safe: receivers live on the GUI thread and get queued events.
    const QString error = renderAll();
    emit finished(error, error.isEmpty() && stopped());
}

QString ExportJob::renderAll() {
    const Scene scene = asFromFile(request_.scene);
    for (int frame = 0; frame < frames() && !stopped(); ++frame) {
        const bool many = request_.turntable.has_value();
        const Scene shown =
            many ? withViewCamera(scene, cameraOf(*request_.turntable, scene.viewCamera(), frame))
                 : scene;
        const auto file = many ? numbered(request_.output, frame) : request_.output;
        if (const Status done = renderFrame(shown, frame, file); !done)
            return toQString(done.error());
    }
    return {};
}

Status ExportJob::renderFrame(const Scene& scene, int frame, const std::filesystem::path& file) {
    AssetCache assets;
    const auto compiled = compile(sceneFor(scene, request_.picture), request_.assetFolder, assets);
    if (!compiled.ok()) return compiled.error();
    RenderRequest request = requestFor(request_.picture);
    request.stop = &stop_;
    if (const auto problem = memoryProblem(*compiled.value().scene, request)) return *problem;
    request.pause = &pause_;
    request.progress = [&](const RenderProgress& p) {
        const double whole = p.fraction > 0 ? p.seconds / p.fraction : 0;
        emit progressed({(frame + p.fraction) / frames(),
                         p.remainingSeconds + whole * (frames() - frame - 1), p.error, p.spp, frame,
                         frames()});
    };
    const Rendering rendering = render(compiled.value().scene, request);
    if (stopped()) return Done{};
    return saveRendering(file, scene, rendering, request_.picture,
                         joined(featureNames(*compiled.value().scene)));
}

}  // namespace glint
