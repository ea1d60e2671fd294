// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/thread_pool.h"
#include "models/voellmy_bingham/stages.h"
#include "models/voellmy_bingham/state.h"

namespace frana::voellmy_bingham {

/// Brings particles into tile order and works out the first step's bounds. Call before the first step, and
/// whenever particles were added or the bed changed between steps.
void prepare(State& state, const Laws& laws, ThreadPool& pool);

/// One time step of at most `dt_limit`, folding what the nodes saw into `maxima`. With Stages::leapfrog forces at
/// time t carry the velocities from the middle of the step before to the middle of this one, and those carry the
/// positions from t to t + dt, so that both are of second order (Verlet 1967); otherwise velocities go to t + dt
/// first, as in the paper.
StepReport step(State& state, const Laws& laws, const Stages& stages, double dt_limit, Maxima& maxima,
                ThreadPool& pool);

/// Brings the velocities to the positions' time: they lag half a step (see step). Moves nothing.
void synchronise(State& state, const Laws& laws, const Stages& stages, Maxima& maxima, ThreadPool& pool);

/// Mass, momentum, area and reference levels on the nodes for the particles as they are now, without moving
/// anything.
void gather_on_nodes(State& state, const Laws& laws, const Stages& stages, ThreadPool& pool,
                     StageWatch& watch);

}  // namespace frana::voellmy_bingham
