// SPDX-License-Identifier: Apache-2.0
#include "app/process/status_line.h"

#include <unistd.h>

#include <iostream>

namespace frana::app {
namespace {

constexpr double k_live_interval = 0.2;    // fast enough to look continuous
constexpr double k_plain_interval = 10.0;  // contract: a line every ten seconds

}  // namespace

StatusLine::StatusLine(bool quiet)
    : quiet_(quiet), terminal_(::isatty(STDERR_FILENO) == 1), next_(terminal_ ? 0 : k_plain_interval) {}

bool StatusLine::is_due() const {
    return !quiet_ && seconds() >= next_;
}

void StatusLine::show(const std::string& line) {
    next_ = seconds() + (terminal_ ? k_live_interval : k_plain_interval);
    if (terminal_) {
        std::cerr << '\r' << line << "\033[K" << std::flush;
        is_open_ = true;
    } else {
        std::cerr << "frana: " << line << '\n';
    }
}

void StatusLine::finish() {
    if (is_open_) std::cerr << "\r\033[K" << std::flush;
    is_open_ = false;
}

}  // namespace frana::app
