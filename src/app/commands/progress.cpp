// SPDX-License-Identifier: Apache-2.0
#include "app/commands/progress.h"

#include <cstdio>
#include <string>

namespace frana::app {
namespace {

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

void ProgressReporter::show(const Progress& progress) {
    if (begin_ < 0) begin_ = progress.time;
    if (line_.is_due()) line_.show(line_of(progress, begin_, line_.seconds()));
}

}  // namespace frana::app
