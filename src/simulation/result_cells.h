// SPDX-License-Identifier: Apache-2.0
// Corrections of the rasters of a run before they are returned.
#pragma once

#include <cmath>
#include <utility>

#include "core/raster.h"
#include "mpm/node_grid.h"
#include "simulation/scene.h"

namespace frana {

/// A wall's cell contains no material, though the nodes there gather a fraction of particles beside it.
inline void hide_walls(const Scene& scene, Raster& raster) {
    if (!scene.walls || raster.values.empty()) return;
    scene.walls->values.for_each_stored([&](std::size_t cell, double wall) {
        if (wall == 1 && !std::isnan(std::as_const(raster).values[cell])) raster.values[cell] = k_no_data;
    });
}

/// Returns the dynamic pressure [kPa] of a speed [m/s].
inline Raster pressure_kpa(const Raster& speed, double density) {
    Raster pressure = speed;
    pressure.values.change_each_stored([&](std::size_t, double& value) { value = density * value * value / 1000; });
    return pressure;
}

/// Removes non-finite values from the maps of a run that ended with some.
inline void hide_non_finite(Raster& raster) {
    raster.values.change_each_stored([](std::size_t, double& value) {
        if (!std::isfinite(value)) value = k_no_data;
    });
}

/// For terrain read on demand: reads the elevations under all cells that the nodes have covered.
inline void read_ground_under(const NodeGrid& nodes, const Raster& terrain, const Raster& bed) {
    if (!nodes.is_on_demand()) return;
    nodes.for_each_covered_run([&](std::int64_t j, std::int64_t i0, std::int64_t i1) {
        for (const std::int64_t column : {i0, i1 - 1}) {
            static_cast<void>(bed.at(bed.grid.rows - 1 - j, column));
            static_cast<void>(terrain.at(terrain.grid.rows - 1 - j, column));
        }
    });
}

}  // namespace frana
