// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "params/keys/parameter.h"

namespace frana {

/// Adds the keys of [structured].
void add_structured(std::vector<Parameter>& list);

}  // namespace frana
