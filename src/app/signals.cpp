// SPDX-License-Identifier: Apache-2.0
#include "app/signals.h"

#include <csignal>

namespace frana::app {
namespace {

// The only variable of the program outside functions: a signal handler can reach nothing else.
volatile std::sig_atomic_t received = 0;

extern "C" void take_note(int signal_number) {
    received = signal_number;
    std::signal(signal_number, SIG_DFL);
}

}  // namespace

void ignore_file_signals() {
    std::signal(SIGXFSZ, SIG_IGN);
    std::signal(SIGPIPE, SIG_IGN);
}

void catch_stop_signals() {
    std::signal(SIGINT, take_note);
    std::signal(SIGTERM, take_note);
}

int stop_signal() noexcept {
    return received;
}

}  // namespace frana::app
