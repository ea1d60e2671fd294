// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "app/input/prepare.h"
#include "app/store/frame_store.h"
#include "app/store/result_directory.h"
#include "simulation/result.h"

namespace frana::app {

/// Returns AvaFrame's name of a simulation: RELEASE_HASH_C_null_dfa, where no part may contain an underscore.
std::string avaframe_name(const std::string& scene, const std::string& hash);

/// Writes peakFiles/ with AvaFrame's names, if output.names requests them: ppr [kPa], pft [m, normal to the slope] and
/// pfv [m/s], zero where there was no flow, nodata without terrain; of a large map as GeoTIFF whatever the format.
/// Throws Error(environment).
void publish_avaframe(const Prepared& prepared, const RunResult& result, const ResultDirectory& directory, RunLog& log);

/// Writes frames.nc and frames.zarr, if output.formats requests them, from the frames already written. Throws
/// Error(environment).
void publish_frame_stacks(const Prepared& prepared, const ResultDirectory& directory);

}  // namespace frana::app
