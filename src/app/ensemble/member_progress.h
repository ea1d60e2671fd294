// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <mutex>

#include "app/process/stopwatch.h"

namespace frana::app {

/// Shows how many members have run on stderr: an updated line on a terminal, else a line every ten seconds. May be
/// called from several threads.
class MemberProgress {
  public:
    /// @param done members that ran in earlier sessions
    MemberProgress(std::size_t done, std::size_t total, bool quiet);
    void add_member();
    /// Clears the updated line.
    void finish();

  private:
    std::mutex mutex_;
    std::size_t done_, total_, here_ = 0;
    bool quiet_, terminal_, line_is_open_ = false;
    double next_;  ///< seconds after the start
    Stopwatch since_start_;
};

}  // namespace frana::app
