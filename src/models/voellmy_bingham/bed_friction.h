// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "mpm/node_friction.h"
#include "mpm/node_grid.h"
#include "physics/parameters.h"

namespace frana::voellmy_bingham {

/// A law's sweep over the nodes of a tile; called once per tile and step.
using FrictionSweep = std::function<void(const NodeRange&, const NodeGrid&, BedState*)>;

/// Bed friction of a scene: Voellmy with uniform parameters, or a sum of laws, of which one may be non-polynomial.
struct BedFriction {
    bool summed = false;
    VoellmyFriction voellmy;            ///< used if not summed
    std::vector<FrictionSweep> sweeps;  ///< used if summed, one per law
    ExcessLaw excess;                   ///< used if summed; also one of the sweeps
    bool yields = false;                ///< whether any law of the sum holds material at rest
    NodeValue coefficient;              ///< of friction, over the normal stress; 0 if no law has one [-]
    PorePressure pore_pressure;
    std::vector<ZeroArray<double>> node_values;  ///< targets of the laws' NodeValue, padded as the nodes are

    [[nodiscard]] bool keeps_rest() const noexcept { return summed ? yields : voellmy.friction_coefficient > 0; }
};

}  // namespace frana::voellmy_bingham
