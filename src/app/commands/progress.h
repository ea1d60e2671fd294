// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/process/terminal.h"
#include "simulation/result.h"

namespace frana::app {

/// Shows step, simulated time and time left of a run: for a person, or as lines of JSON for a program
/// (share/doc/scripts.md).
class ProgressReporter {
  public:
    /// @param json lines of JSON, also if `quiet`
    explicit ProgressReporter(bool quiet, bool json = false) : line_(quiet || json), json_(json) {}
    void show(const Progress& progress);
    /// Clears the updated line; the computation has ended, files are written next.
    void finish();

  private:
    StatusLine line_;
    bool json_;
    double next_ = 0;    ///< of the lines of JSON, seconds after the start
    double begin_ = -1;  ///< simulated time when first shown; less than 0: not yet [s]
};

}  // namespace frana::app
