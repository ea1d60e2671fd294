// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "render/map/map2d.h"

namespace frana::app {

/// The particles of a frame, a file particles_NNNN.gpkg of a result, valued by their speed [m/s], the fastest
/// last. Their width comes from the ground that a mean particle stands for. Throws Error(input).
render::Dots read_particle_dots(const std::string& path);

}  // namespace frana::app
