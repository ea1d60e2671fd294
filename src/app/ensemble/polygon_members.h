// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "params/scene/read_scene.h"
#include "study/sampling.h"

namespace frana::app {

/// The members of a study with a polygon each.
struct PolygonMembers {
    study::SampleTable table;  ///< release.perimeter-filter selects the polygon
    std::size_t largest = 0;   ///< member with the largest polygon
};

/// Returns a member for each polygon of a scene's release perimeter, in the order of the file. Adds a problem if the
/// scene names none, or it cannot be read.
PolygonMembers polygon_members(const SceneReading& scene, Problems& problems);

}  // namespace frana::app
