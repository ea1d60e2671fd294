// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "models/voellmy_bingham/stages.h"
#include "models/voellmy_bingham/state.h"
#include "simulation/scene.h"

namespace frana {

/// Which kernels compute the particles: the fastest that the processor supports, or the plain ones, which specify the
/// results of the fast ones.
enum class Kernels { fastest, plain };

/// Converts names to types: returns the stages of a scene. Those of the bed are chosen in dispatch_bed.cpp.
voellmy_bingham::Stages choose_stages(const Material& material, const MaterialZones& zones,
                                      const Entrainment& entrainment, const Numerics& numerics,
                                      Kernels kernels = Kernels::fastest);

/// Returns the laws with their parameters, in the engine's units.
/// @param gravity normal to the ground plane: numerics.gravity, or that of a tilted frame [m/s2]
/// @param nodes whose values by place are filled as their ground is taken
voellmy_bingham::Laws make_laws(const Material& material, const MaterialZones& zones, const Entrainment& entrainment,
                                const Numerics& numerics, NodeGrid& nodes, double gravity);

/// Returns whether a law of bed friction has an effect.
bool acts(const std::string& word, const Material& material, const MaterialZones& zones);

/// Returns whether a scene needs more than uniform Voellmy friction at the bed: other laws, parameters that vary, pore
/// pressure, surface pressure, or the stress at the bed for erosion.
bool sums_friction(const Material& material, const MaterialZones& zones, const Entrainment& entrainment);

/// Sets the nodes' stages for the slope correction, the curvature and the friction of a scene.
void choose_node_stages(const Numerics& numerics, bool summed, voellmy_bingham::Stages& stages);
/// With reference levels: sets the fast kernels, and replaces the stages by them where these compute the same.
void use_fast_node_stages(const Numerics& numerics, bool summed, voellmy_bingham::Stages& stages);
/// Sets the stage of the pore pressure and its fields, if any.
void choose_pore_pressure(const Material& material, const Numerics& numerics, voellmy_bingham::Stages& stages);

voellmy_bingham::BedFriction make_friction(const Material& material, const MaterialZones& zones,
                                           const Entrainment& entrainment, NodeGrid& nodes, double gravity);
voellmy_bingham::BedExchange make_exchange(const Entrainment& entrainment, const Material& material,
                                           const Numerics& numerics);
/// @param gravity as in make_laws
voellmy_bingham::PlaneStressLaw make_stress(const Material& material, double gravity);

/// Allocates the erodible beds of a scene that exchanges material, filled where the ground is read. They stay in place.
void set_erodible_beds(const Entrainment& entrainment, const MaterialZones& zones, NodeGrid& nodes,
                       ZeroArray<ErodibleBed>& beds);

/// Returns a raster's value at a node of the terrain, rows from the south; NaN becomes `uniform`, ghosts have the value
/// of the nearest cell.
double node_value(const Raster& raster, double uniform, std::int64_t i, std::int64_t j);

}  // namespace frana
