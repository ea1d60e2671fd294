// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "params/keys/parameter.h"

namespace frana {

// Surveyed data of the site: the ground, the release and inflow, and values by place.

void add_terrain(std::vector<Parameter>& list);
void add_release(std::vector<Parameter>& list);
void add_inflow(std::vector<Parameter>& list);
void add_zones(std::vector<Parameter>& list);

}  // namespace frana
