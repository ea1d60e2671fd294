// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/vtk/functions.h"

namespace frana::render {

/// See VtkFunctions. Edges are smooth.
std::vector<std::uint8_t> draw_triangles(const Triangles& triangles, const PixelWindow& window);

}  // namespace frana::render
