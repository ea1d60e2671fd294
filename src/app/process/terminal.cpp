// SPDX-License-Identifier: Apache-2.0
#include "app/process/terminal.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdlib>
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

std::size_t output_width() {
    constexpr std::size_t k_usual = 80;
    if (::isatty(STDOUT_FILENO) != 1) return k_any_width;
    winsize size{};
    if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) return size.ws_col;
    const char* const columns = std::getenv("COLUMNS");
    const long given = columns != nullptr ? std::strtol(columns, nullptr, 10) : 0;
    return given > 0 ? static_cast<std::size_t>(given) : k_usual;
}

}  // namespace frana::app
