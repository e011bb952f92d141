// ExportJob: one picture rendered to a file on a thread of its own, with progress and cancel. The scene is a value, so editing
// goes on meanwhile.
#pragma once

#include <QObject>
#include <atomic>
#include <filesystem>
#include <thread>

#include "tracer/render/render.h"
#include "tracer/scene/scene.h"

namespace glint {

struct ExportRequest {
    Scene scene;  ///< with the size and stop rule to use
    std::filesystem::path assetFolder, output;
};

class ExportJob : public QObject {
    Q_OBJECT

  public:
    /// Starts at once.
    explicit ExportJob(ExportRequest request, QObject* parent = nullptr);
    /// Cancels and joins; the render looks at each path vertex, so that takes no time that a person notices.
    ~ExportJob() override;

    void cancel() { stop_.store(true, std::memory_order_relaxed); }
    [[nodiscard]] const std::filesystem::path& output() const { return request_.output; }

  signals:
    void progressed(double fraction, double remainingSeconds, int spp);
    /// `error` is empty when the file stands; `canceled` when nothing was written at the person's wish.
    void finished(const QString& error, bool canceled);

  private:
    void run();
    [[nodiscard]] QString renderToFile();

    ExportRequest request_;
    /// Set on the GUI thread, read by the render. Relaxed: it carries nothing but itself.
    std::atomic<bool> stop_{false};
    std::jthread thread_;
};

}  // namespace glint
