#include "gui/panels/export_panel.h"

#include <QFontMetrics>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "gui/app/export_queue.h"
#include "gui/app/text.h"
#include "gui/widgets/icons.h"

namespace glint {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(ExportPanel)
};

QString duration(double seconds) {
    const auto s = static_cast<qint64>(std::ceil(seconds));
    if (s < 60) return Text::tr("%1 s").arg(s);
    if (s < 3600) return Text::tr("%1 min %2 s").arg(s / 60).arg(s % 60);
    return Text::tr("%1 h %2 min").arg(s / 3600).arg(s / 60 % 60);
}

/// "frame 3 of 36 · 128 spp · ± 0.8 % · 41 s left"
QString progressText(const ExportProgress& p) {
    QStringList parts;
    if (p.frames > 1) parts << Text::tr("frame %1 of %2").arg(p.frame + 1).arg(p.frames);
    if (p.spp > 0) parts << Text::tr("%1 spp").arg(p.spp);
    if (p.error < kInfinity)
        parts << Text::tr("± %1 %").arg(QString::number(100 * p.error, 'g', 2));
    if (p.remainingSeconds > 1) parts << Text::tr("%1 left").arg(duration(p.remainingSeconds));
    return parts.join(QStringLiteral(" · "));
}

QString stateText(const ExportQueue::Entry& entry) {
    switch (entry.state) {
        case ExportQueue::State::Waiting:
            return Text::tr("waiting");
        case ExportQueue::State::Running:
            return entry.progress.spp > 0 ? progressText(entry.progress) : Text::tr("starting");
        case ExportQueue::State::Paused:
            return Text::tr("paused") + (entry.progress.spp > 0
                                             ? QStringLiteral(" · ") + progressText(entry.progress)
                                             : QString());
        case ExportQueue::State::Done:
            return Text::tr("done");
        case ExportQueue::State::Canceled:
            return Text::tr("canceled");
        case ExportQueue::State::Failed:
            return entry.error;
    }
    return {};
}

QToolButton* button(QWidget* parent, const char* iconName, const QString& tip) {
    auto* out = new QToolButton(parent);
    out->setIcon(icon(iconName));
    out->setAutoRaise(true);
    out->setToolTip(tip);
    out->setAccessibleName(tip);
    return out;
}

}  // namespace

ExportPanel::ExportPanel(ExportQueue& queue, QWidget* parent) : QScrollArea(parent), queue_(queue) {
    setAccessibleName(tr("Exports"));
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    auto* content = new QWidget(this);
    layout_ = new QVBoxLayout(content);
    layout_->setSpacing(4);
    empty_ = new QLabel(tr("No exports. F12 renders the picture to a file."), content);
    empty_->setEnabled(false);
    empty_->setWordWrap(true);
    clear_ = button(content, "delete", tr("Take finished exports off the list"));
    clear_->setObjectName("exports.clear");
    connect(clear_, &QToolButton::clicked, &queue, &ExportQueue::clearEnded);
    layout_->addWidget(empty_);
    layout_->addStretch(1);
    layout_->addWidget(clear_, 0, Qt::AlignRight);
    setWidget(content);
    connect(&queue, &ExportQueue::changed, this, &ExportPanel::refresh);
    connect(&queue, &ExportQueue::progressed, this, &ExportPanel::showProgress);
    refresh();
}

QSize ExportPanel::sizeHint() const {
    return {fontMetrics().averageCharWidth() * 50, fontMetrics().height() * 8};
}

ExportPanel::Row ExportPanel::makeRow(int id) {
    Row row{};
    row.widget = new QWidget(widget());
    row.name = new QLabel(row.widget);
    row.text = new QLabel(row.widget);
    row.text->setWordWrap(true);
    row.text->setEnabled(false);
    row.bar = new QProgressBar(row.widget);
    row.bar->setRange(0, 1000);
    row.bar->setTextVisible(false);
    row.pause = button(row.widget, "pause", tr("Pause, or go on"));
    row.pause->setObjectName(QStringLiteral("exports.pause.%1").arg(id));
    row.pause->setCheckable(true);
    row.cancel = button(row.widget, "close", tr("Cancel"));
    row.cancel->setObjectName(QStringLiteral("exports.cancel.%1").arg(id));
    connect(row.pause, &QToolButton::clicked, this,
            [this, id](bool on) { queue_.setPaused(id, on); });
    connect(row.cancel, &QToolButton::clicked, this, [this, id] { queue_.cancel(id); });
    auto* top = new QHBoxLayout;
    top->addWidget(row.name, 1);
    top->addWidget(row.pause);
    top->addWidget(row.cancel);
    auto* layout = new QVBoxLayout(row.widget);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addLayout(top);
    layout->addWidget(row.bar);
    layout->addWidget(row.text);
    return row;
}

void ExportPanel::refresh() {
    const auto entries = queue_.entries();
    std::erase_if(rows_, [&](const auto& item) {
        const bool gone = std::none_of(entries.begin(), entries.end(),
                                       [&](const auto& entry) { return entry.id == item.first; });
        // Later: the click on its own button may have led here.
        if (gone) item.second.widget->hide(), item.second.widget->deleteLater();
        return gone;
    });
    for (const ExportQueue::Entry& entry : entries) {
        if (!rows_.contains(entry.id)) {
            rows_[entry.id] = makeRow(entry.id);
            layout_->insertWidget(static_cast<int>(rows_.size()), rows_[entry.id].widget);
        }
        const Row& row = rows_.at(entry.id);
        row.name->setText(pathText(entry.output.filename()));
        row.name->setToolTip(pathText(entry.output));
        row.text->setText(stateText(entry));
        row.bar->setValue(static_cast<int>(entry.progress.fraction * 1000));
        const bool paused = entry.state == ExportQueue::State::Paused;
        row.pause->setChecked(paused);
        row.pause->setIcon(icon(paused ? "play" : "pause"));
        for (QToolButton* control : {row.pause, row.cancel})
            control->setEnabled(!hasEnded(entry.state));
    }
    empty_->setVisible(entries.empty());
    clear_->setVisible(std::any_of(entries.begin(), entries.end(),
                                   [](const auto& entry) { return hasEnded(entry.state); }));
}

void ExportPanel::showProgress(int id, const ExportProgress& progress) {
    const auto found = rows_.find(id);
    if (found == rows_.end()) return;
    found->second.bar->setValue(static_cast<int>(progress.fraction * 1000));
    for (const ExportQueue::Entry& entry : queue_.entries())
        if (entry.id == id) found->second.text->setText(stateText(entry));
}

}  // namespace glint
