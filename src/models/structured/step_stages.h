// SPDX-License-Identifier: Apache-2.0
// The stages of a time step (step.h).
#pragma once

#include "models/structured/state.h"

namespace frana::structured {

struct StepReport {
    double dt = 0;
    int substeps = 0;    ///< of the solids
    SolidReport solids;  ///< over all substeps
    FluidReport fluid;
    std::int64_t outside = 0;  ///< particles that left through open edges
    std::int64_t no_data = 0;  ///< particles over cells without terrain
    double deepest = 0;        ///< column of any particle [m]
    bool elastic = false;      ///< whether any particle has stress other than earth pressure
    double kinetic = 0;        ///< of the solids with their confined fluid [J]
};

/// State of a step in progress.
struct Step {
    Step(State& s, const Laws& l, ThreadPool& p) : state(s), laws(l), pool(p) {}
    Step(const Step&) = delete;
    Step& operator=(const Step&) = delete;

    State& state;
    const Laws& laws;
    ThreadPool& pool;
    StepReport report;

    /// Whether solids move: there are any, and their numbers are finite.
    [[nodiscard]] bool solids() const noexcept {
        return state.solid && state.solid->particles.size() > 0 && report.solids.non_finite == 0;
    }
};

/// Sets StepReport::dt.
void choose_length(Step& now, double dt_limit);
/// Over the solids at their present places. Reads solids_on_grid; writes FluidState, StepReport::fluid.
void move_fluid(Step& now);
/// Rain and infiltration; reads and writes FluidState.
void rain_and_infiltration(Step& now);
/// Reads SolidNodes and the fluid; writes the nodes' push; its reaction changes the fluid's discharge.
void push_on_nodes(Step& now);
/// Reads the nodes' push; writes the particles' push.
void nodes_to_solids(Step& now);
/// Half a step of the particles' pore pressure.
void pore_pressure(Step& now);
/// Reads and writes the particles; writes StepReport::substeps, solids.
void move_solids(Step& now);
/// Reads the particles' released fluid; adds it to the fluid's cells.
void release_confined(Step& now);
/// Sums over the particles for the report and the next step's length; sorts after sufficient drift; writes SolidNodes.
void solids_to_nodes(Step& now);

/// Longest stable step of solids and fluid together [s]; the solids' elastic waves are followed in substeps.
double stable_step(const State& state, const Laws& laws, ThreadPool& pool);

}  // namespace frana::structured
