// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <thread>
#include <vector>

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

/// A fixed set of threads for loops over independent tasks. Which thread runs which task is not determined, so a task
/// may write only data that no other task of the loop accesses; results then do not depend on the number of threads.
class ThreadPool {
  public:
    /// Starts a pool of `threads` (at least 1), including the calling thread.
    explicit ThreadPool(int threads);
    ~ThreadPool();
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;

    [[nodiscard]] int threads() const noexcept { return static_cast<int>(workers_.size()) + 1; }

    /// Calls task(i) once for every i in [0, count) and returns when all are done. Tasks must not throw.
    template <class Task>
    void for_each(std::size_t count, const Task& task) {
        if (workers_.empty() || count < 2) {
            for (std::size_t i = 0; i < count; ++i) task(i);
            return;
        }
        start(
            count, [](const void* f, std::size_t i) { (*static_cast<const Task*>(f))(i); }, &task);
    }

    /// Calls task(begin, end) for consecutive blocks of [0, count), each of at most `block` items.
    template <class Task>
    void for_blocks(std::size_t count, std::size_t block, const Task& task) {
        for_each((count + block - 1) / block, [&](std::size_t i) {
            const std::size_t begin = i * block;
            task(begin, begin + block < count ? begin + block : count);
        });
    }

  private:
    using Call = void (*)(const void*, std::size_t);
    [[nodiscard]] double worked_seconds() const noexcept;
    void wait_for(std::size_t count);
    void start(std::size_t count, Call call, const void* task);
    void work();
    void serve();

    const int checks_;  ///< before an idle thread sleeps
    std::vector<std::thread> workers_;
    std::vector<clockid_t> worker_clocks_;  ///< of their processor time
    TeamWatch watch_;
    std::atomic<std::uint32_t> epoch_{0};
    static constexpr int k_count_bits = 32;
    std::atomic<std::uint64_t> tickets_{0};  ///< number of the loop and, in the low bits, the tasks left
    std::atomic<std::size_t> done_{0};
    std::atomic<bool> stop_{false};
    Call call_ = nullptr;
    const void* task_ = nullptr;
};

}  // namespace frana
