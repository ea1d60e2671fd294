// SPDX-License-Identifier: Apache-2.0
#include "app/process/signals.h"

#include <fcntl.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <initializer_list>

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

}  // namespace frana::app
