// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "params/keys/parameter.h"

namespace frana {

/// The keys of [output] that say how maps, views and charts are made.
void add_pictures(std::vector<Parameter>& list);

}  // namespace frana
