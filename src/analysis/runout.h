// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "analysis/separate_flows.h"
#include "core/geometry.h"
#include "core/raster.h"

namespace frana {

/// Returns the path of a flow between two places: the path over the cells of `depth` [m] with the smallest sum of
/// (length / depth) (Dijkstra 1959, eight neighbours), so that it follows the deepest channel; then simplified to
/// within one cell (Douglas and Peucker 1973), so that its length is not that of steps along cells. A cell without flow
/// costs as much as one of a hundredth of the least depth: a path leaves the flow only where necessary. Throws
/// Error(input) if a place is not on the grid.
Polyline flow_path(const Raster& depth, Point from, Point to);

/// Returns the length of a line [m].
double length(const Polyline& line);

/// Returns the distance along a line of its point nearest to `point` [m]: the path coordinate s.
double path_coordinate(const Polyline& line, Point point);

/// Returns the greatest path coordinate of the cells of a mask (not 0, not NaN): run-out along a path [m]; 0 if the
/// mask is empty.
double runout_along(const Polyline& path, const Raster& mask);

/// A place on a line.
struct Station {
    double distance = 0;  ///< from the line's start [m]
    Point place;
};

/// Returns places at equal distances of at most `spacing` [m] along a line, including its vertices, start and end.
std::vector<Station> stations(const Polyline& line, double spacing);

/// Returns the value of the cell containing a place; NaN outside.
double cell_value(const Raster& raster, Point place);

/// Run-out of one flow: from the highest point of the surface of its releases (of the bed it reached, where material
/// only flowed in) to the cell of its trace farthest from it in map view. Flows that meet are one.
struct Runout {
    double horizontal_m = 0;     ///< straight line in map view
    double drop_m = 0;           ///< surface at the top minus bed at the tip
    double reach_angle_deg = 0;  ///< atan(drop / horizontal), the angle of reach (Fahrboeschung)
    double path_m = 0;           ///< along the flow path from top to tip (flow_path); 0: not computed
    double beta_deg = 0;         ///< from the top to the path's 10 degree point; 0: it has none (beta_of)
    Point top;                   ///< map coordinates
    Point tip;
    double covered_area_m2 = 0;  ///< of the trace

    /// The angle along the path, which statistical methods (alpha-beta) use [degrees].
    [[nodiscard]] double path_angle_deg() const noexcept { return reach_angle(path_m); }
    /// The angle along the path that snow avalanches are expected to reach, 0.96 beta - 1.4 with a standard deviation
    /// of k_alpha_deviation: after Lied and Bakkehoi 1980, J. Glaciol. 26, 165, as those quote it who use it in Norway
    /// [degrees].
    [[nodiscard]] double alpha_deg() const noexcept { return 0.96 * beta_deg - 1.4; }
    static constexpr double k_alpha_deviation = 2.3;
    /// Returns atan(drop / length) [degrees].
    [[nodiscard]] double reach_angle(double length_m) const noexcept {
        return std::atan2(drop_m, length_m) * 180 / std::numbers::pi;
    }
};

/// Returns the angle from a path's start, at an elevation [m], to its 10 degree point [degrees]: the first from which
/// the bed falls by less than 10 degrees on the next 30 m, or three cells. 0: there is none.
double beta_of(const Polyline& path, const Raster& bed, double top);

/// Run-outs by the number of the flow. `bed` [m] is the sliding surface, `release` the vertical thickness of the failed
/// mass [m] (positive: released), `trace` a mask of the area reached, all on the same cells; cells of none of the flows
/// do not count. A flow without trace has zero length. Throws Error(input) if the cells differ.
std::vector<Runout> runouts_by_flow(const SeparateFlows& flows, const Raster& bed, const Raster& release,
                                    const Raster& trace);

/// The same, the longest first; those without a trace are left out unless there is no other. Throws also if nothing is
/// released and nothing flows.
std::vector<Runout> runouts(const SeparateFlows& flows, const Raster& bed, const Raster& release, const Raster& trace);

}  // namespace frana
