// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "app/process/status_line.h"

namespace frana::app {

/// Shows how many members have run and the time left.
class MemberProgress {
  public:
    /// @param done members that ran before the study was resumed
    MemberProgress(std::size_t done, std::size_t total, bool quiet);
    void add_member();
    /// Clears the updated line.
    void finish();

  private:
    std::size_t done_, total_, here_ = 0;
    StatusLine line_;
};

}  // namespace frana::app
