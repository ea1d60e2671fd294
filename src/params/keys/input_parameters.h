// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "params/keys/parameter.h"

namespace frana {

/// Keys that specify how to read an input file that does not specify it itself, each at the end of its section.
void add_input_parameters(std::vector<Parameter>& list);

}  // namespace frana
