// SPDX-License-Identifier: Apache-2.0
#include "app/process/terminal.h"

#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <iostream>

namespace frana::app {
namespace {

// The only variable of the program outside functions: a signal handler can access nothing else.
volatile std::sig_atomic_t received = 0;

extern "C" void read_note(int signal_number) {
    if (received == 0) received = signal_number;
    // Any further signal ends the program; ignored signals remain ignored.
    for (const int each : {SIGINT, SIGTERM, SIGHUP})
        if (std::signal(each, SIG_DFL) == SIG_IGN) std::signal(each, SIG_IGN);
}

}  // namespace

void ignore_file_signals() {
    std::signal(SIGXFSZ, SIG_IGN);
    std::signal(SIGPIPE, SIG_IGN);
}

void fill_standard_streams() {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        // open() returns the lowest free number, which is this one. What is written to stdout then fails: it is lost.
        if (::fcntl(stream, F_GETFD) < 0 &&
            ::open("/dev/null", stream == STDERR_FILENO ? O_WRONLY : O_RDONLY) != stream)
            std::abort();
    }
}

void catch_stop_signals() {
    std::signal(SIGINT, read_note);
    std::signal(SIGTERM, read_note);
    // A process started with nohup survives its terminal.
    if (std::signal(SIGHUP, read_note) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
}

int stop_signal() noexcept {
    return received;
}

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
