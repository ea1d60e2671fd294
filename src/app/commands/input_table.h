// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "app/input/prepare.h"

namespace frana::app {

/// Every input as frana understood it, and the working grid it was brought onto, as one table.
/// `memory_bytes`: what a run on that grid takes.
std::string input_table(const Prepared& prepared, std::int64_t memory_bytes);

}  // namespace frana::app
