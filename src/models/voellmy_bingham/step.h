// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/thread_pool.h"
#include "models/voellmy_bingham/stages.h"
#include "models/voellmy_bingham/state.h"
#include "models/voellmy_bingham/step_stages.h"

namespace frana::voellmy_bingham {

/// Forces change the velocities over Step::kick, the new velocities move the particles over Step::drift. V volume, A
/// area, v and C velocity and its gradient of a particle, w its weight at a node, Z the bed; what a stage reads and
/// writes is said at its declaration.
inline void kick_and_drift(Step& now) {
    choose_active_tiles(now);  // where anything moves or may begin to
    particles_to_nodes(now);   // m = sum w V, p = sum w V (v + C (x_i - x_p)), area claimed = sum w A
    reference_levels(now);     // still level or mean depth r, support s
    forces_to_nodes(now);      // f = sum A [g/2 (h^2 - s r^2) grad w - g (h - s r) w grad Z] - V sigma : grad w
    bed_resistance(now);       // the sum of the scene's laws; where it holds what is slow
    update_nodes(now);         // v = cap(p/m + dt a; resistance), what is held stays; maxima
    exchange_with_bed(now);    // erosion and deposition; nothing unless asked for
    nodes_to_particles(now);   // v, C, x += dt v, A *= det(I + dt grad v), relaxed and shifted; stress
}

/// One time step of at most `dt_limit`, folding what the nodes saw into `maxima`. With Stages::leapfrog forces at time
/// t carry the velocities from the middle of the step before to the middle of this one, and those carry the positions
/// from t to t + dt, so that both are of second order (Verlet 1967); otherwise velocities go to t + dt first, as in the
/// paper.
inline StepReport step(State& state, const Laws& laws, const Stages& stages, double dt_limit, Maxima& maxima,
                       ThreadPool& pool) {
    Step now(state, laws, stages, maxima, pool);
    choose_length(now, dt_limit);  // dt = min(stable_step, limit): (w + g dt) dt <= cfl dx
    kick_and_drift(now);
    advance_time(now);    // t += dt; bounds of the next step
    regularise(now);      // sort by tile, split, merge, when it is time
    leave_and_land(now);  // what an edge throws off flies: z = z0 + w t - g t^2/2
    return now.report;
}

/// Brings the velocities to the positions' time: they lag half a step (see step). Moves nothing.
inline void synchronise(State& state, const Laws& laws, const Stages& stages, Maxima& maxima, ThreadPool& pool) {
    if (state.velocity_lag == 0) return;
    Step now(state, laws, stages, maxima, pool);
    now.kick = state.velocity_lag;
    kick_and_drift(now);
    state.velocity_lag = 0;
}

}  // namespace frana::voellmy_bingham
