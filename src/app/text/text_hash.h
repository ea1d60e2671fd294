// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace frana::app {

/// Returns a name for a text that changes with every byte of it: its UUID of version 5 (SHA-1; RFC 4122) in the URL
/// namespace.
std::string text_hash(const std::string& text);

}  // namespace frana::app
