// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/pictures/result_reader.h"

namespace frana::app {

/// Returns the files that the plates may have in a folder.
std::vector<std::string> plate_files(const MapSource& source, const std::string& folder);

/// Draws the publication's plates of a result to an existing folder: the initial state (Figure 5), snapshots of depth
/// (6) and of the normal stress on the bed (7: density times gravity times depth, hydrostatic; not for the structured
/// model, whose density varies from place to place), the profile beside the comparison with the scar (8, only if there
/// is a comparison). Returns the names of the files. Throws Error(input) if the result has no frames, or no density and
/// gravity.
std::vector<std::string> draw_plates(const ResultReader& result, const MapSource& source, const std::string& folder);

}  // namespace frana::app
