// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "models/structured/solid/placement.h"
#include "models/structured/state.h"
#include "simulation/scene.h"

namespace frana {

/// The structured model's laws for a scene's material and numerics. Solids: the smoothing length is half a
/// cell, and particles stand as far apart as numerics.particles-per-cell says.
structured::Laws structured_laws(const StructuredMaterial& material, const Numerics& numerics, const GridSpec& grid);

/// What the solids are made of at a place, in local metres.
structured::SolidMaterial material_at(const StructuredMaterial& material, const GridSpec& grid, Point local);

/// Whether solids can lose cohesion, and whether there is or can be fluid.
bool can_fracture(const StructuredMaterial& material);
bool has_fluid(const StructuredMaterial& material);
/// Solids and fluid together, as released [kg/m3].
double whole_density(const StructuredMaterial& material, const structured::SolidMaterial& solid);
/// Speed to which material that was stretched to its strength springs back at a free face, 2 T / (rho c), with Mohr and
/// Coulomb's uniaxial tensile strength T = 2 c cos phi / (1 + sin phi) and c the elastic waves' speed [m/s]. Ours.
/// @param cells of the grid
double recoil_speed(const StructuredMaterial& material, std::size_t cells);

}  // namespace frana
