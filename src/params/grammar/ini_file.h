// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace frana {

/// One "key = value" of an INI file, with the section in the name.
struct IniEntry {
    std::string name;   ///< "section.key"; only the key before the first section
    std::string value;  ///< trimmed; may be empty
};

/// Returns the entries of an INI file in their order, duplicates included, uninterpreted. '#' starts a comment. Throws
/// Error(input) if the file cannot be read or a line is neither a section, an entry nor a comment.
std::vector<IniEntry> read_ini(const std::string& path);

}  // namespace frana
