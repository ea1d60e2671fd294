// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "models/voellmy_bingham/stages.h"
#include "simulation/scene.h"

namespace frana {

/// Returns whether a law of bed friction has an effect.
bool acts(const std::string& word, const Material& material, const MaterialZones& zones);

/// Returns whether a scene needs more than uniform Voellmy friction at the bed: other laws, parameters that vary, pore
/// pressure, surface pressure, or the stress at the bed for erosion.
bool sums_friction(const Material& material, const MaterialZones& zones, const Entrainment& entrainment);

/// Sets the nodes' stages for the slope correction, the curvature and the friction of a scene.
void choose_node_stages(const Numerics& numerics, bool summed, voellmy_bingham::Stages& stages);
/// With reference levels: sets the fast kernels, and replaces the stages by them where these compute the same.
void use_fast_node_stages(const Numerics& numerics, bool summed, voellmy_bingham::Stages& stages);
/// Sets the stages of erosion and deposition, if any.
void choose_exchange(const Entrainment& entrainment, const Numerics& numerics, voellmy_bingham::Stages& stages);

voellmy_bingham::BedFriction make_friction(const Material& material, const MaterialZones& zones,
                                           const Entrainment& entrainment, NodeGrid& nodes, double gravity);
voellmy_bingham::BedExchange make_exchange(const Entrainment& entrainment, double density);

/// Returns a raster's value at a node of the terrain, rows from the south; NaN becomes `uniform`, ghosts have the value
/// of the nearest cell.
double node_value(const Raster& raster, double uniform, std::int64_t i, std::int64_t j);

}  // namespace frana
