// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/commands/commands.h"

namespace frana::app {

/// A program of frana from its first call to its exit code: prepares the process, calls `run` with the words of the
/// command line but --allow-network, and reports what it throws.
int run_program(const Arguments& arguments, int (*run)(Arguments));

}  // namespace frana::app
