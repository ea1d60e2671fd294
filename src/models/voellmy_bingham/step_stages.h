// SPDX-License-Identifier: Apache-2.0
// The stages of a time step (step.h), with their walls, active tiles and reports.
#pragma once

#include <cstdint>

#include "core/thread_pool.h"
#include "models/voellmy_bingham/stages.h"
#include "models/voellmy_bingham/state.h"

namespace frana::voellmy_bingham {

/// The data of one step.
struct Step {
    Step(State& s, const Laws& l, const Stages& chosen, Maxima& m, ThreadPool& p)
        : state(s), laws(l), stages(chosen), maxima(m), pool(p) {}
    Step(const Step&) = delete;
    Step& operator=(const Step&) = delete;

    State& state;
    const Laws& laws;
    const Stages& stages;
    Maxima& maxima;
    ThreadPool& pool;
    double kick = 0;     ///< time over which forces change the velocities [s]
    double drift = 0;    ///< time over which velocities move the particles [s]
    NodeUpdate nodes{};  ///< from bed_resistance on
    StepReport report;

    /// Whether material is exchanged with the bed: only while positions move.
    [[nodiscard]] bool exchanges() const noexcept { return laws.exchange.at_nodes && drift > 0; }
};

/// Sets kick and drift. Reads State::speeds, diffusivity, velocity_lag.
void choose_length(Step& now, double dt_limit);
/// Lists the tiles of this step (ActiveTiles).
void choose_active_tiles(Step& now);
/// Reads the particles; clears the records and writes NodeSums.
void particles_to_nodes(Step& now);
/// Reads the squares; writes NodeLevel; adds the force of the state held on the grid to NodeForces fx, fy.
void reference_levels(Step& now);
/// Reads particles and NodeLevel; adds NodeForces fx, fy.
void forces_to_nodes(Step& now);
/// Pore pressure of the particles over the kick, and State::pore_sums.
void pore_pressure(Step& now);
/// Reads NodeForces; writes BedState, and NodeForces::held. Whether a node is held depends on its neighbours, so it is
/// decided before any node is updated.
void bed_resistance(Step& now);
/// From NodeForces to NodeMotion; maxima, NodeReport.
void update_nodes(Step& now);
/// Erosion and deposition: computed at the nodes, then applied to the particles before they move.
void exchange_with_bed(Step& now);
/// Reads NodeMotion; writes all fields of the particles.
void nodes_to_particles(Step& now);
/// Updates State::time and the bounds of the next step.
void advance_time(Step& now);
/// Sorts, splits and merges particles if they may have drifted too far, have left the terrain, or their shape is too
/// long.
void regularise(Step& now);
/// Moves particles that leave the bed within the next step into the air, and those that have landed back to the ground
/// (Flights).
void leave_and_land(Step& now);

/// Sorts particles into tiles and computes the first step's bounds. Call before the first step, and whenever particles
/// were added or the bed changed between steps.
void prepare(State& state, const Laws& laws, ThreadPool& pool);

/// Reads the terrain of the nodes that the particles can touch and their border, if the grid reads it on demand. Call
/// after every sort; prepare and regularise do so.
void cover_ground(const State& state);

/// Computes mass, momentum, area and reference levels on the nodes for the current particles, without moving anything.
void gather_on_nodes(State& state, const Laws& laws, const Stages& stages, Maxima& maxima, ThreadPool& pool);

/// Shifting has the requirements of splitting: the default scheme with its affine velocities.
[[nodiscard]] bool shifts_now(const State& state, const Stages& stages);

}  // namespace frana::voellmy_bingham
