// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "models/finite_volume/state.h"

namespace frana::finite_volume {

/// Adds to State::jumps what would leave the ground within a step, by the test of the particles (mpm/flight.h): the
/// part of the flow through a cell that an edge throws, beyond what the cell before it had thrown. It stays on the
/// ground. Tests every few steps.
void find_jumps(State& state, const Laws& laws, double dt, ThreadPool& pool);

}  // namespace frana::finite_volume
