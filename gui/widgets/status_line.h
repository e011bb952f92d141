// StatusLine: what the program is doing and how good the picture is.
#pragma once

#include <QPoint>
#include <QWidget>
#include <vector>

#include "tracer/render/session.h"

class QLabel;
class QToolButton;

namespace glint {

class StatusLine : public QWidget {
    Q_OBJECT

  public:
    explicit StatusLine(QWidget* parent = nullptr);

    void showFrame(const SessionFrame& frame);
    /// The error at a pixel of the picture is told with the frame; none is (-1, -1).
    void showPixel(const QPoint& pixel);
    void showSelection(const QString& text);
    [[nodiscard]] QString text() const;

  private:
    void showWarnings(const std::vector<Error>& warnings);
    void openWarnings();
    void showState();

    QLabel* state_;
    QLabel* selection_;
    QToolButton* warningButton_;
    std::vector<Error> warnings_;
    QString size_, selectionText_, stateText_;
    TileErrors errors_;
    QPoint pixel_{-1, -1};
};

}  // namespace glint
