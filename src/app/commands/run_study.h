// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "app/commands/commands.h"

namespace frana::app {

/// A command that runs many members and writes what they say together.
struct StudyKind {
    const char *command, *operand, *meaning;
    const char* ending;                                     ///< of the default result's name: "-ensemble"
    const char* what;                                       ///< it is called in sentences: "study"
    void (*check_file)(const std::string& file) = nullptr;  ///< throws Error(input) for the file of another command
};

/// Runs it. Returns the exit code; throws Error.
int run_study(const StudyKind& kind, const Arguments& arguments);

}  // namespace frana::app
