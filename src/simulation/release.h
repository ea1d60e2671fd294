// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/raster.h"
#include "particles/particle_set.h"
#include "simulation/result.h"
#include "simulation/scene.h"

namespace frana {

/// Particles that enter at one time.
struct Entry {
    double time = 0;  ///< [s]
    ParticleSet particles;
    std::vector<std::size_t> areas;  ///< release areas among them, by their index in the scene
};

/// The released mass, as particles, and its sliding surface.
struct Release {
    ParticleSet particles;            ///< areas that fail at the start, local metres
    std::vector<Entry> later;         ///< areas that fail later, by time
    Raster bed;                       ///< terrain, minus all the released mass if the terrain contains it [m]
    Raster bed_at_start;              ///< the same, minus only the areas that fail at the start
    Raster depth;                     ///< released volume over cell area, vertical [m]; NaN where nothing is released
    Point centroid;                   ///< of the whole release, local metres
    double volume = 0;                ///< of the whole release [m3]
    std::vector<ReleasedArea> areas;  ///< in the order of Scene::release
};

/// Returns the volume of particles over the cell area, vertical [m]; NaN where there are none.
Raster cell_depth(const ParticleSet& particles, const GridSpec& grid);

/// Fills the release areas of a scene with particles. A scene with inflow may release nothing. Throws Error(input) if
/// nothing would be released, if the terrain under the release has no data (the cells are counted and the first named),
/// or if it is everywhere thinner than the minimum depth.
Release make_release(const Scene& scene);

/// Thicknesses outside are those of no landslide: the largest known are some hundred metres thick; less than the least
/// is not a mass, and at far smaller values volume and depths underflow [m].
inline constexpr double k_most_thickness = 2000, k_least_thickness = 1e-6;

/// Returns the volume that a thickness, constant over each cell, has inside an outline: exact [m3].
/// @param side of the raster's cells, and @param outline in the same unit, local to the raster's south-western corner
double volume_in_cells(const Raster& thickness, double side, const MultiPolygon& outline);

/// Returns the distance between particles at the start [m].
double lattice_spacing(const Scene& scene);

/// Returns the volume of particles over cell area, cell by cell [m]; NaN where there is none.
Raster cell_depth(const ParticleSet& particles, const GridSpec& grid);

}  // namespace frana
