// SPDX-License-Identifier: Apache-2.0
#include "core/thread_pool.h"

#include <pthread.h>

#include <algorithm>
#include <chrono>

namespace frana {

double cpu_seconds(clockid_t clock) noexcept {
    constexpr double k_nano = 1e-9;
    timespec time{};
    if (clock_gettime(clock, &time) != 0) return 0;
    return static_cast<double>(time.tv_sec) + k_nano * static_cast<double>(time.tv_nsec);
}

void TeamWatch::start(Clock::time_point now) noexcept {
    window_begin_ = now;
    own_begin_ = cpu_seconds(CLOCK_THREAD_CPUTIME_ID);
    waited_ = stolen_ = 0;
}

bool TeamWatch::alone(Clock::time_point now) noexcept {
    if (alone_) {
        if (now < alone_until_) return true;
        alone_ = false;
        start(now);
        return false;
    }
    const double window = std::chrono::duration<double>(now - window_begin_).count();
    if (window < k_window) return false;
    // Between loops the caller may have slept, waiting for a disk or a frame: windows much longer than intended are not
    // used.
    constexpr double k_usable = 4 * k_window;
    if (window < k_usable) {
        const double own = cpu_seconds(CLOCK_THREAD_CPUTIME_ID) - own_begin_;
        stolen_ += std::max(0.0, window - own - waited_);
        alone_ = stolen_ > k_too_much * window;
        if (alone_) {
            alone_until_ = now + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(pause_));
            pause_ = std::min(2 * pause_, k_longest_pause);
        } else {
            pause_ = k_first_pause;
        }
    }
    start(now);
    return alone_;
}

void TeamWatch::add_wait(double waited, double worked) noexcept {
    waited_ += waited;
    stolen_ += std::max(0.0, waited - worked);
}

namespace {

// A step has a dozen short loops: waking a sleeping thread for each would cost more than the loops. Threads therefore
// check again this many times (some tens of microseconds) before they sleep.
// With more threads than processors, checking only occupies the processor that the other threads need.
int checks_before_sleep(int threads) {
    constexpr int k_checks = 4000;
    return threads <= static_cast<int>(std::thread::hardware_concurrency()) ? k_checks : 0;
}

void pause() noexcept {
#if defined(__x86_64__)
    __builtin_ia32_pause();
#endif
}

}  // namespace

ThreadPool::ThreadPool(int threads) : checks_(checks_before_sleep(threads)) {
    for (int i = 1; i < threads; ++i) {
        workers_.emplace_back([this] { serve(); });
        clockid_t clock{};
        if (pthread_getcpuclockid(workers_.back().native_handle(), &clock) == 0) worker_clocks_.push_back(clock);
    }
    watch_.start(TeamWatch::Clock::now());
}

ThreadPool::~ThreadPool() {
    stop_.store(true);
    epoch_.fetch_add(1, std::memory_order_release);
    epoch_.notify_all();
    for (std::thread& worker : workers_) worker.join();
}

double ThreadPool::worked_seconds() const noexcept {
    double sum = 0;
    for (const clockid_t clock : worker_clocks_) sum += cpu_seconds(clock);
    return sum;
}

void ThreadPool::start(std::size_t count, Call call, const void* task) {
    if (watch_.alone(TeamWatch::Clock::now())) {
        for (std::size_t i = 0; i < count; ++i) call(task, i);
        return;
    }
    call_ = call;
    task_ = task;
    done_.store(0, std::memory_order_relaxed);
    const std::uint64_t loop = (tickets_.load(std::memory_order_relaxed) >> k_count_bits) + 1;
    tickets_.store(loop << k_count_bits | count, std::memory_order_release);
    epoch_.fetch_add(1, std::memory_order_release);
    epoch_.notify_all();
    work();
    wait_for(count);
}

// Waits only for tasks already taken: a thread that has not yet woken up does not delay the loop.
void ThreadPool::wait_for(std::size_t count) {
    std::size_t done = done_.load(std::memory_order_acquire);
    for (int checks = 0; done != count && checks < checks_; ++checks) {
        pause();
        done = done_.load(std::memory_order_acquire);
    }
    if (done == count) return;
    const auto begin = TeamWatch::Clock::now();
    const double worked = worked_seconds();
    for (; done != count; done = done_.load(std::memory_order_acquire)) done_.wait(done, std::memory_order_acquire);
    watch_.add_wait(std::chrono::duration<double>(TeamWatch::Clock::now() - begin).count(), worked_seconds() - worked);
}

// Runs tasks until none is left. A ticket contains the loop's number and the tasks left in it and changes atomically:
// the loop of a task with a ticket cannot end before that task does, so call_ and task_ belong to that loop.
void ThreadPool::work() {
    constexpr std::uint64_t k_left = (std::uint64_t{1} << k_count_bits) - 1;
    std::uint64_t ticket = tickets_.load(std::memory_order_acquire);
    while ((ticket & k_left) != 0) {
        if (!tickets_.compare_exchange_weak(ticket, ticket - 1, std::memory_order_acq_rel, std::memory_order_acquire)) {
            continue;
        }
        call_(task_, static_cast<std::size_t>((ticket & k_left) - 1));
        done_.fetch_add(1, std::memory_order_acq_rel);
        done_.notify_one();
        ticket = tickets_.load(std::memory_order_acquire);
    }
}

void ThreadPool::serve() {
    std::uint32_t last_epoch = 0;
    while (true) {
        int checks = 0;
        while (epoch_.load(std::memory_order_acquire) == last_epoch) {
            if (++checks < checks_) {
                pause();
            } else {
                epoch_.wait(last_epoch, std::memory_order_acquire);
            }
        }
        last_epoch = epoch_.load(std::memory_order_acquire);
        if (stop_.load()) return;
        work();
    }
}

}  // namespace frana
