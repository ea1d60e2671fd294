// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace frana {

/// One "key = value" of an INI file, with the section in the name.
struct IniEntry {
    std::string name;   ///< "section.key"; the key alone where no section came before it
    std::string value;  ///< trimmed; may be empty
};

/// The entries of an INI file in their order, duplicates kept, nothing interpreted. '#' starts a comment.
/// Throws Error(input) when the file cannot be read or a line is neither a section, an entry nor a comment.
std::vector<IniEntry> read_ini(const std::string& path);

}  // namespace frana
