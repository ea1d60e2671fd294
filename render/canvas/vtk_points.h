// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/point_table.h"

namespace frana::render {

/// Writes VTK XML polydata (.vtp, compressed): one vertex per point, the table's columns as point data, and the time as
/// field data "TimeValue". Written aside and renamed. Throws Error(environment).
/// @param heights z of the points [m], one per point
void write_vtk_points(const std::string& path, const PointTable& table, const std::vector<double>& heights,
                      double time);

}  // namespace frana::render
