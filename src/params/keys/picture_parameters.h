// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "params/keys/parameter.h"

namespace frana {

/// Adds the keys of [output] for the appearance of maps, views and charts.
void add_pictures(std::vector<Parameter>& list);

}  // namespace frana
