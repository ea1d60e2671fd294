// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "core/words/sentence.h"

namespace frana::app {

/// Returns a warning that names the letters on the pictures drawn since the last call for which no font is installed;
/// none: there are none.
std::optional<Sentence> letter_warning();

}  // namespace frana::app
