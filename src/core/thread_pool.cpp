// SPDX-License-Identifier: Apache-2.0
#include "core/thread_pool.h"

namespace frana {
namespace {

// A step has a dozen short loops: waking a sleeping thread for each would cost more than the loops. Threads therefore
// check again this many times (some tens of microseconds) before they sleep.
// With more threads than processors, checking only takes the processor from the thread that is waited for.
int checks_before_sleep(int threads) {
    constexpr int k_checks = 4000;
    return threads <= static_cast<int>(std::thread::hardware_concurrency()) ? k_checks : 0;
}

inline void pause() noexcept {
#if defined(__x86_64__)
    __builtin_ia32_pause();
#endif
}

}  // namespace

ThreadPool::ThreadPool(int threads) : checks_(checks_before_sleep(threads)) {
    for (int i = 1; i < threads; ++i) workers_.emplace_back([this] { serve(); });
}

ThreadPool::~ThreadPool() {
    stop_.store(true);
    epoch_.fetch_add(1, std::memory_order_release);
    epoch_.notify_all();
    for (std::thread& worker : workers_) worker.join();
}

void ThreadPool::start(std::size_t count, Call call, const void* task) {
    call_ = call;
    task_ = task;
    done_.store(0, std::memory_order_relaxed);
    const std::uint64_t loop = (tickets_.load(std::memory_order_relaxed) >> k_count_bits) + 1;
    tickets_.store(loop << k_count_bits | count, std::memory_order_release);
    epoch_.fetch_add(1, std::memory_order_release);
    epoch_.notify_all();
    work();
    // Waits only for tasks already taken: a thread that has not yet woken up does not delay the loop.
    int checks = 0;
    for (std::size_t done = done_.load(std::memory_order_acquire); done != count;
         done = done_.load(std::memory_order_acquire)) {
        if (++checks < checks_) {
            pause();
        } else {
            done_.wait(done, std::memory_order_acquire);
        }
    }
}

// Runs tasks until none is left. A ticket contains the loop's number and the tasks left in it and changes atomically: a
// thread that takes one knows that its loop cannot end before that task does, so call_ and task_ belong to that loop.
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
