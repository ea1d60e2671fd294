// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "app/input/prepare_release.h"
#include "app/input/used_file.h"
#include "simulation/scene.h"

namespace frana::app {

/// [structured] with what differs from place to place on the working grid; none where the scene's model is another.
/// Polygons give their values to the cells whose centres they cover, the later feature where two overlap, and to the
/// cells that only their rim touches. Adds every problem to `problems`, a release without a value among them; without a
/// ground (null) files are only checked. Adds what was read to `files`.
/// @param release gives the polygons where structured.zones does not, and the solids' fraction of a thickness of phases
/// @param walls 1 where no fluid can lie
std::optional<StructuredMaterial> prepare_structured(const SceneReading& reading, const TerrainInput* ground,
                                                     const ReleaseInput& release, const std::optional<Raster>& walls,
                                                     std::vector<UsedFile>& files, RunLog& log, Problems& problems);

}  // namespace frana::app
