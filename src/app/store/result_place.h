// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/error.h"

namespace frana::app {

/// Where a result directory really lies: absolute, without trailing slashes, and where the name is a symbolic
/// link what it points to, for the result is built beside that and the link stays one.
std::string result_path(const std::string& directory);

/// Looks, before anything is computed, whether a result can be written to a directory. Adds to `problems`: an
/// existing result without leave to overwrite it, a folder that is no result (never overwritten), inputs
/// inside the folder that would be replaced, a place that is a mount point or has too long a name. Returns
/// what the environment does not allow: a place that is another owner's, or cannot be written.
[[nodiscard]] std::optional<Problem> check_result_directory(const std::string& directory, bool overwrite,
                                                            const std::vector<std::string>& inputs,
                                                            const std::string& where, Problems& problems);

/// Whether there is anything in a folder; one that cannot be read has something.
bool has_files(const std::string& folder);

}  // namespace frana::app
