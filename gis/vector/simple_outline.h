// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "core/geometry.h"

namespace frana::gis {

/// The certain result of a sweep over a polygon's edges.
struct OutlineVerdict {
    bool sound = false;             ///< no two edges meet except at their common vertex; holes are inside, and apart
    std::optional<Point> crossing;  ///< two edges cross here
};

/// Searches for edges that meet, from west to east, each compared with its neighbours only (Shamos and Hoey 1976): the
/// time is proportional to n log n whatever the outline's shape. If edges touch, or nearly within rounding, there is no
/// verdict: neither sound nor a crossing.
OutlineVerdict sweep(const Polygon& polygon);

}  // namespace frana::gis
