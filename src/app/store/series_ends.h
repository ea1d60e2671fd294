// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace frana::app {

/// Values of a run's series for maps.
struct SeriesEnds {
    double simulated_seconds = 0;
    double volume = 0;       ///< that entered [m3]
    double volume_left = 0;  ///< left through the edges of the domain [m3]
    double last_speed = 0;   ///< greatest speed at the end [m/s]
};

/// Reads the first and the last row of a timeseries.csv. Throws Error(input), naming the file and the line, if it has
/// no rows, lacks a column, or is truncated.
SeriesEnds read_series_ends(const std::string& path);

}  // namespace frana::app
