#include "gui/app/narrow_layout.h"

#include <QDockWidget>
#include <QEvent>
#include <QMainWindow>
#include <algorithm>
#include <utility>

namespace glint {

namespace {

/// Characters across below which a window is narrow: two columns of docks would take more than two
/// thirds of it.
constexpr int kNarrow = 150;

}  // namespace

NarrowLayout::NarrowLayout(QMainWindow& window, QObject* parent)
    : QObject(parent), window_(window) {
    window.installEventFilter(this);
    // Made anew with its docks, as for another language.
    if (window.isVisible())
        QMetaObject::invokeMethod(this, &NarrowLayout::follow, Qt::QueuedConnection);
}

QByteArray NarrowLayout::wideState() const { return isNarrow() ? wide_ : window_.saveState(); }

bool NarrowLayout::eventFilter(QObject*, QEvent* event) {
    // Queued: docks must not move while the window lays them out.
    if (event->type() == QEvent::Resize)
        QMetaObject::invokeMethod(this, &NarrowLayout::follow, Qt::QueuedConnection);
    return false;
}

void NarrowLayout::follow() {
    const bool narrow = window_.width() < kNarrow * window_.fontMetrics().averageCharWidth();
    if (narrow == isNarrow()) return;
    if (!narrow) {
        window_.restoreState(std::exchange(wide_, {}));
        return;
    }
    wide_ = window_.saveState();
    const auto docks = window_.findChildren<QDockWidget*>(Qt::FindDirectChildrenOnly);
    const auto isOn = [this](Qt::DockWidgetArea area) {
        return [this, area](const QDockWidget* dock) {
            return !dock->isFloating() && !dock->isHidden() &&
                   window_.dockWidgetArea(const_cast<QDockWidget*>(dock)) == area;
        };
    };
    const auto right = std::find_if(docks.begin(), docks.end(), isOn(Qt::RightDockWidgetArea));
    if (right == docks.end()) return;
    const auto isLeft = isOn(Qt::LeftDockWidgetArea);
    for (QDockWidget* dock : docks)
        if (isLeft(dock)) window_.tabifyDockWidget(*right, dock);
    (*right)->raise();
}

}  // namespace glint
