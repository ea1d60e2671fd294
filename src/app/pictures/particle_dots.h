// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "render/map/map2d.h"

namespace frana::app {

/// A quantity for the colours of particles, by its name in --map.
struct ParticleQuantity {
    const char* name;
    const char* attribute;  ///< in their files
    const char* colours;    ///< raster of the frames whose colours they have
    const char* title;
};
/// Null for other names.
const ParticleQuantity* find_particle_quantity(const std::string& name);

/// Returns the particles of a frame, a file particles_NNNN.gpkg of a result, valued by a quantity, the greatest values
/// last. Their width follows from the mean area of a particle. Throws Error(input).
render::Dots read_particle_dots(const std::string& path, const ParticleQuantity& quantity);

}  // namespace frana::app
