// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "app/input/prepare.h"

namespace frana::app {

/// Returns every input as interpreted, and the working grid, as one table. `memory_bytes`: memory of a run on that
/// grid.
std::string input_table(const Prepared& prepared, std::int64_t memory_bytes);

}  // namespace frana::app
