// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/point_table.h"
#include "simulation/flow.h"
#include "simulation/structured_flow.h"

namespace frana {

/// Returns the particles of a flow in their present state, for files: depth_m, bed_m, speed_ms, velocity_x_ms,
/// velocity_y_ms, volume_m3 in this order, and for structured solids the further columns listed in
/// share/doc/results.md. Stresses in kPa, positive in tension, without the geostatic part. Velocities must be
/// synchronised.
PointTable particle_table(const Flow& flow);
PointTable particle_table(const StructuredFlow& flow);

/// Returns the principal strain of greatest magnitude in the plane of particle p, from the fields e_xx, e_yy, e_xy [-].
double greatest_strain(const ParticleSet& particles, std::size_t p);

}  // namespace frana
