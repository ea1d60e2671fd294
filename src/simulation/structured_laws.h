// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "models/structured/solid/placement.h"
#include "models/structured/state.h"
#include "simulation/scene.h"

namespace frana {

/// A damage length over the cell size: the least, under which the nodes of its sums have no particles, and the
/// greatest, up to which the stress's nodes follow it. The default over the thickness, and its greatest over the cell
/// size, with which they are as near as without.
inline constexpr double k_least_length = 0.5, k_greatest_length = 2, k_of_thickness = 0.25,
                        k_greatest_default = 2.0 / 3;

/// Returns the structured model's laws for a scene's material and numerics. The spacing of the solids'
/// particles follows numerics.particles-per-cell.
/// @param thickness greatest of the columns at the start, for the default of the damage length [m]
structured::Laws structured_laws(const StructuredMaterial& material, const Numerics& numerics, const GridSpec& grid,
                                 double thickness = 0);

/// Returns the properties of the solids at a place in local metres.
structured::SolidMaterial material_at(const StructuredMaterial& material, const GridSpec& grid, Point local);

/// Returns whether solids can lose cohesion, and whether there is or can be fluid.
bool can_fracture(const StructuredMaterial& material);
bool has_fluid(const StructuredMaterial& material);
/// Returns the density of solids and fluid together, as released [kg/m3].
double whole_density(const StructuredMaterial& material, const structured::SolidMaterial& solid);
/// Calls visit for the material of every cell with zones, or for the uniform one in a scene without.
void visit_materials(const StructuredMaterial& material, const std::function<void(const SolidValues&)>& visit);

/// Returns the speed of elastic rebound at a free face of material stretched to its strength, 2 T / (rho c), with Mohr
/// and Coulomb's uniaxial tensile strength T = 2 c cos phi / (1 + sin phi) and c the elastic waves' speed [m/s]. Our
/// estimate.
double recoil_speed(const StructuredMaterial& material);

}  // namespace frana
