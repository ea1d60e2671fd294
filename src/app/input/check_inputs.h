// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "analysis/ground_statistics.h"
#include "app/input/prepare.h"
#include "core/error.h"
#include "core/raster.h"
#include "core/words/words.h"
#include "gis/vector/vector_in.h"
#include "params/keys/scene_spec.h"
#include "simulation/result.h"
#include "simulation/scene.h"

namespace frana::app {

/// Told of a volume that differs from outline times thickness by a power of ten.
inline constexpr const char* k_volume_warning =
    worded("release.volume is {1} times outline x thickness: is its unit m3?");

/// Checks that the release is on ground with data and has a valid thickness. Adds to `problems`: outlines outside the
/// DTM (both extents named), nodata under the release (cells named), negative or missing thickness (cells named).
void check_release(const SceneReading& reading, const TerrainInput& ground, const ReleaseInput& release, Findings found,
                   Problems& problems);

/// Returns the outlines of all areas together.
MultiPolygon all_outlines(const ReleaseInput& release);

/// Warns of an observed outline that is nearly the release: what is compared is all the ground that the flow covered,
/// while a scar in the geologists' sense is only the source. Both in the CRS of `grid`, whose cells are counted.
/// `where`: the outline's key.
void question_outline(const MultiPolygon& released, const MultiPolygon& outline, const GridSpec& grid,
                      const Place& where, Findings found);

/// Doubts, before anything is computed, a release that is too thin, that no slope has, or that is too small for its
/// cells.
Warnings doubt_release(const Scene& scene);

/// The ground from which something is released [m2]: a thickness raster may fill a part of its outline only.
double released_area(const Scene& scene);

/// Names exposed features of which the map will say nothing: off the map, without geometry, or where the terrain has no
/// elevation.
/// @param on_ground whether terrain, unless it is in tiles, is looked at
Warnings doubt_exposure(const Prepared& prepared, bool on_ground = true);

/// Statistics of the DTM under the outlines of the release; none if nothing is released.
std::optional<GroundStatistics> ground_of_release(const Scene& scene);

}  // namespace frana::app
