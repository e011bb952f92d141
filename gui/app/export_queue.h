// ExportQueue: exports one after another, shown in the message bar.
#pragma once

#include <QObject>
#include <deque>
#include <memory>

#include "gui/app/export_job.h"

namespace glint {

class MessageBar;

class ExportQueue : public QObject {
    Q_OBJECT

  public:
    explicit ExportQueue(MessageBar& messages, QObject* parent = nullptr);

    void add(ExportRequest request);
    void cancelAll();
    [[nodiscard]] bool isIdle() const { return !job_ && waiting_.empty(); }

  private:
    void startNext();
    void showProgress(double fraction, double remainingSeconds, int spp);
    void onFinished(const QString& error, bool canceled);

    MessageBar& messages_;
    std::deque<ExportRequest> waiting_;
    std::unique_ptr<ExportJob> job_;
};

}  // namespace glint
