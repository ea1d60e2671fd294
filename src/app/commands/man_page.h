// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/commands/commands.h"

namespace frana::app {

/// A manual page in roff.
struct ManPage {
    std::string name;  ///< "frana-run.1"
    std::string text;
};

/// Returns every page: frana(1), one per command, frana-scene(5) with every key.
std::vector<ManPage> man_pages();

}  // namespace frana::app
