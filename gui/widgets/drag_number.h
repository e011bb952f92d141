// DragNumber: a number field. Drag sideways to change it, click or Tab into it to type arithmetic,
// arrow keys to step. It shows a value and emits intents; its owner sets the value back with
// setValue(), or refuses it with refuse().
#pragma once

#include <QLineEdit>
#include <optional>

namespace glint {

/// What a field takes.
struct NumberRange {
    double min = -std::numeric_limits<double>::infinity();
    double max = std::numeric_limits<double>::infinity();
    bool exclusiveMin = false;  ///< min itself is not allowed
    bool integer = false;

    [[nodiscard]] bool contains(double value) const;
    /// "0 to 1", "above 0", ... for messages.
    [[nodiscard]] QString text() const;
};

class DragNumber : public QLineEdit {
    Q_OBJECT

  public:
    explicit DragNumber(QWidget* parent = nullptr);

    void setRange(const NumberRange& range) { range_ = range; }
    /// As in field tables: "m", "deg", "px" ...; shown behind the number.
    void setUnit(const QString& unit);
    void setValue(double value);
    /// Shows "—": many values that differ.
    void setMixed();
    [[nodiscard]] std::optional<double> value() const { return value_; }
    /// Marks what was typed as refused, with the reason, until the next good value.
    void refuse(const QString& reason);
    [[nodiscard]] bool isRefused() const { return property("refused").toBool(); }
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

  signals:
    /// While dragging.
    void previewed(double value);
    /// A drag ended, a number was typed or stepped.
    void edited(double value);
    /// A drag was given up.
    void canceled();

  protected:
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    bool event(QEvent* event) override;

  private:
    enum class State { Idle, Pressed, Dragging, Typing };
    void beginTyping();
    void finishTyping();
    void leaveTyping();
    void cancelDrag();
    void showValue();
    void clearRefusal();
    void setRefused(bool refused);
    /// Change of one pixel of drag, in the field's unit.
    [[nodiscard]] double stepAt(double value) const;
    /// The nearest allowed number that is neat at the scale of `step`.
    [[nodiscard]] double neat(double value, double step) const;

    NumberRange range_;
    QString unit_, toolTipAsGiven_;
    std::optional<double> value_;
    State state_ = State::Idle;
    QPointF pressedAt_;
    double dragStart_ = 0, dragged_ = 0;
};

/// As many digits as fields show where there is room.
inline constexpr int kShownDigits = 6;
/// The number with up to so many digits.
[[nodiscard]] QString shortNumber(double value, int digits = kShownDigits);
/// Unit of a field table as a person reads it: "deg" -> "°", "m2" -> "m²".
[[nodiscard]] QString shownUnit(const QString& unit);

}  // namespace glint
