// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "app/input/used_file.h"
#include "core/words/words.h"

namespace frana::app {

// What a report says of an input file, in its language; `frana check` says the same in English.

/// Returns "Release thickness (average)": what the file is for, and how a raster came to the working grid.
std::string role_in(const UsedFile& file, const Words& words);
/// Returns "1 polygon\n63 071 m²".
std::string content_in(const UsedFile& file, const Words& words);
/// Returns the operation from the file's CRS to the working CRS with its accuracy; empty for a file that has no CRS.
std::string operation_in(const UsedFile& file, const Words& words);

}  // namespace frana::app
