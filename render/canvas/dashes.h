// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "core/geometry.h"

namespace frana::render {

/// Returns the strokes of a dashed line; `dashes` are lengths of stroke, gap, stroke, gap... in the line's unit.
std::vector<Polyline> dashed(std::span<const Point> points, const std::vector<double>& dashes);

}  // namespace frana::render
