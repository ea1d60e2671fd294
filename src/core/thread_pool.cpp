// SPDX-License-Identifier: Apache-2.0
#include "core/thread_pool.h"

namespace frana {
namespace {

// A step has a dozen short loops: waking a sleeping thread for each would cost more than the loops. Threads
// therefore look again this many times (some tens of microseconds) before they sleep.
// Where there are more threads than processors, looking only takes the processor from the thread that is waited for.
int looks_before_sleep(int threads) {
    constexpr int k_looks = 4000;
    return threads <= static_cast<int>(std::thread::hardware_concurrency()) ? k_looks : 0;
}

inline void pause() noexcept {
#if defined(__x86_64__)
    __builtin_ia32_pause();
#endif
}

}  // namespace

ThreadPool::ThreadPool(int threads) : looks_(looks_before_sleep(threads)) {
    for (int i = 1; i < threads; ++i) workers_.emplace_back([this] { serve(); });
}

ThreadPool::~ThreadPool() {
    stop_.store(true);
    epoch_.fetch_add(1, std::memory_order_release);
    epoch_.notify_all();
    for (std::thread& worker : workers_) worker.join();
}

void ThreadPool::start(std::size_t count, Call call, const void* task) {
    count_ = count;
    call_ = call;
    task_ = task;
    next_.store(0, std::memory_order_relaxed);
    busy_.store(static_cast<int>(workers_.size()), std::memory_order_relaxed);
    epoch_.fetch_add(1, std::memory_order_release);
    epoch_.notify_all();
    work();
    int looks = 0;
    for (int left = busy_.load(std::memory_order_acquire); left != 0;
         left = busy_.load(std::memory_order_acquire)) {
        if (++looks < looks_) {
            pause();
        } else {
            busy_.wait(left, std::memory_order_acquire);
        }
    }
}

void ThreadPool::work() {
    for (std::size_t i = next_.fetch_add(1, std::memory_order_relaxed); i < count_;
         i = next_.fetch_add(1, std::memory_order_relaxed)) {
        call_(task_, i);
    }
}

void ThreadPool::serve() {
    std::uint32_t seen = 0;
    while (true) {
        int looks = 0;
        while (epoch_.load(std::memory_order_acquire) == seen) {
            if (++looks < looks_) {
                pause();
            } else {
                epoch_.wait(seen, std::memory_order_acquire);
            }
        }
        ++seen;
        if (stop_.load()) return;
        work();
        if (busy_.fetch_sub(1, std::memory_order_acq_rel) == 1) busy_.notify_one();
    }
}

}  // namespace frana
