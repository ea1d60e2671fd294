// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "analysis/ground_statistics.h"
#include "app/input/prepare_release.h"
#include "app/text/run_log.h"
#include "core/raster.h"
#include "gis/vector/exposed_in.h"
#include "params/keys/scene_spec.h"
#include "simulation/result.h"
#include "simulation/scene.h"

namespace frana::app {

inline constexpr double k_thin_fraction =
    0.1;  ///< fraction of the volume that may be thinner than visible on maps or in outlines without a warning

/// Warns, before anything is computed, if maps and values, or outlines and run-out, omit a substantial part of a
/// release.
void warn_of_thin_release(const Raster& release, const Scene& scene, RunLog& log);

/// Returns the tangent of the slope up to which the bed's friction holds material everywhere; 0 where places differ,
/// and where no law at the bed resists with it: the structured model's fluid, RAMMS's yield term alone, laws of fluids.
double sure_friction(const SceneSpec& scene);

/// Checks that the release is on ground with data and has a valid thickness. Adds to `problems`: outlines outside the
/// DTM (both extents named), nodata under the release (cells named), negative or missing thickness (cells named).
void check_release(const SceneReading& reading, const TerrainInput& ground, const ReleaseInput& release, RunLog& log,
                   Problems& problems);

/// Returns the outlines of all areas together.
MultiPolygon all_outlines(const ReleaseInput& release);

/// Warns of an observed outline that is nearly the release: what is compared is all the ground that the flow covered,
/// while a scar in the geologists' sense is only the source. Both in the CRS of `grid`, whose cells are counted.
/// `where`: the outline's key.
void question_outline(const MultiPolygon& released, const MultiPolygon& outline, const GridSpec& grid,
                      const std::string& where, RunLog& log);

/// The pattern of a warning of which the least number is the worst.
inline constexpr const char* k_few_particles_warning = worded(
    "the run starts with {1} particles only: area and run-out change much with smaller cells; reduce "
    "terrain.cell-size, and see frana converge");

/// Warns of a release that no slope has, or that is too small for its cells.
/// @param release vertical thickness on the grid of `bed` [m]
/// @param particles at the start; 0: it fails later
void warn_of_release(const Scene& scene, RunLog& log);
/// The same of a release that was made.
void warn_of_release(const Raster& bed, const Raster& release, const std::vector<ReleasedArea>& areas,
                     std::int64_t particles, RunLog& log);

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
