// MaterialDrop: lets a dragged material fall onto the object under the pointer; while it hovers,
// the picture shows it there.
#pragma once

#include <QObject>
#include <optional>

#include "tracer/scene/ids.h"

class QDropEvent;

namespace glint {

class RenderView;

class MaterialDrop : public QObject {
    Q_OBJECT

  public:
    /// Watches the drags over `view`, as its child.
    explicit MaterialDrop(RenderView& view);

    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void hover(const QPointF& at, MaterialId material);
    void drop(const QPointF& at, MaterialId material);
    void leave();
    [[nodiscard]] std::optional<ObjectId> objectAt(const QPointF& at) const;

    RenderView& view_;
    std::optional<ObjectId> shown_;  ///< the object that shows the material for now
};

}  // namespace glint
