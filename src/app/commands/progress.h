// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/process/status_line.h"
#include "simulation/result.h"

namespace frana::app {

/// Shows step, simulated time and time left of a run.
class ProgressReporter {
  public:
    explicit ProgressReporter(bool quiet) : line_(quiet) {}
    void show(const Progress& progress);
    /// Clears the updated line.
    void finish() { line_.finish(); }

  private:
    StatusLine line_;
    double begin_ = -1;  ///< simulated time when first shown; less than 0: not yet [s]
};

}  // namespace frana::app
