// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "analysis/ground_statistics.h"
#include "app/text/run_log.h"
#include "core/raster.h"
#include "gis/vector/exposed_in.h"
#include "simulation/scene.h"

namespace frana::app {

/// Warns of exposed features of which the map will say nothing: off the map, without geometry, or where the terrain has
/// no elevation.
/// @param map the ground that is computed
/// @param terrain null, or in tiles: not looked at
void warn_of_unknown_exposure(const gis::ExposedLayer& layer, const Bounds& map, const Raster* terrain, RunLog& log);

/// Returns "412 to 780 m, slope 27 degrees on average, 51 at most".
Sentence ground_sentence(const GroundStatistics& ground);

/// Statistics of the DTM under the outlines of the release; none if nothing is released.
std::optional<GroundStatistics> ground_of_release(const Scene& scene);

/// The unit in which elevations were read.
struct UsedUnit {
    std::string name;         ///< "foot"
    double metres = 1;        ///< per unit
    bool is_of_file = false;  ///< else the user's choice, or assumed
};

/// Warns of ground on which landslides do not start, or over which they do not move: steeper or flatter than in nature
/// where elevations are in another unit than eastings, or the layers do not belong together.
void warn_of_release_ground(const GroundStatistics& ground, RunLog& log);
/// Warns of a release on ground that is nowhere as steep as the slope up to which friction holds it: nothing but its
/// edges can move. Elevations that are too low for their eastings look like this, as metres read as feet.
/// @param friction tangent of that slope; 0: not known
void warn_of_held_release(const GroundStatistics& ground, double friction, const UsedUnit& unit, RunLog& log);
void warn_of_path_ground(const GroundStatistics& ground, RunLog& log);

}  // namespace frana::app
