// RenderView: the picture. Paints the newest frame and the overlay, and turns pointer and keys into
// gestures. What a gesture does is in navigation_gestures.h and edit_gestures.h; menu commands of
// the view are in view_commands.h.
#pragma once

#include <QTimer>
#include <QWidget>
#include <memory>

#include "gui/viewport/gesture.h"
#include "gui/widgets/eyedropper.h"

class QAction;

namespace glint {

class SelectionOutline;

class RenderView : public QWidget, public PictureSource {
    Q_OBJECT

  public:
    RenderView(Document& document, Selection& selection, Renderer& renderer,
               QWidget* parent = nullptr);
    ~RenderView() override;

    [[nodiscard]] ViewContext& context() { return context_; }
    [[nodiscard]] SelectionOutline& outline() { return *outline_; }
    [[nodiscard]] const ToolOptions& tools() const { return context_.tools; }
    void setTools(const ToolOptions& tools);
    void setOverlayShown(bool shown);
    void setGridShown(bool shown);
    [[nodiscard]] bool isOverlayShown() const { return overlayShown_; }
    [[nodiscard]] bool isGridShown() const { return gridShown_; }
    /// The pixel of the picture under a place in the view.
    [[nodiscard]] QPoint pixelAt(const QPointF& at) const;
    /// Where the pointer is, or the middle of the view if it is elsewhere.
    [[nodiscard]] QPointF pointerOrCenter() const;
    /// Lets the selected items of `base` follow the pointer until a click.
    void beginFollow(Scene base, const QString& text);
    /// Asks for the pixel at this place to be explained.
    void inspect(const QPointF& at) { emit inspectRequested(pixelAt(at)); }
    /// The next drag marks the region that is rendered.
    void beginRegion();
    /// Ends what the pointer is doing and takes it back; false if it does nothing.
    bool cancelGesture();
    [[nodiscard]] bool isGesturing() const { return gesture_ != nullptr; }
    bool tellColor(const QPoint& global, std::function<void(const Color&)> tell) override;
    [[nodiscard]] QSize sizeHint() const override { return {960, 540}; }

  signals:
    void toolsChanged(const glint::ToolOptions& tools);
    /// A right click without a drag.
    void menuRequested(const QPoint& globalAt);
    /// A pixel of the picture is to be explained.
    void inspectRequested(const QPoint& pixel);
    /// One line about the running gesture; empty when it ends.
    void readoutChanged(const QString& text);
    /// A frame has been painted.
    void pictureShown();
    /// The pointer is over this pixel of the picture; (-1, -1) when it has left.
    void pixelHovered(const QPoint& pixel);

  protected:
    bool event(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

  private:
    /// The window's action that has this key of the keypad; none for other keys.
    [[nodiscard]] QAction* keypadAction(const QKeyEvent& event) const;
    [[nodiscard]] std::unique_ptr<Gesture> gestureFor(const QMouseEvent& event);
    void endGesture(const Pointer& pointer);
    void updateHover(const QPointF& at);
    void updateSize();
    void focusAt(const QPointF& at);
    void paintPicture(QPainter& painter) const;
    /// Where the frame's pixels are drawn.
    [[nodiscard]] QRectF pictureRect() const;
    void paintOverlay(QPainter& painter) const;
    void paintHints(QPainter& painter) const;
    [[nodiscard]] QString hint() const;
    void watchWindow();

    ViewContext context_;
    SelectionOutline* outline_;
    std::unique_ptr<Gesture> gesture_;
    Qt::MouseButton gestureButton_ = Qt::NoButton;  ///< NoButton: follows until a click
    QPointF pressedAt_;
    Handle hovered_ = Handle::None;
    bool regionComes_ = false;  ///< the next drag is a region
    bool overlayShown_ = true, gridShown_ = false;
    QTimer wheelTimer_;  ///< runs while wheel steps count as one move of the view
};

}  // namespace glint
