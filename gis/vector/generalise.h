// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/geometry.h"

namespace frana::gis {

/// What a map that people draw does not show.
struct LeastZone {
    double area = 0;       ///< [m2]
    double width = 0;      ///< [m]
    double tolerance = 0;  ///< by which an outline may move to have fewer corners, besides [m]
};

/// Returns zones for a map that people draw, from the outlines of ground with at least each class, each inside the one
/// before it: gaps narrower than the least width are closed, then spurs as narrow removed; what remains smaller than
/// the least area is removed, holes as small filled. A strip or piece of a zone that is then narrower or smaller
/// becomes part of the higher zone that it touches. Zones do not overlap, have valid polygons and common edges, and
/// none lies in a hole of all. Empty if GEOS fails.
/// @param at_least from the lowest class
std::vector<MultiPolygon> generalised(const std::vector<MultiPolygon>& at_least, const LeastZone& least);

}  // namespace frana::gis
