// ExportQueue: exports in the background, one at a time, in the order they were asked for. A paused
// one lets the next go on.
#pragma once

#include <QObject>
#include <memory>
#include <vector>

#include "gui/app/export_job.h"

namespace glint {

class MessageBar;

class ExportQueue : public QObject {
    Q_OBJECT

  public:
    enum class State { Waiting, Running, Paused, Done, Canceled, Failed };
    struct Entry {
        int id = 0;
        std::filesystem::path output;
        State state = State::Waiting;
        ExportProgress progress;
        QString error;  ///< why it failed
    };

    explicit ExportQueue(MessageBar& messages, QObject* parent = nullptr);
    ~ExportQueue() override;

    void add(ExportRequest request);
    void setPaused(int id, bool paused);
    void cancel(int id);
    void cancelAll();
    /// Takes what has ended off the list.
    void clearEnded();
    /// Nothing runs and nothing is to be run.
    [[nodiscard]] bool isIdle() const;
    [[nodiscard]] std::vector<Entry> entries() const;

  signals:
    /// Other entries, or other states.
    void changed();
    void progressed(int id, const glint::ExportProgress& progress);

  private:
    struct Slot {
        Entry entry;
        ExportRequest request;
        std::unique_ptr<ExportJob> job;  ///< while it runs or is paused in the middle
    };
    [[nodiscard]] Slot* find(int id);
    /// Lets the first one that waits run, if none does.
    void pump();
    void start(Slot& slot);
    void onFinished(int id, const QString& error, bool canceled);
    void announce(const Entry& entry);

    MessageBar& messages_;
    std::vector<std::unique_ptr<Slot>> slots_;
    int lastId_ = 0;
};

[[nodiscard]] constexpr bool hasEnded(ExportQueue::State state) {
    return state == ExportQueue::State::Done || state == ExportQueue::State::Canceled ||
           state == ExportQueue::State::Failed;
}

}  // namespace glint
