// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/error.h"

namespace frana::app {

/// For commands that write into a folder which need not be a result: they replace what frana wrote there, and nothing
/// else. What it wrote stands in the manifest of the result that the folder is or lies in, or in one of its own.

/// Adds a problem for a folder that is, or lies in, a result other than those that are read, for that one's
/// files would become another's; and for every file to be written that is there already where nothing lists
/// frana's files: it is somebody else's. Where they are listed, keep_changed_files() keeps what is not as it
/// was written.
/// @param where the option that says the place
/// @param reads results, or files in them, that the command reads and may write into
void check_own(const std::string& folder, const std::vector<std::string>& files, const std::string& where,
               const std::vector<std::string>& reads, Problems& problems);

/// Before the first of the files is written: a folder that nothing lists gets a list, by which what is there after a
/// kill is known again, and what was changed since is kept; record_files() lists them in the end. Throws
/// Error(environment).
void begin_own(const std::string& folder, const std::vector<std::string>& files);

/// Removes what frana wrote of a series into a folder (frames of a longer animation) and does not write again:
/// files that are listed, are as listed and are not among these. `belongs` knows the series by names in the
/// folder. Throws Error(environment).
void clear_own(const std::string& folder, const std::vector<std::string>& files,
               const std::function<bool(const std::string& name)>& belongs);

}  // namespace frana::app
