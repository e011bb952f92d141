// SelectionOutline: keeps the line around the selection up to date in the background, for the
// picture that is shown.
#pragma once

#include <QFutureWatcher>
#include <QImage>
#include <QObject>
#include <optional>

#include "gui/viewport/silhouette.h"
#include "tracer/scene/scene.h"

namespace glint {

struct ViewContext;

class SelectionOutline : public QObject {
    Q_OBJECT

  public:
    explicit SelectionOutline(QObject* parent = nullptr);
    ~SelectionOutline() override;

    /// The line for the frame and selection there are now, as far as it is known: at most the time
    /// of one tracing behind. Null while nothing is selected. Asks for a newer one where needed.
    [[nodiscard]] const QImage& image(const ViewContext& context);

  signals:
    /// image() is newer.
    void ready();

  private:
    void start();
    void take();

    SilhouetteRequest shown_, wanted_, running_;
    Scene document_;  ///< as it was when `wanted_` was
    int thickness_ = 1;
    QImage image_;
    QFutureWatcher<QImage> watcher_;
};

}  // namespace glint
