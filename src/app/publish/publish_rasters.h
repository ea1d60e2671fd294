// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "analysis/runout.h"
#include "app/input/prepare.h"
#include "app/store/result_directory.h"
#include "simulation/result.h"

namespace frana::app {

/// What is known before a run: dtm.tif, scene.ini, and in extent.gpkg release and scar. Throws Error(environment).
void publish_ground(const Prepared& prepared, const ResultDirectory& directory);

/// The result's rasters, each with its styles beside it, and what they stand on: bed.tif, release.tif.
void publish_rasters(const Prepared& prepared, const RunResult& result, const ResultDirectory& directory);

/// extent.gpkg: release, trace (greatest depth over the threshold), deposit (final depth over it), scar if
/// given.
void publish_outlines(const Prepared& prepared, const RunResult& result, const Runout& run_out,
                      const ResultDirectory& directory);

}  // namespace frana::app
