// NarrowLayout: a window without room for docks on both sides of the picture has them all as tabs
// on the right, until it is wide again. Floating docks stay where they are.
#pragma once

#include <QByteArray>
#include <QObject>

class QMainWindow;

namespace glint {

class NarrowLayout : public QObject {
    Q_OBJECT

  public:
    /// Watches the width of `window`.
    NarrowLayout(QMainWindow& window, QObject* parent);

    [[nodiscard]] bool isNarrow() const { return !wide_.isEmpty(); }
    /// The layout to remember: that of the wide window.
    [[nodiscard]] QByteArray wideState() const;

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void follow();

    QMainWindow& window_;
    QByteArray wide_;  ///< the layout to come back to; empty while the window is wide
};

}  // namespace glint
