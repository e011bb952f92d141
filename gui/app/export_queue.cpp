#include "gui/app/export_queue.h"

#include <QDesktopServices>
#include <QUrl>
#include <algorithm>

#include "gui/app/text.h"
#include "gui/widgets/message_bar.h"

namespace glint {

ExportQueue::ExportQueue(MessageBar& messages, QObject* parent)
    : QObject(parent), messages_(messages) {}

ExportQueue::~ExportQueue() = default;

ExportQueue::Slot* ExportQueue::find(int id) {
    const auto found = std::find_if(slots_.begin(), slots_.end(),
                                    [&](const auto& slot) { return slot->entry.id == id; });
    return found == slots_.end() ? nullptr : found->get();
}

void ExportQueue::add(ExportRequest request) {
    auto slot = std::make_unique<Slot>();
    slot->entry.id = ++lastId_;
    slot->entry.output = request.output;
    slot->entry.progress.frames = request.turntable ? request.turntable->frames : 1;
    slot->request = std::move(request);
    slots_.push_back(std::move(slot));
    pump();
    emit changed();
}

void ExportQueue::pump() {
    const auto isIn = [](State state) {
        return [state](const auto& slot) { return slot->entry.state == state; };
    };
    if (std::any_of(slots_.begin(), slots_.end(), isIn(State::Running))) return;
    const auto next = std::find_if(slots_.begin(), slots_.end(), isIn(State::Waiting));
    if (next != slots_.end()) start(**next);
}

void ExportQueue::start(Slot& slot) {
    slot.entry.state = State::Running;
    if (slot.job) return slot.job->setPaused(false);
    slot.job = std::make_unique<ExportJob>(slot.request);
    const int id = slot.entry.id;
    connect(
        slot.job.get(), &ExportJob::progressed, this,
        [this, id](const ExportProgress& progress) {
            if (Slot* running = find(id)) running->entry.progress = progress;
            emit progressed(id, progress);
        },
        Qt::QueuedConnection);
    connect(
        slot.job.get(), &ExportJob::finished, this,
        [this, id](const QString& error, bool canceled) { onFinished(id, error, canceled); },
        Qt::QueuedConnection);
}

void ExportQueue::setPaused(int id, bool paused) {
    Slot* slot = find(id);
    if (!slot || hasEnded(slot->entry.state) || paused == (slot->entry.state == State::Paused))
        return;
    // One that goes on waits for its turn, as the others do.
    slot->entry.state = paused ? State::Paused : State::Waiting;
    if (slot->job && paused) slot->job->setPaused(true);
    pump();
    emit changed();
}

void ExportQueue::cancel(int id) {
    Slot* slot = find(id);
    if (!slot || hasEnded(slot->entry.state)) return;
    if (slot->job) return slot->job->cancel();
    slot->entry.state = State::Canceled;
    emit changed();
}

void ExportQueue::cancelAll() {
    // Those that wait first, so that none of them starts.
    for (const bool withJob : {false, true})
        for (const Entry& entry : entries())
            if (const Slot* slot = find(entry.id); (slot->job != nullptr) == withJob)
                cancel(entry.id);
}

void ExportQueue::clearEnded() {
    std::erase_if(slots_, [](const auto& slot) { return hasEnded(slot->entry.state); });
    emit changed();
}

bool ExportQueue::isIdle() const {
    return std::all_of(slots_.begin(), slots_.end(),
                       [](const auto& slot) { return hasEnded(slot->entry.state); });
}

std::vector<ExportQueue::Entry> ExportQueue::entries() const {
    std::vector<Entry> out;
    for (const auto& slot : slots_) out.push_back(slot->entry);
    return out;
}

void ExportQueue::onFinished(int id, const QString& error, bool canceled) {
    Slot* slot = find(id);
    if (!slot) return;
    slot->job.reset();
    slot->request = {};
    slot->entry.error = error;
    slot->entry.state = !error.isEmpty() ? State::Failed : canceled ? State::Canceled : State::Done;
    if (slot->entry.state == State::Done) slot->entry.progress.fraction = 1;
    announce(slot->entry);
    pump();
    emit changed();
}

void ExportQueue::announce(const Entry& entry) {
    const auto output = std::filesystem::absolute(entry.output);
    switch (entry.state) {
        case State::Failed:
            return messages_.show(MessageBar::Level::Error,
                                  tr("Not exported: %1").arg(entry.error));
        case State::Canceled:
            return messages_.show(MessageBar::Level::Info, tr("Export canceled"));
        default:
            break;
    }
    // Of a sequence the folder: its first picture says little.
    const auto shown = entry.progress.frames > 1 ? output.parent_path() : output;
    const QString text =
        entry.progress.frames > 1
            ? tr("Exported %1 pictures %2").arg(entry.progress.frames).arg(pathText(output))
            : tr("Exported %1").arg(pathText(output));
    messages_.show(MessageBar::Level::Info, text, {},
                   {{tr("Show"), [shown] {
                         QDesktopServices::openUrl(QUrl::fromLocalFile(pathText(shown)));
                     }}});
}

}  // namespace glint
