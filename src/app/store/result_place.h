// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/error.h"

namespace frana::app {

/// Returns the real place of a result directory: absolute, without trailing slashes, and the target of a symbolic link,
/// since the result is built beside that and the link remains.
std::string result_path(const std::string& directory);

/// What a command may do with an older result: `unknown` to `frana check`, whose run is another command.
enum class Older { refused, replaced, unknown };

/// Checks, before anything is computed, whether a result can be written to a directory. Adds to `problems`: an existing
/// result without permission to overwrite it, a folder that is not a result, users' files in either or in the partial
/// folder (none is ever overwritten), inputs inside the folder, another run that is writing the result, a place that is
/// a mount point or has too long a name. Returns the problem of the environment: a place that has another owner, or
/// cannot be read or written.
[[nodiscard]] std::optional<Problem> check_result_directory(const std::string& directory, Older older,
                                                            const std::vector<std::string>& inputs,
                                                            const std::string& where, Problems& problems);

/// Another run is writing a result.
Problem other_run(const std::string& result);
/// Returns why a partial folder that no run has locked cannot be emptied; none: it can. Throws Error(environment).
std::optional<Problem> partial_problem(const std::string& partial);

/// Returns whether a folder has any entry; one that cannot be read counts as not empty.
bool has_files(const std::string& folder);

}  // namespace frana::app
