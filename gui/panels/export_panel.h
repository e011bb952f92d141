// ExportPanel: the export queue as a list: progress, time that remains and error figure of each,
// with pause and cancel.
#pragma once

#include <QScrollArea>
#include <map>

class QLabel;
class QProgressBar;
class QToolButton;
class QVBoxLayout;

namespace glint {

class ExportQueue;
struct ExportProgress;

class ExportPanel : public QScrollArea {
    Q_OBJECT

  public:
    explicit ExportPanel(ExportQueue& queue, QWidget* parent = nullptr);
    [[nodiscard]] QSize sizeHint() const override;

  private:
    struct Row {
        QWidget* widget;
        QLabel *name, *text;
        QProgressBar* bar;
        QToolButton *pause, *cancel;
    };
    void refresh();
    void showProgress(int id, const ExportProgress& progress);
    [[nodiscard]] Row makeRow(int id);

    ExportQueue& queue_;
    QVBoxLayout* layout_;
    QLabel* empty_;
    QToolButton* clear_;
    std::map<int, Row> rows_;
};

}  // namespace glint
