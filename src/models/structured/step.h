// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "models/structured/step_stages.h"

namespace frana::structured {

/// One time step of at most `dt_limit`: the free fluid moves over the solids at their present places, both exchange
/// momentum at the nodes, and the solids follow their own waves in substeps (run_substeps). h_u depth and q discharge
/// of free fluid, h_c column of solids with confined fluid, b bed, k = 1 / (1 + |grad b|^2), m and u mass and velocity
/// of a particle of solids; share/doc/structured.md. Without solids, or without fluid, their stages do nothing. The
/// same bits for any number of threads.
inline StepReport step(State& state, const Laws& laws, double dt_limit, ThreadPool& pool) {
    Step now(state, laws, pool);
    choose_length(now, dt_limit);  // dt = min(stable_step, limit)
    move_fluid(now);               // dq/dt + div(q q / h_u) = -k g h_u grad(h_u + h_c + b) + div(h_u tau) - resistance
    rain_and_infiltration(now);    // dh_u/dt = R - I,  dq/dt = -I q / h_u, if the scene has them
    push_on_nodes(now);            // a = -k g grad b + buoyancy + (virtual mass and drag) / m; -dt m a of these to q
    nodes_to_solids(now);          // a of a particle = sum w a
    pore_pressure(now);            // dr = -dt/2 (r - r_h) / T, if the scene has it; again after the motion
    move_solids(now);              // m du/dt = stress + thrust + m a - bed friction,  dx/dt = u,  dA/dt = A tr(grad u)
    pore_pressure(now);
    release_confined(now);  // h_u += fluid that broken solids no longer confine
    solids_to_nodes(now);   // m = sum w m,  p = sum w m u,  h_c = sum w (V_s + V_fc) / cell area
    state.time += now.report.dt;
    return now.report;
}

}  // namespace frana::structured
