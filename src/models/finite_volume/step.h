// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "models/finite_volume/state.h"

namespace frana::finite_volume {

/// Results of a step.
struct StepReport {
    double dt = 0;                                              ///< [s]
    double max_speed = 0;                                       ///< along the bed [m/s]
    double dissipated = 0;                                      ///< energy by friction, over density [m5/s2]
    double moving = 0;                                          ///< volume faster than StepValues::moving_speed [m3]
    std::int64_t unsupported = 0, not_finite = 0, no_data = 0;  ///< cells
};

/// Advances the flow by at most `limit`, by finite volumes on the cells of the map (share/doc/numerics.md, "Finite
/// volumes"): MUSCL-Hancock with HLL, along x and y in turn, well balanced; friction half before, in the predictor, and
/// as a whole after the sweeps. Only tiles in which something moves, and those around them, are computed. Results do
/// not depend on the number of threads.
/// @param maxima null: not wanted
StepReport step(State& state, const Laws& laws, double limit, Maxima* maxima, ThreadPool& pool);

/// The longest step that the present state allows [s].
double stable_step(const State& state, const Laws& laws);

/// Adds depth [m] with a velocity in map view [m/s] to a cell, by its padded numbers; `settle` of its tile, which is
/// returned, must follow.
std::int64_t add_to_cell(State& state, const Laws& laws, std::int64_t i, std::int64_t j, double depth, Point velocity,
                         const PorePressure::State& pores);
/// After material was added or the ground was changed: these tiles are surveyed and computed again.
/// @param pool null: by this thread
void settle(State& state, const Laws& laws, std::vector<std::int64_t> tiles, ThreadPool* pool = nullptr);
/// Reads the ground that the sweeps over these cells need, where it was not read yet.
void require_ground(State& state, const Laws& laws, const Region& region);
/// The bed has changed, or a saved state was read: what follows from the ground is read again under the flow.
void renew_ground(State& state, const Laws& laws);

/// A cell's velocity in map view and speed along the bed [m/s].
struct CellMotion {
    double u = 0, v = 0, speed = 0;
};
CellMotion motion_of(const State& state, const Laws& laws, std::size_t cell);

}  // namespace frana::finite_volume
