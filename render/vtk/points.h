// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/vtk/functions.h"

namespace frana::render {

/// See VtkFunctions.
void write_points(const std::string& file, const std::string& name, const PointTable& table,
                  const std::vector<double>& heights, double time);

}  // namespace frana::render
