// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/raster.h"
#include "particles/particle_set.h"
#include "simulation/result.h"
#include "simulation/scene.h"

namespace frana {

/// Particles that come in at one time.
struct Entry {
    double time = 0;  ///< [s]
    ParticleSet particles;
    std::vector<std::size_t> areas;  ///< release areas among them, by their place in the scene
};

/// The mass that fails, as particles and as what they slide over.
struct Release {
    ParticleSet particles;            ///< what fails at once, local metres
    std::vector<Entry> later;         ///< what fails later, by time
    Raster bed;                       ///< terrain, less all the mass where the terrain contains it [m]
    Raster bed_at_start;              ///< the same, less only what fails at once
    Raster depth;                     ///< released volume over cell area, vertical [m]; NaN where nothing is released
    Point centroid;                   ///< of all of it, local metres
    double volume = 0;                ///< of all of it [m3]
    std::vector<ReleasedArea> areas;  ///< in the order of Scene::release
};

/// Fills the release areas of a scene with particles. A scene that has an inflow may release nothing.
/// Throws Error(input) when nothing would be released, or where the terrain under the release has no data
/// (the cells are counted and the first named), or where it is everywhere thinner than the minimum depth.
Release make_release(const Scene& scene);

/// Distance between particles at the start [m].
double lattice_spacing(const Scene& scene);

/// Volume of particles over cell area, cell by cell [m]; NaN where there is none.
Raster cell_depth(const ParticleSet& particles, const GridSpec& grid);

}  // namespace frana
