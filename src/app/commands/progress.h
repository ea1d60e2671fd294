// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/process/stopwatch.h"
#include "simulation/result.h"

namespace frana::app {

/// Shows step, simulated time and time left on stderr: one updated line on a terminal, else a line every ten seconds.
class ProgressReporter {
  public:
    explicit ProgressReporter(bool quiet);
    void show(const Progress& progress);
    /// Clears the updated line.
    void finish();

  private:
    bool quiet_;
    bool terminal_;
    bool line_is_open_ = false;
    double next_ = 0;    ///< seconds after the start
    double begin_ = -1;  ///< simulated time when first shown; less than 0: not yet [s]
    Stopwatch since_start_;
};

}  // namespace frana::app
