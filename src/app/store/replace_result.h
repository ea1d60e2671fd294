// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/text/run_log.h"
#include "core/error.h"

namespace frana::app {

/// Takes an older result apart after a new one has taken its place. Only files that the older one's manifest
/// lists, and that still are as it says, are removed. All else is the user's and moves into the new result:
/// under its own name, or as NAME.kept-1.EXTENSION where it is a changed file of frana's, where the name is
/// taken, or where it lies beside a raster or vector file and would be read with the new one of that name
/// (NAME.tif.aux.xml, NAME.gpkg-wal). An older result without a manifest is kept whole, beside the new one as
/// RESULT.kept-1. What is not where it was is told in the log. Returns what could not be moved or removed; it
/// is still where it was.
std::vector<Problem> replace_result(const std::string& older, const std::string& result, RunLog& log);

/// Before files are written once more: those that lie in a result, are there, and are not as its manifest
/// says, are the user's and get such a name. Told on stderr. Files outside results are left to be replaced.
/// Throws Error(environment).
void keep_changed_files(const std::vector<std::string>& paths);

}  // namespace frana::app
