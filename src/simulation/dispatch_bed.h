// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "models/voellmy_bingham/stages.h"
#include "simulation/scene.h"

namespace frana {

/// Whether a law of bed friction does anything: Voellmy's parts without their parameter do not, and are left out.
bool acts(const std::string& law, const Material& material, const MaterialZones& zones);

/// Whether a scene needs more at the bed than uniform Voellmy friction: other laws, parameters that vary,
/// pore pressure, surface pressure, or the stress at the bed for erosion.
bool sums_friction(const Material& material, const MaterialZones& zones, const Entrainment& entrainment);

/// The nodes' stages for the slope's form, the curvature and the friction that a scene needs.
void choose_node_stages(const Material& material, const Numerics& numerics, bool summed,
                        voellmy_bingham::Stages& stages);
/// The stages of erosion and deposition, if any.
void choose_exchange(const Entrainment& entrainment, const Numerics& numerics, voellmy_bingham::Stages& stages);

voellmy_bingham::BedFriction make_friction(const Material& material, const MaterialZones& zones,
                                           const Entrainment& entrainment, const NodeGrid& nodes, double gravity);
voellmy_bingham::BedExchange make_exchange(const Entrainment& entrainment, double density);

/// A raster as a padded node array; NaN becomes `uniform`, ghosts take the value of the nearest cell.
std::vector<double> node_values(const Raster& raster, double uniform, const NodeGrid& nodes);

}  // namespace frana
