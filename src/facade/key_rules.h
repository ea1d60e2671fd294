// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "core/error.h"

namespace frana::facade {

/// Returns why a key with this value is not for a scene in memory: an unknown key, a value that is not allowed, a file,
/// or what concerns only the files that the program reads and writes. None: it is.
std::optional<frana::Problem> problem_of_setting(const std::string& key, const std::string& value);

}  // namespace frana::facade
