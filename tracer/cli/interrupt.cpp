#include "tracer/cli/interrupt.h"

#include <csignal>

namespace glint {

namespace {

// Written by the signal handler, read by the render threads; relaxed, for it orders nothing else.
std::atomic<bool> interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler must not take a lock");

}  // namespace

const std::atomic<bool>& watchInterrupts() {
    struct sigaction action {};
    action.sa_handler = [](int) { interrupted.store(true, std::memory_order_relaxed); };
    action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
    return interrupted;
}

}  // namespace glint
