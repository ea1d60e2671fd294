// SPDX-License-Identifier: Apache-2.0
#include "app/commands/progress.h"

#include <unistd.h>

#include <cstdio>
#include <iostream>
#include <string>

namespace frana::app {
namespace {

constexpr double k_live_interval = 0.2;    // fast enough to look continuous
constexpr double k_plain_interval = 10.0;  // contract: a line every ten seconds

std::string line_of(const Progress& progress, double begin, double elapsed) {
    char text[160];
    std::snprintf(text, sizeof text, "step %lld  %.2f of at most %.6g s simulated  %lld particles",
                  static_cast<long long>(progress.step), progress.time, progress.end,
                  static_cast<long long>(progress.particles));
    std::string line = text;
    if (progress.time > begin && elapsed > 1) {
        // The flow may come to rest earlier: this is the maximum at the present rate.
        std::snprintf(text, sizeof text, "  %.0f s left at most",
                      elapsed * (progress.end - progress.time) / (progress.time - begin));
        line += text;
    }
    return line;
}

}  // namespace

ProgressReporter::ProgressReporter(bool quiet)
    : quiet_(quiet), terminal_(::isatty(STDERR_FILENO) == 1), next_(terminal_ ? 0 : k_plain_interval) {}

void ProgressReporter::show(const Progress& progress) {
    if (quiet_) return;
    if (begin_ < 0) begin_ = progress.time;
    const double elapsed = since_start_.seconds();
    if (elapsed < next_) return;
    next_ = elapsed + (terminal_ ? k_live_interval : k_plain_interval);
    const std::string line = line_of(progress, begin_, elapsed);
    if (terminal_) {
        std::cerr << '\r' << line << "\033[K" << std::flush;
        line_is_open_ = true;
    } else {
        std::cerr << "frana: " << line << '\n';
    }
}

void ProgressReporter::finish() {
    if (line_is_open_) std::cerr << "\r\033[K" << std::flush;
    line_is_open_ = false;
}

}  // namespace frana::app
