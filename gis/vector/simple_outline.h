// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "core/geometry.h"

namespace frana::gis {

/// What a sweep over a polygon's edges tells for certain.
struct OutlineVerdict {
    bool sound = false;             ///< no two edges meet but at the vertex they share; holes lie inside, and apart
    std::optional<Point> crossing;  ///< two edges cross here
};

/// Looks for edges that meet, from west to east, each against its neighbours only (Shamos and Hoey 1976): the
/// time grows with n log n whatever the outline's form. Where edges touch, or lie within rounding of it,
/// there is no verdict: neither sound nor a crossing.
OutlineVerdict sweep(const Polygon& polygon);

}  // namespace frana::gis
