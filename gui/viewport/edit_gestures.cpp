#include "gui/viewport/edit_gestures.h"

#include <QApplication>
#include <algorithm>

#include "gui/widgets/drag_number.h"
#include "gui/widgets/expression.h"

namespace glint {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(EditGestures)
};

QString nameOf(Tool tool) {
    switch (tool) {
        case Tool::Select:
            return Text::tr("Select");
        case Tool::Move:
            return Text::tr("Move");
        case Tool::Rotate:
            return Text::tr("Rotate");
        case Tool::Scale:
            return Text::tr("Scale");
    }
    return {};
}

QString amountOf(Tool tool, const GizmoChange& change) {
    if (tool == Tool::Rotate)
        return shortNumber(radiansToDegrees(change.angle)) + QStringLiteral("°");
    const DVec3& v = tool == Tool::Move ? change.translation : change.scale;
    const auto rounded = [](double x) { return QString::number(x, 'f', 3); };
    return QStringLiteral("%1, %2, %3%4")
        .arg(rounded(v.x), rounded(v.y), rounded(v.z), tool == Tool::Move ? " m" : "");
}

}  // namespace

GizmoGesture::GizmoGesture(ViewContext& context, Handle handle, const GizmoFrame& frame,
                           const QPointF& start)
    : Gesture(context),
      drag_(context.tools.tool, handle, frame, context.projection(), start),
      frame_(frame),
      base_(context.document.committed()),
      items_(context.movableItems()),
      text_(nameOf(context.tools.tool)),
      pointer_{start, {}} {}

GizmoGesture::GizmoGesture(ViewContext& context, const GizmoFrame& frame, const QPointF& start,
                           Scene base, const QString& text)
    : Gesture(context),
      drag_(Tool::Move, Handle::Free, frame, context.projection(), start),
      frame_(frame),
      base_(std::move(base)),
      items_(context.movableItems()),
      text_(text),
      pointer_{start, {}} {}

void GizmoGesture::move(const Pointer& pointer) {
    pointer_ = pointer;
    show();
}

GizmoChange GizmoGesture::change() const {
    if (!typed_.isEmpty())
        if (const auto number = evaluate(typed_, 0, {})) return drag_.typed(*number);
    const bool snap = context_.tools.snap != bool(pointer_.modifiers & Qt::ControlModifier);
    return drag_.change({pointer_.at, snap, bool(pointer_.modifiers & Qt::ShiftModifier)});
}

void GizmoGesture::show() {
    const GizmoChange now = change();
    Scene scene = base_;
    for (const Item item : items_) {
        const Affine world = worldFromItem(base_, item);
        const DVec3 pivot =
            context_.tools.pivot == Pivot::Individual ? world.translation : frame_.origin;
        const Affine step = toAffine(now, pivot, frame_.axes);
        if (!(step == Affine{})) scene = transformed(std::move(scene), item, step);
    }
    context_.document.preview(std::move(scene));
}

void GizmoGesture::finish(const Pointer&) { context_.document.commitPreview(text_); }

void GizmoGesture::cancel() { context_.document.cancelPreview(); }

bool GizmoGesture::keyPressed(const QKeyEvent& event) {
    const auto lock = [&](Handle handle) {
        drag_.setHandle(drag_.handle() == handle ? Handle::Free : handle);
    };
    const QString text = event.text();
    switch (event.key()) {
        case Qt::Key_X:
            lock(Handle::X);
            break;
        case Qt::Key_Y:
            lock(Handle::Y);
            break;
        case Qt::Key_Z:
            lock(Handle::Z);
            break;
        case Qt::Key_Backspace:
            typed_.chop(1);
            break;
        case Qt::Key_Control:
        case Qt::Key_Shift:
            break;
        default:
            if (text.size() != 1 || !QStringLiteral("0123456789.-").contains(text)) return false;
            typed_ += text;
    }
    pointer_.modifiers = event.modifiers();
    show();
    return true;
}

QString GizmoGesture::readout() const {
    const QString axis =
        QStringLiteral(" XYZ").mid(axisOf(drag_.handle()).value_or(-1) + 1, 1).trimmed();
    const QString amount =
        typed_.isEmpty() ? amountOf(drag_.tool(), change()) : typed_ + QStringLiteral("▏");
    return QStringLiteral("%1 %2 %3").arg(nameOf(drag_.tool()), axis, amount).simplified();
}

SelectGesture::SelectGesture(ViewContext& context, const Pointer& start)
    : Gesture(context), start_(start), last_(start.at) {}

bool SelectGesture::isBox() const {
    return (last_ - start_.at).manhattanLength() >= QApplication::startDragDistance();
}

void SelectGesture::move(const Pointer& pointer) { last_ = pointer.at; }

void SelectGesture::finish(const Pointer& pointer) {
    last_ = pointer.at;
    const bool extend = start_.modifiers & Qt::ShiftModifier;
    Selection& selection = context_.selection;
    if (!isBox()) {
        const auto item = context_.itemAt(start_.at);
        if (item && extend)
            selection.toggle(*item);
        else if (item)
            selection.set({*item});
        else if (!extend)
            selection.clear();
        return;
    }
    std::vector<Item> items = extend ? selection.items() : std::vector<Item>();
    for (const Item item : context_.itemsWithin(box()))
        if (std::find(items.begin(), items.end(), item) == items.end()) items.push_back(item);
    selection.set(std::move(items));
}

void SelectGesture::paint(QPainter& painter) const {
    if (!isBox()) return;
    painter.setPen(QPen(QColor(255, 196, 96), 1, Qt::DashLine));
    painter.setBrush(QColor(255, 196, 96, 30));
    painter.drawRect(box());
}

}  // namespace glint
