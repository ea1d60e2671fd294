// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "render/map/map2d.h"

namespace frana::app {

/// Returns the particles of a frame, a file particles_NNNN.gpkg of a result, valued by their speed [m/s], the fastest
/// last. Their width follows from the mean area of a particle. Throws Error(input).
render::Dots read_particle_dots(const std::string& path);

}  // namespace frana::app
