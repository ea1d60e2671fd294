// SPDX-License-Identifier: Apache-2.0
#include "app/ensemble/member_progress.h"

#include <unistd.h>

#include <cstdio>
#include <iostream>
#include <string>

namespace frana::app {
namespace {

constexpr double k_live_interval = 0.2, k_plain_interval = 10;  // [s], as of single runs

std::string duration_text(double seconds) {
    char text[40];
    if (seconds < 120)
        std::snprintf(text, sizeof text, "%.0f s", seconds);
    else if (seconds < 7200)
        std::snprintf(text, sizeof text, "%.0f min", seconds / 60);
    else
        std::snprintf(text, sizeof text, "%.1f h", seconds / 3600);
    return text;
}

}  // namespace

MemberProgress::MemberProgress(std::size_t done, std::size_t total, bool quiet)
    : done_(done),
      total_(total),
      quiet_(quiet),
      terminal_(::isatty(STDERR_FILENO) == 1),
      next_(terminal_ ? 0 : k_plain_interval) {}

void MemberProgress::add_member() {
    const std::lock_guard lock(mutex_);
    ++done_;
    ++here_;
    const double elapsed = since_start_.seconds();
    if (quiet_ || elapsed < next_) return;
    next_ = elapsed + (terminal_ ? k_live_interval : k_plain_interval);
    const double left = elapsed / static_cast<double>(here_) * static_cast<double>(total_ - done_);
    const std::string line = "member " + std::to_string(done_) + " of at most " + std::to_string(total_) + "  " +
                             duration_text(left) + " left at most";
    if (terminal_) {
        std::cerr << '\r' << line << "\033[K" << std::flush;
        line_is_open_ = true;
    } else {
        std::cerr << "frana: " << line << '\n';
    }
}

void MemberProgress::finish() {
    const std::lock_guard lock(mutex_);
    if (line_is_open_) std::cerr << "\r\033[K" << std::flush;
    line_is_open_ = false;
}

}  // namespace frana::app
