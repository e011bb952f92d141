#include "gui/viewport/render_view.h"

#include <QAction>
#include <QApplication>
#include <QWheelEvent>
#include <QWindow>
#include <algorithm>
#include <cmath>

#include "gui/viewport/edit_gestures.h"
#include "gui/viewport/legend.h"
#include "gui/viewport/navigation.h"
#include "gui/viewport/navigation_gestures.h"
#include "gui/viewport/overlay.h"
#include "gui/viewport/region_gesture.h"
#include "gui/viewport/selection_outline.h"
#include "tracer/color/display.h"

namespace glint {

namespace {

constexpr int kWheelPauseMs = 400;

Pointer pointerOf(const QMouseEvent& event) { return {event.position(), event.modifiers()}; }

}  // namespace

RenderView::RenderView(Document& document, Selection& selection, Renderer& renderer,
                       QWidget* parent)
    : QWidget(parent),
      context_{document, selection, renderer, *this, {}, {}},
      outline_(new SelectionOutline(this)) {
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setMinimumSize(fontMetrics().averageCharWidth() * 24, fontMetrics().height() * 8);
    wheelTimer_.setSingleShot(true);
    wheelTimer_.setInterval(kWheelPauseMs);
    const auto repaint = qOverload<>(&QWidget::update);
    connect(&renderer, &Renderer::frameReady, this, repaint);
    connect(outline_, &SelectionOutline::ready, this, repaint);
    connect(&renderer, &Renderer::pausedChanged, this, repaint);
    connect(&renderer, &Renderer::viewChanged, this, repaint);
    connect(&document, &Document::changed, this, repaint);
    connect(&selection, &Selection::changed, this, repaint);
    connect(&document, &Document::replaced, this, [this] {
        gesture_.reset();
        context_.history.clear();
    });
}

RenderView::~RenderView() = default;

void RenderView::setTools(const ToolOptions& tools) {
    if (tools == context_.tools) return;
    context_.tools = tools;
    hovered_ = Handle::None;
    update();
    emit toolsChanged(tools);
}

void RenderView::setOverlayShown(bool shown) {
    overlayShown_ = shown;
    update();
}

void RenderView::setGridShown(bool shown) {
    gridShown_ = shown;
    update();
}

QPointF RenderView::pointerOrCenter() const {
    const QPointF at = mapFromGlobal(QCursor::pos());
    return rect().contains(at.toPoint()) ? at : QRectF(rect()).center();
}

bool RenderView::tellColor(const QPoint& global, std::function<void(const Color&)> tell) {
    const SessionFrame* frame = context_.renderer.frame();
    const QPointF at = mapFromGlobal(QPointF(global));
    const QRectF picture = frame && frame->width > 0 ? pictureRect() : QRectF();
    if (!picture.contains(at)) return false;
    const auto pixel = [](double share, int count) {
        return std::clamp(static_cast<int>(share * count), 0, count - 1);
    };
    context_.renderer.probe({pixel((at.x() - picture.x()) / picture.width(), frame->width),
                             pixel((at.y() - picture.y()) / picture.height(), frame->height)},
                            [tell = std::move(tell)](const Rgb& light) {
                                tell({light.x, light.y, light.z});
                            });
    return true;
}

void RenderView::beginFollow(Scene base, const QString& text) {
    GizmoFrame frame;
    for (const Item item : context_.movableItems())
        frame.origin = worldFromItem(base, item).translation;
    gesture_ =
        std::make_unique<GizmoGesture>(context_, frame, pointerOrCenter(), std::move(base), text);
    gestureButton_ = Qt::NoButton;
    setFocus();
}

void RenderView::beginRegion() {
    regionComes_ = true;
    setCursor(Qt::CrossCursor);
    setFocus();
    update();
}

bool RenderView::cancelGesture() {
    if (regionComes_) {
        regionComes_ = false;
        unsetCursor();
        update();
        return true;
    }
    if (!gesture_) return false;
    const auto gesture = std::move(gesture_);
    gesture->cancel();
    emit readoutChanged({});
    update();
    return true;
}

std::unique_ptr<Gesture> RenderView::gestureFor(const QMouseEvent& event) {
    const QPointF at = event.position();
    const bool alt = event.modifiers() & Qt::AltModifier,
               shift = event.modifiers() & Qt::ShiftModifier;
    switch (event.button()) {
        case Qt::MiddleButton:
            if (shift || alt) return std::make_unique<PanGesture>(context_, at);
            return std::make_unique<OrbitGesture>(context_, at);
        case Qt::RightButton:
            if (alt) return std::make_unique<DollyGesture>(context_, at);
            if (shift) return std::make_unique<EnvironmentGesture>(context_, at);
            return std::make_unique<FlyGesture>(context_, at);
        case Qt::LeftButton: {
            if (regionComes_) {
                regionComes_ = false;
                unsetCursor();
                return std::make_unique<RegionGesture>(context_, at);
            }
            if (alt) return std::make_unique<OrbitGesture>(context_, at);
            updateHover(at);
            const auto frame = context_.gizmoFrame();
            if (frame && overlayShown_ && hovered_ != Handle::None)
                return std::make_unique<GizmoGesture>(context_, hovered_, *frame, at);
            if (event.modifiers() & Qt::ControlModifier) {
                focusAt(at);
                return nullptr;
            }
            return std::make_unique<SelectGesture>(context_, pointerOf(event));
        }
        default:
            return nullptr;
    }
}

void RenderView::focusAt(const QPointF& at) {
    const auto surface = context_.surfaceAt(at);
    if (!surface) return;
    Scene scene = context_.document.committed();
    Camera camera = scene.viewCamera();
    camera.focusDistance = context_.projection().depth(surface->position);
    context_.document.edit(withViewCamera(std::move(scene), camera), tr("Focus"));
}

void RenderView::mousePressEvent(QMouseEvent* event) {
    if (gesture_) {
        // A second button takes a drag back; a click ends what follows the pointer.
        if (gestureButton_ == Qt::NoButton && event->button() == Qt::LeftButton)
            endGesture(pointerOf(*event));
        else
            cancelGesture();
        return;
    }
    wheelTimer_.stop();
    pressedAt_ = event->position();
    gesture_ = gestureFor(*event);
    gestureButton_ = event->button();
    update();
}

QPoint RenderView::pixelAt(const QPointF& at) const {
    const QPointF pixel = at * devicePixelRatioF();
    return {static_cast<int>(std::floor(pixel.x())), static_cast<int>(std::floor(pixel.y()))};
}

void RenderView::mouseMoveEvent(QMouseEvent* event) {
    emit pixelHovered(pixelAt(event->position()));
    if (!gesture_) return updateHover(event->position());
    gesture_->move(pointerOf(*event));
    emit readoutChanged(gesture_->readout());
    update();
}

void RenderView::mouseReleaseEvent(QMouseEvent* event) {
    if (!gesture_ || event->button() != gestureButton_) return;
    const auto* fly = dynamic_cast<FlyGesture*>(gesture_.get());
    const bool click = fly && fly->isClick();
    // Alt and a click that turned nothing asks about the pixel.
    const bool asks = event->button() == Qt::LeftButton && event->modifiers() & Qt::AltModifier &&
                      event->position() == pressedAt_;
    endGesture(pointerOf(*event));
    if (click) emit menuRequested(event->globalPosition().toPoint());
    if (asks) inspect(event->position());
}

void RenderView::endGesture(const Pointer& pointer) {
    const auto gesture = std::move(gesture_);
    gesture->finish(pointer);
    emit readoutChanged({});
    updateHover(pointer.at);
    update();
}

void RenderView::updateHover(const QPointF& at) {
    const auto frame = context_.gizmoFrame();
    const Handle handle =
        frame ? handleAt(context_.projection(), *frame, context_.tools.tool, at) : Handle::None;
    if (handle == hovered_) return;
    hovered_ = handle;
    update();
}

void RenderView::wheelEvent(QWheelEvent* event) {
    const double steps =
        event->angleDelta().y() / (context_.navigation.invertWheel ? -120.0 : 120.0);
    if (steps == 0) return event->ignore();
    if (gesture_) {
        if (gesture_->wheel(steps)) emit readoutChanged(gesture_->readout());
        return;
    }
    const Camera camera = context_.document.scene().viewCamera();
    if (!wheelTimer_.isActive()) context_.history.leave(camera);
    wheelTimer_.start();
    context_.document.navigate(
        dollied(camera, focusPoint(context_, event->position()), std::pow(0.85, steps)));
}

bool RenderView::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride &&
        (gesture_ || (regionComes_ && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape))) {
        // While something is dragged the keys are its own: W moves forward and does not choose a
        // tool.
        event->accept();
        return true;
    }
    if (event->type() == QEvent::ShortcutOverride &&
        keypadAction(*static_cast<QKeyEvent*>(event))) {
        event->accept();
        return true;
    }
    if (event->type() == QEvent::ScreenChangeInternal) updateSize();
    return QWidget::event(event);
}

// A window out of sight needs no picture: minimised, or shown to nobody.
void RenderView::watchWindow() {
    if (QWindow* handle = window()->windowHandle()) handle->installEventFilter(this);
}

bool RenderView::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Expose)
        if (const auto* handle = qobject_cast<QWindow*>(watched))
            context_.renderer.setShown(isVisible() && handle->isExposed());
    return QWidget::eventFilter(watched, event);
}

void RenderView::showEvent(QShowEvent* event) {
    watchWindow();
    context_.renderer.setShown(true);
    QWidget::showEvent(event);
}

void RenderView::hideEvent(QHideEvent* event) {
    context_.renderer.setShown(false);
    QWidget::hideEvent(event);
}

// Under X11 Qt takes a digit of the keypad for one of the row above the letters if that has an
// action, too.
QAction* RenderView::keypadAction(const QKeyEvent& event) const {
    if (gesture_ || !(event.modifiers() & Qt::KeypadModifier)) return nullptr;
    for (QAction* action : window()->actions())
        if (action->isEnabled() &&
            action->shortcuts().contains(QKeySequence(event.keyCombination())))
            return action;
    return nullptr;
}

void RenderView::keyPressEvent(QKeyEvent* event) {
    if (QAction* action = keypadAction(*event)) return action->trigger();
    if (regionComes_ && event->key() == Qt::Key_Escape) {
        cancelGesture();
        return;
    }
    if (!gesture_) return QWidget::keyPressEvent(event);
    if (event->key() == Qt::Key_Escape) {
        cancelGesture();
    } else if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
        endGesture({mapFromGlobal(QCursor::pos()), event->modifiers()});
    } else if (gesture_->keyPressed(*event)) {
        emit readoutChanged(gesture_->readout());
        update();
    }
}

void RenderView::keyReleaseEvent(QKeyEvent* event) {
    if (gesture_ && !event->isAutoRepeat()) gesture_->keyReleased(*event);
    QWidget::keyReleaseEvent(event);
}

void RenderView::leaveEvent(QEvent* event) {
    if (!gesture_) hovered_ = Handle::None;
    emit pixelHovered({-1, -1});
    update();
    QWidget::leaveEvent(event);
}

// Keys released elsewhere would keep a flight going.
void RenderView::focusOutEvent(QFocusEvent* event) {
    if (gesture_ && event->reason() != Qt::PopupFocusReason) endGesture({pointerOrCenter(), {}});
    QWidget::focusOutEvent(event);
}

void RenderView::resizeEvent(QResizeEvent*) { updateSize(); }

void RenderView::updateSize() { context_.renderer.setSize(size() * devicePixelRatioF()); }

void RenderView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const SessionFrame* shown = context_.renderer.frame();
    if (!shown || !pictureRect().contains(rect())) painter.fillRect(rect(), QColor(24, 24, 24));
    paintPicture(painter);
    painter.setRenderHint(QPainter::Antialiasing);
    if (overlayShown_) paintOverlay(painter);
    if (const auto& region = context_.renderer.region()) paintRegion(painter, *region, rect());
    if (const SessionFrame* frame = context_.renderer.frame();
        frame && frame->channel != Channel::Beauty)
        paintLegend(painter, *frame, rect());
    if (gesture_) gesture_->paint(painter);
    paintHints(painter);
    if (shown) emit pictureShown();
}

void RenderView::paintPicture(QPainter& painter) const {
    const SessionFrame* frame = context_.renderer.frame();
    if (!frame || frame->width <= 0 || frame->height <= 0) return;
    const QImage image(reinterpret_cast<const uchar*>(frame->pixels.data()), frame->width,
                       frame->height, frame->width * 4, QImage::Format_RGB32);
    const QRectF target = pictureRect();
    painter.setRenderHint(QPainter::SmoothPixmapTransform, target != QRectF(rect()));
    painter.drawImage(target, image);
}

QRectF RenderView::pictureRect() const {
    const SessionFrame* frame = context_.renderer.frame();
    if (QSize(frame->width, frame->height) == size() * devicePixelRatioF()) return rect();
    // Until the first frame of a new size comes, the old one is shown with the same height: the
    // field of view is vertical.
    const double wide = static_cast<double>(height()) * frame->width / frame->height;
    return {(width() - wide) / 2, 0, wide, static_cast<double>(height())};
}

void RenderView::paintOverlay(QPainter& painter) const {
    const Scene& scene = context_.document.scene();
    const ViewProjection view = context_.projection();
    const std::vector<Item>& selected = context_.selection.items();
    if (gridShown_) paintGrid(painter, view, scene.viewCamera().target);
    paintSafeFrame(painter, scene.film, view);
    if (const QImage& outline = outline_->image(context_); !outline.isNull())
        painter.drawImage(pictureRect(), outline);
    paintGlyphs(painter, scene, selected, view);
    paintAxesCorner(painter, view);
    if (const auto* drag = dynamic_cast<const GizmoGesture*>(gesture_.get())) {
        if (const auto frame = context_.gizmoFrame())
            paintGizmo(painter, view, *frame, drag->drag().tool(), drag->drag().handle());
    } else if (const auto frame = context_.gizmoFrame()) {
        paintGizmo(painter, view, *frame, context_.tools.tool, hovered_);
    }
}

QString RenderView::hint() const {
    if (gesture_) return gesture_->readout();
    const Renderer& renderer = context_.renderer;
    if (regionComes_) return tr("Drag the region that is to be rendered (Esc: not now)");
    QStringList parts;
    if (renderer.isPaused()) parts << tr("Paused (Space)");
    if (renderer.isComparing()) parts << tr("Before the last step (B comes back)");
    if (renderer.isIsolated()) parts << tr("Only some objects are rendered (/ shows all)");
    if (renderer.isFiltered() && renderer.channel() == Channel::Beauty) parts << tr("Filtered");
    if (!parts.isEmpty()) return parts.join(QStringLiteral("  ·  "));
    if (!renderer.frame()) return tr("Preparing the picture…");
    if (context_.document.scene().objects.empty())
        return tr(
            "This scene is empty. Shift+A adds an object; drop a scene or an environment picture "
            "here.");
    return {};
}

void RenderView::paintHints(QPainter& painter) const {
    const QString text = hint();
    if (text.isEmpty()) return;
    QRectF box = QRectF(fontMetrics().boundingRect(rect().adjusted(20, 0, -20, 0),
                                                   Qt::AlignCenter | Qt::TextWordWrap, text))
                     .adjusted(-10, -5, 10, 5);
    box.moveTop(10);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(0, 0, 0, 160));
    painter.drawRoundedRect(box, 4, 4);
    painter.setPen(QColor(235, 235, 235));
    painter.drawText(box, Qt::AlignCenter | Qt::TextWordWrap, text);
}

}  // namespace glint
