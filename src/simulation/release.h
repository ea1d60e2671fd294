// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/raster.h"
#include "particles/particle_set.h"
#include "simulation/scene.h"

namespace frana {

/// The mass that fails, as particles and as what they slide over.
struct Release {
    ParticleSet particles;  ///< local metres
    Raster bed;             ///< terrain, less the mass where the terrain contains it [m]
    Raster depth;           ///< released volume over cell area, vertical [m]; NaN where nothing is released
    double volume = 0;      ///< [m3]
    double scaled = 1;      ///< the factor farthest from 1 by which a thickness was scaled to match a volume
};

/// Fills the release areas of a scene with particles.
/// Throws Error(input) when nothing would be released, or where the terrain under the release has no data
/// (the cells are counted and the first named).
Release make_release(const Scene& scene);

}  // namespace frana
