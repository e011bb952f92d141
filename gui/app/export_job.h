// ExportJob: pictures rendered to files on a thread of its own, with progress, pause and cancel.
// The scene is a value, so editing goes on meanwhile.
#pragma once

#include <QObject>
#include <atomic>
#include <filesystem>
#include <optional>
#include <thread>

#include "gui/app/turntable.h"
#include "tracer/io/rendering_file.h"
#include "tracer/scene/scene.h"

namespace glint {

struct ExportRequest {
    Scene scene;  ///< with the size and stop rule to use
    std::filesystem::path assetFolder, output;
    PictureOptions picture;
    std::optional<Turntable> turntable;  ///< then `output` gets a number for each frame
};

struct ExportProgress {
    double fraction = 0;  ///< of the whole job, 0 to 1
    double remainingSeconds = 0;
    double error = kInfinity;  ///< of the present picture, see pictureError(); infinite at first
    int spp = 0;
    int frame = 0, frames = 1;  ///< frame counts from 0
};

class ExportJob : public QObject {
    Q_OBJECT

  public:
    /// Starts at once.
    explicit ExportJob(ExportRequest request, QObject* parent = nullptr);
    /// Cancels and joins; the render looks at each path vertex, so that takes no time that a person
    /// notices.
    ~ExportJob() override;

    void cancel() { stop_.store(true, std::memory_order_relaxed); }
    /// Keeps the samples and uses no processor from the end of the pass that runs.
    void setPaused(bool paused) { pause_.store(paused, std::memory_order_relaxed); }

  signals:
    void progressed(const glint::ExportProgress& progress);
    /// `error` is empty when the files stand; `canceled` when the work ended at the person's wish.
    void finished(const QString& error, bool canceled);

  private:
    void run();
    [[nodiscard]] QString renderAll();
    [[nodiscard]] Status renderFrame(const Scene& scene, int frame,
                                     const std::filesystem::path& file);
    [[nodiscard]] int frames() const { return request_.turntable ? request_.turntable->frames : 1; }
    [[nodiscard]] bool stopped() const { return stop_.load(std::memory_order_relaxed); }

    ExportRequest request_;
    /// Set on the GUI thread, read by the render. Relaxed: they carry nothing but themselves.
    std::atomic<bool> stop_{false}, pause_{false};
    std::jthread thread_;
};

}  // namespace glint
