// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/thread_pool.h"
#include "models/voellmy_bingham/stages.h"
#include "models/voellmy_bingham/state.h"
#include "models/voellmy_bingham/step_stages.h"

namespace frana::voellmy_bingham {

/// Forces change the velocities over Step::kick, the new velocities move the particles over Step::drift. V volume, A
/// area, v and C velocity and its gradient of a particle, w its weight at a node, Z the bed; the declaration of each
/// stage lists what it reads and writes.
inline void kick_and_drift(Step& now) {
    choose_active_tiles(now);  // where anything moves or may start to
    particles_to_nodes(now);   // m = sum w V, p = sum w V (v + C (x_i - x_p)), area claimed = sum w A
    reference_levels(now);     // still level or mean depth r, support s; force of the state held on the grid
    forces_to_nodes(now);      // f = sum A [g/2 (h^2 - s r^2) grad w - g (h - s r) w grad Z] - V sigma : grad w
    pore_pressure(now);        // dr = -dt (r - r_h) / T, if the scene has it; its means at the nodes
    bed_resistance(now);       // the sum of the scene's laws; where it holds slow material
    update_nodes(now);         // v = cap(p/m + dt a; resistance), held nodes stay at rest; maxima
    exchange_with_bed(now);    // erosion, deposition, detrainment, if the scene has them
    nodes_to_particles(now);   // v, C, x += dt v, A *= det(I + dt grad v), relaxed and shifted; stress
}

/// Computes one time step of at most `dt_limit` and updates `maxima`. With Stages::leapfrog, forces at time t advance
/// the velocities from the middle of the previous step to the middle of this one, and those advance the positions from
/// t to t + dt, so that both are of second order (Verlet 1967); otherwise velocities are advanced to t + dt first, as
/// in the paper.
inline StepReport step(State& state, const Laws& laws, const Stages& stages, double dt_limit, Maxima& maxima,
                       ThreadPool& pool) {
    Step now(state, laws, stages, maxima, pool);
    choose_length(now, dt_limit);  // dt = min(stable_step, limit): (w + g dt) dt <= cfl dx
    kick_and_drift(now);
    advance_time(now);    // t += dt; bounds of the next step
    regularise(now);      // sort by tile, split and merge when due
    leave_and_land(now);  // particles leaving at an edge fly: z = z0 + w t - g t^2/2
    return now.report;
}

/// Advances the velocities to the positions' time: they lag half a step (see step). Moves nothing.
inline void synchronise(State& state, const Laws& laws, const Stages& stages, Maxima& maxima, ThreadPool& pool) {
    if (state.velocity_lag == 0) return;
    Step now(state, laws, stages, maxima, pool);
    now.kick = state.velocity_lag;
    kick_and_drift(now);
    state.velocity_lag = 0;
}

}  // namespace frana::voellmy_bingham
