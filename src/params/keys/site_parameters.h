// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "params/keys/parameter.h"

namespace frana {

// What is surveyed on site: the ground, what fails or flows in, and where the ground differs.

void add_terrain(std::vector<Parameter>& list);
void add_release(std::vector<Parameter>& list);
void add_inflow(std::vector<Parameter>& list);
void add_zones(std::vector<Parameter>& list);

}  // namespace frana
