// ErrorReportDialog: how the error of the current scene falls with samples and time, as a table and
// a plot (Render menu). Not modal; the measuring is done on a thread of its own on a copy of the
// scene, so editing goes on meanwhile.
#pragma once

#include <QDialog>
#include <atomic>
#include <filesystem>
#include <thread>

#include "tracer/render/error_report.h"
#include "tracer/scene/scene.h"

class QLabel;
class QProgressBar;
class QPushButton;
class QSvgWidget;
class QTableWidget;

namespace glint {

class Document;

class ErrorReportDialog : public QDialog {
    Q_OBJECT

  public:
    /// Starts measuring at once.
    explicit ErrorReportDialog(const Document& document, QWidget* parent = nullptr);
    /// Cancels and joins; a render looks at each path vertex, so that takes no time that a person
    /// notices.
    ~ErrorReportDialog() override;

  signals:
    // From the measuring thread; received on the GUI thread as queued events.
    void progressed(int percent);
    void measured(const QString& error);

  private:
    void build();
    void measure();
    [[nodiscard]] QString measureScene();
    void onMeasured(const QString& error);
    void fillTable();
    void saveCsv();

    Scene scene_;  ///< smaller than the document's, so that it takes a minute and not an hour
    std::filesystem::path assetFolder_;
    ErrorReport report_;  ///< written by the thread, read once it has said measured()

    QLabel* state_ = nullptr;
    QProgressBar* progress_ = nullptr;
    QTableWidget* table_ = nullptr;
    QSvgWidget* plot_ = nullptr;
    QPushButton *save_ = nullptr, *cancel_ = nullptr;

    /// Set on the GUI thread, read by the renders. Relaxed: it carries nothing but itself.
    std::atomic<bool> stop_{false};
    std::jthread thread_;
};

}  // namespace glint
