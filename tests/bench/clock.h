// Time that passes, and time that processors work for us: on a busy machine only the second can be
// compared.
#pragma once

#include <chrono>
#include <ctime>

namespace glint::bench {

class Stopwatch {
  public:
    /// Since this object was made [s].
    [[nodiscard]] double wallSeconds() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_).count();
    }
    /// Processor time of all threads of this process since then [s].
    [[nodiscard]] double processSeconds() const {
        return clockSeconds(CLOCK_PROCESS_CPUTIME_ID) - process_;
    }
    /// Processor time of the calling thread since then [s]; it must be the one that made the
    /// object.
    [[nodiscard]] double threadSeconds() const {
        return clockSeconds(CLOCK_THREAD_CPUTIME_ID) - thread_;
    }

  private:
    static double clockSeconds(clockid_t clock) {
        timespec now{};
        clock_gettime(clock, &now);
        return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
    }
    std::chrono::steady_clock::time_point wall_ = std::chrono::steady_clock::now();
    double process_ = clockSeconds(CLOCK_PROCESS_CPUTIME_ID);
    double thread_ = clockSeconds(CLOCK_THREAD_CPUTIME_ID);
};

}  // namespace glint::bench
