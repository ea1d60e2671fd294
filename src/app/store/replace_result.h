// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/text/run_log.h"
#include "core/error.h"

namespace frana::app {

/// Removes an older result after a new one has replaced it. Only files listed in the older one's manifest and unchanged
/// are removed. All others belong to the user and are moved into the new result: under their own name, or as
/// NAME.kept-1.EXTENSION if changed files of frana, if the name is in use, or if they would be read together with a
/// raster or vector file of the new result (NAME.tif.aux.xml, NAME.gpkg-wal). An older result without a manifest is
/// kept whole, beside the new one as RESULT.kept-1. Moves are logged. Returns the files that could not be moved or
/// removed; they are still in their old place.
std::vector<Problem> replace_result(const std::string& older, const std::string& result, RunLog& log);

/// Called before files are rewritten: those that are in a result, exist, and differ from its manifest belong to the
/// user and get such a name. Reported on stderr. Files outside results may be replaced. Throws Error(environment).
void keep_changed_files(const std::vector<std::string>& paths);

}  // namespace frana::app
