// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/scene.h"

namespace frana {

/// Puts the local origin into the cell that holds the south-western corner of all that is released, flows in or lies
/// there as fluid at the start. How far the grid reaches beyond it then changes no bit of a run.
void place_origin(Scene& scene);

}  // namespace frana
