// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace frana::app {

/// Returns the script that completes commands, options, keys and values in bash.
std::string bash_completion();
/// The same for zsh: a file `_frana` for its $fpath.
std::string zsh_completion();

}  // namespace frana::app
