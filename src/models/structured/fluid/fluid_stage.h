// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "models/structured/fluid/fluid_state.h"

namespace frana::structured {

/// Results of one tile in a stage.
struct TileReport {
    double lowest = 0;     ///< least depth after the stage [m]; negative: the step was too long
    double left = 0;       ///< discharge through open edges [m3/s]
    double into_gaps = 0;  ///< of which into cells without terrain [m3/s]
    std::int64_t non_finite = 0;
    std::int64_t wet_cells = 0;
};

/// One stage of Heun's method in one tile:  to = fraction (from + dt R(from)) + (1 - fraction) before.
/// Reads `from` in the tile and two cells around, `before` in the tile (equal to `from` if fraction is 1); writes `to`
/// in the tile. Discharge below the dry depth becomes zero.
TileReport fluid_stage(const NodeRange& range, const NodeGrid& nodes, const FluidLaws& laws, const FluidState& state,
                       const double* solid_depth, double dt, double fraction, const FluidFields& from,
                       const FluidFields& before, FluidFields& to);

}  // namespace frana::structured
