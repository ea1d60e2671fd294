// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "app/input/prepare_release.h"
#include "app/input/used_file.h"
#include "simulation/scene.h"

namespace frana::app {

/// Reads [structured] with properties that vary from place to place on the working grid; none for another model.
/// Polygons give their values to the cells whose centres they cover, the later feature where two overlap, and to the
/// cells that only their edge touches. Adds every problem to `problems`, including a release without a value; without
/// terrain (null) files are only checked. Adds the files read to `files`.
/// @param release gives the polygons if structured.zones does not, and the solids' fraction of a thickness of phases
/// @param walls 1 where there can be no fluid
std::optional<StructuredMaterial> prepare_structured(const SceneReading& reading, const TerrainInput* ground,
                                                     const ReleaseInput& release, const std::optional<Raster>& walls,
                                                     std::vector<UsedFile>& files, Findings found, Problems& problems);

}  // namespace frana::app
