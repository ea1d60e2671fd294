// SPDX-License-Identifier: Apache-2.0
#pragma once

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

}  // namespace frana::app
