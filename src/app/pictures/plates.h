// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/pictures/result_reader.h"

namespace frana::app {

/// The files that its plates may become in a folder.
std::vector<std::string> plate_files(const MapSource& source, const std::string& folder);

/// The publication's plates of a result, drawn into a folder that exists: the initial state (Figure 5), snapshots of
/// depth (6) and of the normal stress on the bed (7: density times gravity times depth, hydrostatic; not of the
/// structured model, whose density differs from place to place), the profile beside the comparison with the scar (8,
/// only where there is a comparison). Returns the names of the files. Throws Error(input) where the result has no
/// frames, or does not tell density and gravity.
std::vector<std::string> draw_plates(const ResultReader& result, const MapSource& source, const std::string& folder);

}  // namespace frana::app
