// SPDX-License-Identifier: Apache-2.0
// Where a step went wrong. Each looks at everything there is, and is called only when something is known to
// be there.
#pragma once

#include <optional>

#include "core/geometry.h"

namespace frana {

class Flow;
class StructuredFlow;

/// A particle or cell that holds a value that is not finite; local metres. None: the step itself was none.
std::optional<Point> place_of_non_finite(const Flow& flow);
std::optional<Point> place_of_non_finite(const StructuredFlow& flow);

/// The fastest particle or cell.
std::optional<Point> place_of_speed(const Flow& flow);
std::optional<Point> place_of_speed(const StructuredFlow& flow);

/// A particle on ground without elevation, or a wet cell beside such ground.
std::optional<Point> place_of_no_data(const Flow& flow);
std::optional<Point> place_of_no_data(const StructuredFlow& flow);

}  // namespace frana
