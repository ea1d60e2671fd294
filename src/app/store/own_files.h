// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/error.h"

namespace frana::app {

/// For commands that write to a folder which need not be a result: they replace only files written by frana. These are
/// listed in the manifest of the result that is or contains the folder, or in one of the folder.

/// Adds a problem for a folder that is, or is in, a result other than those read, since files of different results
/// would mix; and for every output that exists in a folder without a list of frana's files, since it belongs to the
/// user. If there is a list, keep_changed_files() keeps those that were changed.
/// @param where the option that specifies the place
/// @param reads results, or files in them, that the command reads and may write into
void check_own(const std::string& folder, const std::vector<std::string>& files, const std::string& where,
               const std::vector<std::string>& reads, Problems& problems);

/// Call before the first of the files is written: creates a list in a folder without one, so that files are identified
/// after a kill and changed ones are kept; record_files() lists them at the end. Throws Error(environment).
void begin_own(const std::string& folder, const std::vector<std::string>& files);

/// Removes files of a series (frames of a longer animation) that frana wrote to a folder and does not rewrite: listed,
/// unchanged and not among these. `belongs` identifies the series by names in the folder. Throws Error(environment).
void clear_own(const std::string& folder, const std::vector<std::string>& files,
               const std::function<bool(const std::string& name)>& belongs);

}  // namespace frana::app
