// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace frana::app {

/// Exit codes of the program; a stop by a signal adds the signal's number to `signal`.
enum class ExitCode { done = 0, input = 2, numerical = 3, environment = 4, signal = 128 };

using Arguments = std::vector<std::string>;

// Each command takes the arguments after its name, prints the requested output to stdout and returns the exit code. All
// throw Error.
int cmd_run(const Arguments& arguments);
int cmd_check(const Arguments& arguments);
int cmd_render(const Arguments& arguments);
int cmd_compare(const Arguments& arguments);
int cmd_converge(const Arguments& arguments);
int cmd_ensemble(const Arguments& arguments);
int cmd_batch(const Arguments& arguments);
int cmd_calibrate(const Arguments& arguments);
int cmd_bench(const Arguments& arguments);
int cmd_params(const Arguments& arguments);
int cmd_materials(const Arguments& arguments);

}  // namespace frana::app
