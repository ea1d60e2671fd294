// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "app/input/prepare_terrain.h"
#include "app/input/used_file.h"
#include "core/error.h"
#include "simulation/scene.h"

namespace frana::app {

/// Reads [inflow]: each line with its hydrograph. Adds every problem to `problems`; without terrain (null) files are
/// only checked. Adds the files read to `files`.
std::vector<Inflow> prepare_inflow(const SceneReading& reading, const TerrainInput* ground,
                                   std::vector<UsedFile>& files, Findings found, Problems& problems);

struct Hydrograph {
    std::vector<HydrographPoint> points;
    bool has_time_unit = false, has_discharge_unit = false, has_speed_unit = false;  ///< named by its column
};

/// Reads a hydrograph from a CSV with the columns time, discharge or volume (cumulative), and velocity; names may have
/// a unit after an underscore or in brackets, which is converted (time_min, discharge_l/s). Without a velocity material
/// crosses the line at the critical speed. Throws Error(input) with every problem: a missing column, an invalid number,
/// times that do not rise, a negative discharge or a decreasing volume, a discharge with speed zero.
Hydrograph read_hydrograph(const std::string& file, const Place& where, double gravity, double line_length);

struct RainTable {
    Rain rain;
    /// Of rain by place, a raster [mm/h] for each point of `rain`, until the time of the next one; empty: a dry spell.
    std::vector<std::string> rasters;
};
/// Reads rain from a CSV with the columns time and rain [mm/h], linear between its rows, or depth [mm], fallen since
/// the start, or raster, whose last row only ends the rain; with units as a hydrograph. Throws Error(input): as
/// read_hydrograph, and for rain that is not plausible.
RainTable read_rain(const std::string& file, const Place& where);

}  // namespace frana::app
