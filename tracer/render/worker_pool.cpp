#include "tracer/render/worker_pool.h"

#include <pthread.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <string>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace glint {

void flushDenormals() {
#if defined(__SSE2__)
    _mm_setcsr(_mm_getcsr() | 0x8040);  // Flush to zero and denormals are zero.
#endif
}

void giveWay() {
    const auto self = static_cast<id_t>(syscall(SYS_gettid));
    setpriority(PRIO_PROCESS, self, getpriority(PRIO_PROCESS, 0) + 5);
}

WorkerPool::WorkerPool(int threads) {
    const int extra = std::max(threads, 1) - 1;
    threads_.reserve(static_cast<std::size_t>(extra));
    for (int worker = 1; worker <= extra; ++worker)
        threads_.emplace_back([this, worker] { loop(worker); });
}

WorkerPool::~WorkerPool() {
    quit_.store(true, std::memory_order_relaxed);
    generation_.fetch_add(1, std::memory_order_release);
    generation_.notify_all();
}

void WorkerPool::run(int pieces, const PieceFunction& work) {
    work_ = &work;
    pieces_ = pieces;
    next_.store(0, std::memory_order_relaxed);
    busy_.store(static_cast<int>(threads_.size()), std::memory_order_relaxed);
    generation_.fetch_add(1, std::memory_order_release);
    generation_.notify_all();
    takePieces(0);
    for (int busy = busy_.load(std::memory_order_acquire); busy > 0;
         busy = busy_.load(std::memory_order_acquire))
        busy_.wait(busy, std::memory_order_acquire);
}

void WorkerPool::loop(int worker) {
    pthread_setname_np(pthread_self(),
                       ("glint-worker-" + std::to_string(worker)).substr(0, 15).c_str());
    giveWay();
    flushDenormals();
    for (std::uint32_t seen = 0;;) {
        generation_.wait(seen, std::memory_order_acquire);
        seen = generation_.load(std::memory_order_acquire);
        if (quit_.load(std::memory_order_relaxed)) return;
        if (worker < limit_) takePieces(worker);
        if (busy_.fetch_sub(1, std::memory_order_acq_rel) == 1) busy_.notify_one();
    }
}

void WorkerPool::takePieces(int worker) {
    for (int piece = next_.fetch_add(1, std::memory_order_relaxed); piece < pieces_;
         piece = next_.fetch_add(1, std::memory_order_relaxed))
        (*work_)(worker, piece);
}

}  // namespace glint
