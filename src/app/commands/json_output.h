// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/commands/commands.h"
#include "core/error.h"
#include "core/json.h"

namespace frana::app {

// The one document that --json writes to stdout; share/doc/scripts.md explains its members.

/// Returns its beginning: program, version, command, exit_code (0).
Json document_of(const std::string& command);

/// Returns the document of a failed command, with each problem in its parts.
std::string error_document(const Arguments& words, ExitCode code, const std::vector<Problem>& problems);

/// Whether the words of the command line ask for the document.
bool wants_document(const Arguments& words);

/// Returns the rows of a table of frana, each with the titles as names; a number becomes one, an empty cell null.
Json rows_of(const std::string& csv);

void print_document(const Json& document);

}  // namespace frana::app
