// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "analysis/separate_flows.h"
#include "core/raster.h"

namespace frana {

/// Run-out of one flow: from the highest point of the surface of its releases (of the bed it reached, where material
/// only flowed in) to the cell of its trace farthest from it in map view. Flows that meet are one.
struct Runout {
    double horizontal_m = 0;     ///< straight line in map view
    double drop_m = 0;           ///< surface at the top minus bed at the tip
    double reach_angle_deg = 0;  ///< atan(drop / horizontal), the angle of reach (Fahrboeschung)
    double path_m = 0;           ///< along the flow path from top to tip (flow_path); 0: not computed
    Point top;                   ///< map coordinates
    Point tip;
    double covered_area_m2 = 0;  ///< of the trace

    /// The angle along the path, which statistical methods (alpha-beta) use [degrees].
    [[nodiscard]] double path_angle_deg() const noexcept { return reach_angle(path_m); }
    /// Returns atan(drop / length) [degrees].
    [[nodiscard]] double reach_angle(double length_m) const noexcept {
        return std::atan2(drop_m, length_m) * 180 / std::numbers::pi;
    }
};

/// Run-outs by the number of the flow. `bed` [m] is the sliding surface, `release` the vertical thickness of the failed
/// mass [m] (positive: released), `trace` a mask of the area reached, all on the same cells; cells of none of the flows
/// do not count. A flow without trace has zero length. Throws Error(input) if the cells differ.
std::vector<Runout> runouts_by_flow(const SeparateFlows& flows, const Raster& bed, const Raster& release,
                                    const Raster& trace);

/// The same, the longest first; those without a trace are left out unless there is no other. Throws also if nothing is
/// released and nothing flows.
std::vector<Runout> runouts(const SeparateFlows& flows, const Raster& bed, const Raster& release, const Raster& trace);

}  // namespace frana
