// StatusLine: what the program is doing and how good the picture is.
#pragma once

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
    void showSelection(const QString& text);
    [[nodiscard]] QString text() const;

  private:
    void showWarnings(const std::vector<Error>& warnings);
    void openWarnings();

    QLabel* state_;
    QLabel* selection_;
    QToolButton* warningButton_;
    std::vector<Error> warnings_;
    QString size_, selectionText_;
};

}  // namespace glint
