// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "params/keys/parameter.h"

namespace frana {

/// Adds the keys of [material].
void add_material(std::vector<Parameter>& list);
/// Adds the keys of [entrainment].
void add_entrainment(std::vector<Parameter>& list);

}  // namespace frana
