// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "app/commands/command_line.h"
#include "app/commands/commands.h"

namespace frana::app {

/// Runs the members of a study or region and writes what they say together. Returns the exit code; throws Error.
/// @param check_file throws Error(input) for the file of another command
int run_study(const CommandForm& form, void (*check_file)(const std::string& file), const Arguments& arguments);

}  // namespace frana::app
