// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/geometry.h"
#include "core/raster.h"

namespace frana {

/// The line a flow took from one place to another: the path over the cells of `depth` [m] for which the sum
/// of (length / depth) is least (Dijkstra 1959, eight neighbours), so that it keeps to the deepest channel;
/// then straightened to within one cell (Douglas and Peucker 1973), so that its length is not that of a
/// staircase. A cell without flow costs as much as one of a hundredth of the shallowest flow: a path leaves
/// the flow only where it must. Both places must lie on the grid. Throws Error(input) otherwise.
Polyline flow_path(const Raster& depth, Point from, Point to);

/// Length of a line [m].
double length(const Polyline& line);

/// Distance along a line of its place nearest to a point [m]: the point's path coordinate s.
double path_coordinate(const Polyline& line, Point point);

/// The greatest path coordinate of the cells of a mask (not 0, not NaN): run-out along a path [m]; 0 where
/// the mask is empty.
double runout_along(const Polyline& path, const Raster& mask);

/// A place on a line.
struct Station {
    double distance = 0;  ///< from the line's start [m]
    Point place;
};

/// Places at equal distances of at most `spacing` [m] along a line, its vertices included, start and end too.
std::vector<Station> stations(const Polyline& line, double spacing);

/// The value of the cell that a place lies in; NaN outside.
double cell_value(const Raster& raster, Point place) noexcept;

}  // namespace frana
