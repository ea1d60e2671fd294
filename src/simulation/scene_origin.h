// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "simulation/scene.h"

namespace frana {

/// Cell of a local origin; rows counted from the south.
struct OriginCell {
    std::int64_t column = 0, row = 0;
};

/// Puts the local origin into the cell that holds the south-western corner of all that is released, flows in or lies
/// there as fluid at the start. How far the grid reaches beyond it then changes no bit of a run.
void place_origin(Scene& scene);

/// Puts it into a cell of the grid. Throws Error(input) outside.
void put_origin(Scene& scene, OriginCell cell);

}  // namespace frana
