// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "app/commands/command_line.h"

namespace frana::app {

/// Returns one line for each library that can change a result or a file: "GDAL 3.6.2".
std::string library_versions();

/// A program of frana from its first call to its exit code: prepares the process, calls `run` with the words of the
/// command line but --allow-network, and reports what it throws.
int run_program(const Arguments& arguments, int (*run)(Arguments));

}  // namespace frana::app
