// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>

#include "core/geometry.h"
#include "particles/particle_set.h"

namespace frana {

/// Fills an outline with particles on a square lattice, independent of the resolution of any raster.
///
/// Each lattice cell that the outline covers, wholly or in part, gives one particle at the centroid of the covered
/// part, with the area covered (exact, except where edges of overlapping parts cross) and the thickness there. Holes
/// and overlapping parts are respected: no area is filled twice. Slivers are redistributed.
/// @param outline in local metres
/// @param spacing of the lattice [m]; the lattice is anchored at the origin
/// @param thickness vertical thickness [m] at a local point; NaN or <= 0: no particle
/// @returns the volume added [m3]
double fill_outline(const MultiPolygon& outline, double spacing, const std::function<double(Point)>& thickness,
                    ParticleSet& particles);

/// Removes particles, from `first` on, with less than a hundred thousandth of a lattice cell's area; their area and
/// volume are distributed over the others in proportion. If there is little else, all remain.
void spread_slivers(std::size_t first, double spacing, ParticleSet& particles);

}  // namespace frana
