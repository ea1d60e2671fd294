// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

#include "app/process/stopwatch.h"

namespace frana::app {

/// A line on stderr that says how far a command is: updated in place on a terminal, else a new line every ten seconds.
class StatusLine {
  public:
    explicit StatusLine(bool quiet);
    /// Whether the next line is to be shown now; asked often, so that lines are made only then.
    [[nodiscard]] bool is_due() const;
    void show(const std::string& line);
    /// Clears the updated line.
    void finish();
    /// Since the start [s].
    [[nodiscard]] double seconds() const { return since_start_.seconds(); }

  private:
    bool quiet_, terminal_, is_open_ = false;
    double next_;  ///< seconds after the start
    Stopwatch since_start_;
};

/// A width at which nothing is wrapped.
inline constexpr std::size_t k_any_width = 100'000;

/// Returns the columns that a text on stdout may take: those of the terminal, or of COLUMNS if the terminal does not
/// tell, or 80; `k_any_width` where stdout is no terminal, so that files and pipes do not depend on a window.
std::size_t output_width();

}  // namespace frana::app
