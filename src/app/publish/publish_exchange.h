// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "app/input/prepare.h"
#include "app/store/frame_store.h"
#include "app/store/result_directory.h"
#include "simulation/result.h"

namespace frana::app {

/// Thickness normal to the slope [m]: vertical depth times the cosine of the bed's slope (central differences
/// of the bed; one-sided at its edges). NaN where depth or slope is not known.
Raster normal_thickness(const Raster& depth, const Raster& bed);

/// AvaFrame's name of a simulation: RELEASE_HASH_C_null_dfa, where no part may hold an underscore itself.
std::string avaframe_name(const std::string& scene, const std::string& hash);

/// peakFiles/ with AvaFrame's names, where output.names asks for them: ppr [kPa], pft [m, normal to the
/// slope] and pfv [m/s], zero where the flow did not come, nodata without terrain. Throws Error(environment).
void publish_avaframe(const Prepared& prepared, const RunResult& result, const ResultDirectory& directory);

/// frames.nc and frames.zarr, where output.formats asks for them, from the frames already written.
/// Throws Error(environment).
void publish_frame_stacks(const Prepared& prepared, const ResultDirectory& directory);

}  // namespace frana::app
