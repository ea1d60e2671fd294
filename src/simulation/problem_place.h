// SPDX-License-Identifier: Apache-2.0
// The place of a problem in a step. Each function searches everything, and is called only after the problem was
// detected.
#pragma once

#include <optional>

#include "core/geometry.h"

namespace frana {

class Flow;
class StructuredFlow;

/// Returns a particle or cell with a non-finite value, in local metres. None: the step length itself was non-finite.
std::optional<Point> place_of_non_finite(const Flow& flow);
std::optional<Point> place_of_non_finite(const StructuredFlow& flow);

/// Returns the fastest particle or cell.
std::optional<Point> place_of_speed(const Flow& flow);
std::optional<Point> place_of_speed(const StructuredFlow& flow);

/// Returns a particle on ground without elevation, or a wet cell beside such ground.
std::optional<Point> place_of_no_data(const Flow& flow);
std::optional<Point> place_of_no_data(const StructuredFlow& flow);

}  // namespace frana
