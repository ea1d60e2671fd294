// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "bench/speed/speed.h"

namespace frana::bench {

/// Returns one run in one line.
std::string speed_line(const SpeedRow& row);

}  // namespace frana::bench
