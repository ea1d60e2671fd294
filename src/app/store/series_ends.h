// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace frana::app {

/// What maps say of a run's course.
struct SeriesEnds {
    double simulated_seconds = 0;
    double volume = 0;       ///< that came in [m3]
    double volume_left = 0;  ///< that left the computed ground [m3]
    double last_speed = 0;   ///< greatest speed at the end [m/s]
};

/// From the first and the last row of a timeseries.csv. Throws Error(input), naming the file and the line, where it has
/// no rows, lacks a column, or is cut off.
SeriesEnds read_series_ends(const std::string& path);

}  // namespace frana::app
