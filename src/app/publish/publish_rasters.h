// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>

#include "analysis/runout.h"
#include "app/input/prepare.h"
#include "app/store/result_directory.h"
#include "simulation/result.h"

namespace frana::app {

/// Writes dtm.tif; of a large DTM the part that was read; after a friction table also mu.tif and xi.tif. Throws
/// Error(environment).
/// @param friction_items more metadata of these
void publish_dtm(const Prepared& prepared, const ResultDirectory& directory,
                 const std::map<std::string, std::string>& friction_items = {});

/// The outline of an area with the name of its polygon, else its number, in a result's layer `release`.
Feature release_outline(const ReleaseArea& area, std::size_t index);

/// Writes what is known before a run: what publish_dtm does, scene.ini, and in extent.gpkg release and scar. Throws
/// Error(environment).
void publish_ground(const Prepared& prepared, const ResultDirectory& directory,
                    const std::map<std::string, std::string>& friction_items = {});

/// The column of outlines and zones, 1 where the full reach of the flow is not known.
inline constexpr const char* k_lower_bound_column = "lower_bound";

/// Metadata of a run's rasters: provenance(), and whether they are a lower bound.
std::map<std::string, std::string> result_tags(const Prepared& prepared, const RunResult& result);

/// Writes the result's rasters with their styles, and the ground: bed.tif, release.tif.
void publish_rasters(const Prepared& prepared, const RunResult& result, const ResultDirectory& directory);

/// Writes extent.gpkg: release, trace (greatest depth above the threshold), deposit (final depth above it), scar if
/// given.
void publish_outlines(const Prepared& prepared, const RunResult& result, const SeparateFlows& flows,
                      const Runout& run_out, const ResultDirectory& directory);

}  // namespace frana::app
