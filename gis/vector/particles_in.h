// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/grid_spec.h"

namespace frana::gis {

/// Points of a vector layer with some of their numbers: `columns[k][i]` is the k-th requested number of point i.
struct ValuedPoints {
    std::vector<Point> places;
    std::vector<std::vector<double>> columns;
};

/// Returns the points of the only point layer of a file, in its own coordinates, with the named numeric attributes.
/// Throws Error(input): missing or damaged file, no such attribute.
ValuedPoints read_valued_points(const std::string& path, const std::vector<std::string>& names,
                                const std::string& where);

}  // namespace frana::gis
