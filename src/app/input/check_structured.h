// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/input/prepare_release.h"
#include "simulation/scene.h"

namespace frana::app {

/// Checks values of the structured model against each other, and the release's thickness against the cells. What has no
/// meaning is added to `problems`; what is legal and dubious, or given and without effect, is warned of.
void check_structured_values(const SceneReading& reading, const StructuredMaterial& material,
                             const ReleaseInput& release, const GridSpec& grid, RunLog& log, Problems& problems);

}  // namespace frana::app
