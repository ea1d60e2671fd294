// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ogr_geometry.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry.h"

namespace frana::gis {

/// What a look at an outline found. Exactly one of `crossing` and a non-empty `polygons` holds, or neither
/// when nothing with an area is left.
struct OutlineCheck {
    std::vector<std::unique_ptr<OGRPolygon>> polygons;  ///< as given, or repaired
    std::optional<std::string> crossing;                ///< where it crosses itself: "at 526950.2, 5094120.7"
    std::vector<std::string> repairs;                   ///< what was repaired
};

/// Takes the polygons of one feature. One that crosses itself has no sure inside and is not repaired; one that
/// only touches itself is, and so are parts that overlap (their union counts, once).
OutlineCheck check_outline(std::vector<std::unique_ptr<OGRPolygon>> polygons);

/// The area that two outlines share [their units squared]; 0 where they only touch.
double shared_area(const MultiPolygon& one, const MultiPolygon& other);

}  // namespace frana::gis
