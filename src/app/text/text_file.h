// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace frana::app {

/// Writes a text aside and renames it, so that the file is complete or unchanged. Throws Error(environment).
void write_text_file(const std::string& path, const std::string& text);

}  // namespace frana::app
