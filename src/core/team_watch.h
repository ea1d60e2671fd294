// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <ctime>

namespace frana {

/// Processor time of a clock such as CLOCK_THREAD_CPUTIME_ID or one from pthread_getcpuclockid [s]; 0 if it fails.
double cpu_seconds(clockid_t clock) noexcept;

/// Detects that other processes use the processors of a team of threads. Every loop ends with a wait for the tasks
/// in progress; a thread that the system suspends during one stops the whole team for a time slice. Measures the
/// fraction of time lost this way over windows of k_window [s]; above k_too_much the calling thread works alone, first
/// for k_first_pause [s], then twice as long each time, up to k_longest_pause.
class TeamWatch {
  public:
    using Clock = std::chrono::steady_clock;

    void start(Clock::time_point now) noexcept;
    /// Whether the caller should work alone in the loop that begins now.
    [[nodiscard]] bool alone(Clock::time_point now) noexcept;
    /// Adds a wait of the caller [s], in which the others ran for `worked` [s] of processor time.
    void add_wait(double waited, double worked) noexcept;

  private:
    static constexpr double k_window = 0.02, k_too_much = 0.4, k_first_pause = 0.1, k_longest_pause = 1;

    Clock::time_point window_begin_{}, alone_until_{};
    double own_begin_ = 0;            ///< processor time of the caller when the window began [s]
    double waited_ = 0, stolen_ = 0;  ///< in this window [s]
    double pause_ = k_first_pause;
    bool alone_ = false;
};

}  // namespace frana
