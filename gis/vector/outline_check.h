// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ogr_geometry.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry.h"
#include "core/words/sentence.h"

namespace frana::gis {

/// The result of checking an outline. Either `crossing` or `hole_outside` is set or `polygons` is not empty, or none of
/// these if no area is left.
struct OutlineCheck {
    std::vector<std::unique_ptr<OGRPolygon>> polygons;  ///< as given, or repaired
    std::optional<std::string> crossing;                ///< where it crosses itself: "at 526950.2, 5094120.7"
    std::optional<std::string> hole_outside;            ///< where it has a hole outside the area
    std::vector<Sentence> repairs;                      ///< list of repairs
};

/// Checks the polygons of one feature. One that crosses itself, or has a hole outside, has no well-defined interior and
/// is not repaired; one
/// that only touches itself is repaired, and so are parts that overlap (their union counts once).
OutlineCheck check_outline(std::vector<std::unique_ptr<OGRPolygon>> polygons);

/// Returns the area common to two outlines [their units squared]; 0 if they only touch.
double shared_area(const MultiPolygon& one, const MultiPolygon& other);

}  // namespace frana::gis
