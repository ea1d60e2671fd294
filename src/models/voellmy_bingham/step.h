// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/thread_pool.h"
#include "models/voellmy_bingham/stages.h"
#include "models/voellmy_bingham/state.h"

namespace frana::voellmy_bingham {

/// Brings particles into tile order and works out the first step's bounds. Call once before the first step.
void prepare(State& state, const Laws& laws, ThreadPool& pool);

/// One time step of at most `dt_limit`, folding what the nodes saw into `maxima`.
StepReport step(State& state, const Laws& laws, const Stages& stages, double dt_limit, Maxima& maxima,
                ThreadPool& pool);

/// Mass, momentum, area and reference levels on the nodes for the particles as they are now, without moving
/// anything.
void gather_on_nodes(State& state, const Laws& laws, const Stages& stages, ThreadPool& pool,
                     StageWatch& watch);

}  // namespace frana::voellmy_bingham
