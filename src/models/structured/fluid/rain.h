// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/thread_pool.h"
#include "models/structured/fluid/fluid_state.h"

namespace frana::structured {

/// Finds the cells on which rain falls, all that are ground, and reads the ground there; nothing without rain.
void find_open_ground(FluidState& state, const FluidLaws& laws);

/// Sources of the free fluid over a step (paper, equations 47, 49 and 52):
///
///     dh_u/dt = R - I,   d(h_u u)/dt = -I u
///
/// R rain, which falls without momentum, until `time` [s]; I infiltration, which leaves the velocity as it is. Rain of
/// a step falls at its beginning. What fell and what went is added up by the same depths, so that both balance to
/// rounding. Nothing is done in a scene without both. The same bits for any number of threads.
void rain_and_infiltrate(FluidState& state, const FluidLaws& laws, double time, double dt, ThreadPool& pool);

}  // namespace frana::structured
