// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace frana {

/// Whether a key is one of the twenty that nearly every scene states or asks for: `frana new` writes them, and
/// dialogues show them first. `frana params --json` marks them.
bool is_main_key(const std::string& name);

}  // namespace frana
