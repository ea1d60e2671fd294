// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

namespace frana::test {

/// Every file below a folder by its path, with its lasting bytes without warnings; folders have "/" after their names
/// and no content.
using FolderState = std::map<std::string, std::string>;
FolderState state_of(const std::string& folder);

/// The part whose paths satisfy a predicate.
template <class Wanted>
FolderState part_of(const FolderState& state, const Wanted& wanted) {
    FolderState part;
    for (const auto& [path, content] : state)
        if (wanted(path)) part.emplace(path, content);
    return part;
}

/// Returns what is missing, new or changed, as text; empty: nothing.
std::vector<std::string> differences(const FolderState& expected, const FolderState& found);
std::string in_lines(const std::vector<std::string>& texts);

/// Returns rasters below a folder (GeoTIFF) that do not open or cannot be read to the last cell.
std::vector<std::string> broken_rasters(const std::string& folder);

}  // namespace frana::test
