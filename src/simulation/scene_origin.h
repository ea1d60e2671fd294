// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "simulation/scene.h"

namespace frana {

/// Cell of a local origin; rows counted from the south.
struct OriginCell {
    std::int64_t column = 0, row = 0;
};

/// Sets the local origin to the cell that contains the south-western corner of all releases, inflows and initial fluid.
/// Results then do not depend on the extent of the grid beyond it.
void place_origin(Scene& scene);

/// Sets it to a cell of the grid. Throws Error(input) outside.
void put_origin(Scene& scene, OriginCell cell);

}  // namespace frana
