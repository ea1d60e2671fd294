// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace frana::app {

/// Returns a name for a text that changes with every byte of it: its UUID of version 5 (SHA-1; RFC 4122) in the URL
/// namespace.
std::string text_hash(const std::string& text);

/// Returns a name no longer than `most` bytes: a longer one ends in eight digits of its hash instead, so that long
/// names with the same beginning differ.
std::string shortened_name(const std::string& name, std::size_t most = 100);

/// Returns file names for names of the user, one for each: letters, digits and hyphens are kept, all else becomes '_'.
/// All are different, also if case is ignored: names that would be equal get eight digits of their hash, one that
/// needed no change is kept. The same names give the same files in any order.
std::vector<std::string> file_stems(const std::vector<std::string>& names);

/// Writes a text aside and renames it, so that the file is complete or unchanged. Throws Error(environment).
void write_text_file(const std::string& path, const std::string& text);

/// Returns the bytes of a file; of one that cannot be read those before the error, of a missing one none.
std::string read_text_file(const std::string& path);

}  // namespace frana::app
