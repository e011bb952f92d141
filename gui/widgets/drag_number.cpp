#include "gui/widgets/drag_number.h"

#include <QApplication>
#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QStyle>
#include <QToolTip>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "gui/widgets/expression.h"

namespace glint {

QString shortNumber(double value, int digits) {
    return QString::number(value == 0 ? 0.0 : value, 'g', digits);
}

QString shownUnit(const QString& unit) {
    if (unit == "deg") return QStringLiteral("°");
    QString out = unit;
    return out.replace("m2", QStringLiteral("m²"));
}

bool NumberRange::contains(double value) const {
    return (exclusiveMin ? value > min : value >= min) && value <= max &&
           (!integer || value == std::floor(value));
}

QString NumberRange::text() const {
    const bool low = std::isfinite(min), high = std::isfinite(max);
    QString out = integer ? DragNumber::tr("a whole number") : DragNumber::tr("a number");
    if (low && exclusiveMin)
        out += DragNumber::tr(" above %1").arg(shortNumber(min));
    else if (low)
        out += DragNumber::tr(" from %1").arg(shortNumber(min));
    if (high) out += DragNumber::tr(" up to %1").arg(shortNumber(max));
    return out;
}

DragNumber::DragNumber(QWidget* parent) : QLineEdit(parent) {
    setReadOnly(true);
    setCursor(Qt::SizeHorCursor);
    setAlignment(Qt::AlignRight);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setRefused(false);
}

void DragNumber::setUnit(const QString& unit) {
    unit_ = unit;
    showValue();
}

void DragNumber::setValue(double value) {
    value_ = value;
    if (state_ == State::Typing) return;
    clearRefusal();
    showValue();
}

void DragNumber::setMixed() {
    value_.reset();
    if (state_ != State::Typing) showValue();
}

void DragNumber::showValue() {
    if (!value_) {
        setText(QStringLiteral("—"));
        return;
    }
    const QString unit = shownUnit(unit_);
    const bool tight = unit == QStringLiteral("°") || unit == "%";
    const QString behind = unit.isEmpty() ? QString() : tight ? unit : " " + unit;
    // Fewer digits rather than a number that is cut: the whole one is there to type.
    constexpr int kMargin = 6, kFewestDigits = 3;
    QString text = shortNumber(*value_) + behind;
    for (int digits = kShownDigits - 1; digits >= kFewestDigits && isVisible() && !range_.integer;
         --digits) {
        if (fontMetrics().horizontalAdvance(text) + kMargin <= width()) break;
        text = shortNumber(*value_, digits) + behind;
    }
    setText(text);
    setCursorPosition(0);
}

void DragNumber::resizeEvent(QResizeEvent* event) {
    QLineEdit::resizeEvent(event);
    if (state_ != State::Typing && !isRefused()) showValue();
}

QSize DragNumber::minimumSizeHint() const {
    return {fontMetrics().horizontalAdvance("0.00") + 10, QLineEdit::minimumSizeHint().height()};
}

QSize DragNumber::sizeHint() const {
    return {fontMetrics().horizontalAdvance("-000.000 m") + 12, QLineEdit::sizeHint().height()};
}

double DragNumber::stepAt(double value) const {
    if (range_.integer) return std::max(0.2, std::abs(value) * 0.01);
    if (std::isfinite(range_.min) && std::isfinite(range_.max) && range_.max - range_.min <= 10)
        return (range_.max - range_.min) / 200;
    if (unit_ == "deg") return 0.5;
    return std::max(0.01, std::abs(value) * 0.01);
}

double DragNumber::neat(double value, double step) const {
    const double grid = range_.integer ? 1 : std::pow(10.0, std::floor(std::log10(step)));
    double rounded = std::round(value / grid) * grid;
    // 0.1 * 3 is shown as 0.30000000000000004 in a file: go through the decimal form.
    rounded = QString::number(rounded, 'g', 12).toDouble();
    rounded = std::min(rounded, range_.max);
    if (rounded < range_.min || (range_.exclusiveMin && rounded <= range_.min))
        rounded = range_.exclusiveMin ? range_.min + grid : range_.min;
    return rounded;
}

void DragNumber::mousePressEvent(QMouseEvent* event) {
    if (state_ == State::Typing || event->button() != Qt::LeftButton)
        return QLineEdit::mousePressEvent(event);
    state_ = State::Pressed;
    pressedAt_ = event->position();
    dragStart_ = dragged_ = value_.value_or(0);
    event->accept();
}

void DragNumber::mouseMoveEvent(QMouseEvent* event) {
    if (state_ != State::Pressed && state_ != State::Dragging)
        return QLineEdit::mouseMoveEvent(event);
    const double pixels = event->position().x() - pressedAt_.x();
    if (state_ == State::Pressed) {
        if (std::abs(pixels) < QApplication::startDragDistance()) return;
        state_ = State::Dragging;
    }
    double step = stepAt(dragStart_);
    if (event->modifiers() & Qt::ShiftModifier) step /= 10;
    double next = neat(dragStart_ + pixels * step, step);
    if (event->modifiers() & Qt::ControlModifier)
        next = neat(dragStart_ + pixels * step, step * 10);
    if (next == dragged_) return;
    dragged_ = next;
    emit previewed(next);
}

void DragNumber::mouseReleaseEvent(QMouseEvent* event) {
    const State state = state_;
    if (state == State::Typing || event->button() != Qt::LeftButton)
        return QLineEdit::mouseReleaseEvent(event);
    state_ = State::Idle;
    if (state == State::Dragging) emit edited(dragged_);
    if (state == State::Pressed) {
        setFocus(Qt::MouseFocusReason);
        beginTyping();
    }
}

void DragNumber::beginTyping() {
    if (state_ == State::Typing) return;
    state_ = State::Typing;
    setReadOnly(false);
    setCursor(Qt::IBeamCursor);
    setText(value_ ? QString::number(*value_, 'g', QLocale::FloatingPointShortest) : QString());
    selectAll();
}

void DragNumber::finishTyping() {
    const QString typed = text().trimmed();
    const bool untouched =
        value_ ? typed == QString::number(*value_, 'g', QLocale::FloatingPointShortest)
               : typed.isEmpty();
    if (untouched) return leaveTyping();
    const auto value = evaluate(typed, value_.value_or(0), unit_);
    if (!value) return refuse(tr("\"%1\" is not a number").arg(typed));
    if (!range_.contains(*value))
        return refuse(tr("%1 is not %2").arg(shortNumber(*value), range_.text()));
    clearRefusal();
    emit edited(*value);
    if (!isRefused()) leaveTyping();
}

void DragNumber::leaveTyping() {
    state_ = State::Idle;
    setReadOnly(true);
    setCursor(Qt::SizeHorCursor);
    clearRefusal();
    showValue();
    deselect();
}

void DragNumber::cancelDrag() {
    state_ = State::Idle;
    emit canceled();
}

void DragNumber::refuse(const QString& reason) {
    if (!isRefused()) toolTipAsGiven_ = toolTip();
    setRefused(true);
    setToolTip(reason);
    QToolTip::showText(mapToGlobal(QPoint(0, height())), reason, this);
}

void DragNumber::clearRefusal() {
    if (!isRefused()) return;
    setRefused(false);
    setToolTip(toolTipAsGiven_);
    QToolTip::hideText();
}

void DragNumber::setRefused(bool refused) {
    setProperty("refused", refused);
    style()->unpolish(this);
    style()->polish(this);
}

void DragNumber::keyPressEvent(QKeyEvent* event) {
    const int key = event->key();
    if (key == Qt::Key_Escape && (state_ == State::Dragging || state_ == State::Typing)) {
        if (state_ == State::Dragging)
            cancelDrag();
        else
            leaveTyping();
    } else if (key == Qt::Key_Return || key == Qt::Key_Enter) {
        if (state_ == State::Typing)
            finishTyping();
        else
            beginTyping();
    } else if ((key == Qt::Key_Up || key == Qt::Key_Down) && value_) {
        double step = stepAt(*value_) * (event->modifiers() & Qt::ShiftModifier ? 1 : 10);
        if (range_.integer) step = 1;
        const double next = neat(*value_ + (key == Qt::Key_Up ? step : -step), step);
        if (state_ == State::Typing) leaveTyping();
        if (next != *value_) emit edited(next);
    } else {
        if (state_ == State::Idle && !event->text().isEmpty() && event->text()[0].isPrint())
            beginTyping();
        QLineEdit::keyPressEvent(event);
    }
}

bool DragNumber::event(QEvent* event) {
    // Escape while dragging or typing belongs to this field, not to a shortcut of the window.
    if (event->type() == QEvent::ShortcutOverride && state_ != State::Idle) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Escape || key == Qt::Key_Up || key == Qt::Key_Down) {
            event->accept();
            return true;
        }
    }
    return QLineEdit::event(event);
}

// A number must not change because the panel is scrolled under the pointer.
void DragNumber::wheelEvent(QWheelEvent* event) { event->ignore(); }

void DragNumber::focusInEvent(QFocusEvent* event) {
    QLineEdit::focusInEvent(event);
    if (event->reason() == Qt::TabFocusReason || event->reason() == Qt::BacktabFocusReason)
        beginTyping();
}

void DragNumber::focusOutEvent(QFocusEvent* event) {
    if (state_ == State::Typing) {
        finishTyping();
        if (isRefused()) leaveTyping();
    }
    QLineEdit::focusOutEvent(event);
}

// The row's menu (reset to default, ...) is the useful one while nothing is typed.
void DragNumber::contextMenuEvent(QContextMenuEvent* event) {
    if (state_ == State::Typing)
        QLineEdit::contextMenuEvent(event);
    else
        event->ignore();
}

}  // namespace glint
