// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace frana::app {

/// A file beyond the process's size limit, or a closed pipe, is then an error like a full disk, not the end.
void ignore_file_signals();

/// Opens those of stdin, stdout and stderr that were closed before the program began, on nothing: the next file opened
/// would else take a place among them, and messages would go into it.
void fill_standard_streams();

/// From now on SIGINT, SIGTERM and SIGHUP only take note, so that a run can stop in order; a second one ends at once.
/// SIGHUP stays ignored where whoever started the program wants that (nohup).
void catch_stop_signals();

/// The signal that came (1, 2 or 15), 0 while none has.
int stop_signal() noexcept;

}  // namespace frana::app
