// WorkerPool: N threads of our own that share out numbered pieces of work. Named, slightly nice,
// joined by their owner.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <thread>
#include <vector>

namespace glint {

/// Work on one numbered piece; `worker` is below threads().
using PieceFunction = std::function<void(int worker, int piece)>;

class WorkerPool {
  public:
    /// At least one thread. With one, the calling thread of run() is used and none is started.
    explicit WorkerPool(int threads);
    ~WorkerPool();
    WorkerPool(const WorkerPool&) = delete;
    WorkerPool& operator=(const WorkerPool&) = delete;

    [[nodiscard]] int threads() const { return static_cast<int>(threads_.size()) + 1; }

    /// At most so many threads (at least 1) take pieces from now on; the others sleep. Called
    /// between runs.
    void limit(int threads) { limit_ = threads; }

    /// Calls work(worker, piece) for every piece below `pieces` and returns when all are done. The
    /// calling thread is worker 0.
    void run(int pieces, const PieceFunction& work);

  private:
    void loop(int worker);
    void takePieces(int worker);

    std::vector<std::jthread> threads_;
    const PieceFunction* work_ = nullptr;
    int pieces_ = 0;
    int limit_ = 1 << 20;
    std::atomic<int> next_{
        0};  ///< next piece; partners: takePieces of all workers (relaxed: only a number)
    std::atomic<std::uint32_t> generation_{
        0};                          ///< a run begins: release in run(), acquire in loop()
    std::atomic<int> busy_{0};       ///< workers not done yet: release in loop(), acquire in run()
    std::atomic<bool> quit_{false};  ///< set before the last generation; read after it
};

/// Denormals count as zero on the calling thread from now on, so that no scene is slow because it
/// is dim. The results of the tracer do not rest on numbers that small.
void flushDenormals();

/// The calling thread is slightly nice from now on: one that answers a person goes first.
void giveWay();

}  // namespace glint
