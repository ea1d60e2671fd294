// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace frana::app {

/// Writes a text aside and renames it, so that the file is complete or unchanged. Throws Error(environment).
void write_text_file(const std::string& path, const std::string& text);

/// Returns the bytes of a file; of one that cannot be read those before the error, of a missing one none.
std::string read_text_file(const std::string& path);

}  // namespace frana::app
