// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry.h"
#include "params/scene/read_scene.h"
#include "study/sampling.h"

namespace frana::app {

/// What the attributes of a polygon of a region say of it.
struct Slope {
    std::string name, group, scenario;  ///< empty: no such column or no value
    std::optional<double> return_period;
    std::string problem;   ///< why it cannot be computed; empty: nothing is known against it
    MultiPolygon outline;  ///< in the working CRS, once that is known
};

/// The members of a study with a polygon each.
struct PolygonMembers {
    study::SampleTable table;     ///< release.perimeter-filter selects the polygon; of a region also its columns
    std::vector<double> sizes;    ///< areas, by member
    std::vector<Slope> slopes{};  ///< of a region, by member
};

/// Returns a member for each polygon of a scene's release perimeter, in the order of the file. Adds a problem if the
/// scene names none, or it cannot be read, or no polygon has a column that the region names, or one scenario has
/// several return periods. What is wrong with a single slope is only kept with it.
PolygonMembers polygon_members(const study::StudySpec& study, const std::string& label, const SceneReading& scene,
                               Problems& problems);

}  // namespace frana::app
