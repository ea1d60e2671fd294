// SPDX-License-Identifier: Apache-2.0
#include "core/team_watch.h"

#include <algorithm>

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

}  // namespace frana
