// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace frana::app {

/// Makes a file beyond the process's size limit, or a closed pipe, an error like a full disk instead of the end of the
/// process.
void ignore_file_signals();

/// Opens those of stdin, stdout and stderr that were closed before the program began on /dev/null: otherwise the next
/// opened file would get one of their numbers, and messages would be written into it.
void fill_standard_streams();

/// From now on SIGINT, SIGTERM and SIGHUP are only recorded, so that a run can stop in order; a second one ends the
/// process at once. SIGHUP remains ignored if it was at the start (nohup).
void catch_stop_signals();

/// Returns the signal received (1, 2 or 15); 0 if none.
int stop_signal() noexcept;

}  // namespace frana::app
