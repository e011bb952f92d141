// TileList: pictures with names in rows as wide as there is room, all of them shown: it is as high
// as its rows, and what is around it scrolls.
#pragma once

#include <QListWidget>

namespace glint {

class TileList : public QListWidget {
    Q_OBJECT

  public:
    /// Tiles with pictures of `picture` logical pixels over one line of text.
    explicit TileList(const QSize& picture, QWidget* parent = nullptr);

  protected:
    void resizeEvent(QResizeEvent* event) override;
    /// The wheel is for what is around it.
    void wheelEvent(QWheelEvent* event) override;
};

}  // namespace glint
