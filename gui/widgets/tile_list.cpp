#include "gui/widgets/tile_list.h"

#include <QWheelEvent>
#include <algorithm>

namespace glint {

TileList::TileList(const QSize& picture, QWidget* parent) : QListWidget(parent) {
    setFrameShape(QFrame::NoFrame);
    setViewMode(QListView::IconMode);
    setFlow(QListView::LeftToRight);
    setResizeMode(QListView::Adjust);
    setMovement(QListView::Static);
    setIconSize(picture);
    setGridSize(picture + QSize(14, fontMetrics().height() + 14));
    setTextElideMode(Qt::ElideMiddle);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    viewport()->setAutoFillBackground(false);
}

void TileList::resizeEvent(QResizeEvent* event) {
    QListWidget::resizeEvent(event);
    const int columns = std::max(1, viewport()->width() / gridSize().width());
    setFixedHeight((count() + columns - 1) / columns * gridSize().height() + 2);
}

void TileList::wheelEvent(QWheelEvent* event) { event->ignore(); }

}  // namespace glint
