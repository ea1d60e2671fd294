// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace frana::app {

/// A file beyond the process's size limit, or a closed pipe, is then an error like a full disk, not the end.
void ignore_file_signals();

/// From now on SIGINT and SIGTERM only take note, so that a run can stop in order; a second one ends at once.
void catch_stop_signals();

/// The signal that came (2 or 15), 0 while none has.
int stop_signal() noexcept;

}  // namespace frana::app
