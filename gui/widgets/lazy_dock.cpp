#include "gui/widgets/lazy_dock.h"

#include <utility>

namespace glint {

LazyDock::LazyDock(const QString& title, Make make, QWidget* parent)
    : QDockWidget(title, parent), make_(std::move(make)) {
    connect(this, &QDockWidget::visibilityChanged, this, [this](bool seen) {
        seen_ = seen;
        // Queued: while docks are rearranged they pass through view. Still before the next paint.
        if (seen && !widget())
            QMetaObject::invokeMethod(this, &LazyDock::makeIfSeen, Qt::QueuedConnection);
    });
}

void LazyDock::makeIfSeen() {
    if (seen_) content();
}

QWidget* LazyDock::content() {
    if (!widget()) setWidget(make_(this));
    return widget();
}

}  // namespace glint
