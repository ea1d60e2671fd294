// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

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

}  // namespace frana
