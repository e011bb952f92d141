#include "gui/app/export_queue.h"

#include <QDesktopServices>
#include <QUrl>
#include <cmath>

#include "gui/app/text.h"
#include "gui/widgets/message_bar.h"

namespace glint {

ExportQueue::ExportQueue(MessageBar& messages, QObject* parent) : QObject(parent), messages_(messages) {}

void ExportQueue::add(ExportRequest request) {
    waiting_.push_back(std::move(request));
    if (!job_) startNext();
}

void ExportQueue::cancelAll() {
    waiting_.clear();
    if (job_) job_->cancel();
}

void ExportQueue::startNext() {
    if (waiting_.empty()) return;
    job_ = std::make_unique<ExportJob>(std::move(waiting_.front()));
    waiting_.pop_front();
    connect(job_.get(), &ExportJob::progressed, this, &ExportQueue::showProgress, Qt::QueuedConnection);
    connect(job_.get(), &ExportJob::finished, this, &ExportQueue::onFinished, Qt::QueuedConnection);
    showProgress(0, 0, 0);
}

void ExportQueue::showProgress(double fraction, double remainingSeconds, int spp) {
    if (!job_) return;
    QString text = tr("Exporting %1").arg(pathText(job_->output().filename()));
    if (spp > 0) text += tr(" · %1 spp").arg(spp);
    if (remainingSeconds > 1) text += tr(" · %1 s left").arg(std::ceil(remainingSeconds));
    if (!waiting_.empty()) text += tr(" · %n more waiting", nullptr, static_cast<int>(waiting_.size()));
    messages_.showProgress(text, fraction, {{tr("Cancel"), [this] { cancelAll(); }}});
}

void ExportQueue::onFinished(const QString& error, bool canceled) {
    const auto output = std::filesystem::absolute(job_->output());
    job_.reset();
    if (!error.isEmpty()) {
        messages_.show(MessageBar::Level::Error, tr("Not exported: %1").arg(error));
    } else if (canceled) {
        messages_.show(MessageBar::Level::Info, tr("Export canceled"));
    } else {
        messages_.show(MessageBar::Level::Info, tr("Exported %1").arg(pathText(output)), {}, {{tr("Show"), [output] {
            QDesktopServices::openUrl(QUrl::fromLocalFile(pathText(output)));
        }}});
    }
    startNext();
}

}  // namespace glint
