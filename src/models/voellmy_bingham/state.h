// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "core/default_values.h"
#include "models/voellmy_bingham/bed_friction.h"
#include "mpm/active_tiles.h"
#include "mpm/erodible_bed.h"
#include "mpm/flight.h"
#include "mpm/ground_walls.h"
#include "mpm/node_grid.h"
#include "mpm/nodes_to_particles.h"
#include "mpm/update_nodes.h"
#include "particles/particle_set.h"
#include "particles/resample.h"
#include "particles/tile_order.h"
#include "physics/strain_rate.h"

namespace frana::voellmy_bingham {

/// Everything that changes during a run.
struct State {
    State(ParticleSet set, NodeGrid grid, TileOrder tiles)
        : particles(std::move(set)),
          nodes(std::move(grid)),
          order(std::move(tiles)),
          active(order.grid()),
          node_reports(static_cast<std::size_t>(order.grid().tiles_x() * order.grid().tiles_y())),
          particle_reports(node_reports.size()),
          tail(nodes.size()) {}

    ParticleSet particles;
    NodeGrid nodes;
    TileOrder order;
    ActiveTiles active;
    ZeroArray<NodeReport> node_reports;          ///< by tile: of the last step that updated its nodes
    ZeroArray<ParticleReport> particle_reports;  ///< by tile: of the last step that moved its particles
    double time = 0;                             ///< of positions [s]
    double velocity_lag = 0;                     ///< how far the velocities are behind the positions [s]
    double drift = 0;                            ///< bound of the particles' displacement since the last sort [cells]
    int since_sort = 0;                          ///< [steps]
    FlowSpeeds speeds;                           ///< of the particles
    double diffusivity = 0;                      ///< greatest of the in-plane stress [m2/s]
    double volume_left = 0;                      ///< through open boundaries [m3]
    Flights flights;                             ///< particles in the air; none if Stages::flies is off
    ZeroArray<BedState> bed_states;              ///< padded; empty if friction is uniform Voellmy
    ZeroArray<ErodibleBed> erodible_beds;        ///< padded; empty if the bed does not change
    ExchangeReport exchanged;                    ///< with the bed, so far
    std::vector<double> kept, lost;              ///< by each particle, within a step
    ZeroArray<double> pore_sums;   ///< padded; w V r of the particles, within a step; empty: no pore pressure
    ZeroArray<std::uint8_t> tail;  ///< padded; mark_tail, within a step
    WalledTiles walled;            ///< those of the bed
    WallContact walls;             ///< so far
    ZeroArray<Point> gathered;     ///< padded; velocity in map view before the update; empty: not stored
};

template <class Archive>
void serialise(Archive& archive, State& state) {
    [[maybe_unused]] auto& [particles, nodes, order, active, node_reports, particle_reports, time, velocity_lag, drift,
                            since_sort, speeds, diffusivity, volume_left, flights, bed_states, erodible_beds, exchanged,
                            kept, lost, pore_sums, tail, walled, walls, gathered] = state;
    archive(particles, nodes, order, active, node_reports, particle_reports, time, velocity_lag, drift, since_sort,
            speeds, diffusivity, volume_left, flights, bed_states, erodible_beds, exchanged,
            walls);  // the rest is within a step
    if constexpr (Archive::k_reads) archive.require(order.restore(particles));
}

/// In-plane stress.
struct PlaneStressLaw {
    /// One of StressLaws, which the sweeps over particles find in it; empty: none.
    std::function<PlaneStress<double>(const StrainRate<double>&)> law;
    double wave_factor = 1;  ///< square of the factor on the speed of pressure waves
};

/// Erosion, deposition and detrainment.
struct BedExchange {
    /// Computes them at the nodes of a tile, over dt; empty: the bed does not change.
    /// @param least_depth that deposition leaves [m]
    std::function<void(const NodeRange&, double dt, double least_depth, const BedState*, const NodeGrid&, ErodibleBed*)>
        at_nodes;
    PorePressure::State bed;          ///< of eroded material
    double density = k_flow_density;  ///< [kg/m3]
};

/// Parameters and laws; constant during a run.
struct Laws {
    double gravity = k_standard_gravity;  ///< vertical, or normal to a tilted flat bed [m/s2]
    double gravity_x = 0, gravity_y = 0;  ///< of a tilted frame, for verification [m/s2]
    StepBounds step;
    double minimum_depth = k_minimum_depth;  ///< [m]
    bool wall = false;
    JumpRules jumps;          ///< of particles in the air
    bool skips_rest = true;   ///< material at rest is not computed while nothing near it moves
    Point origin;             ///< release centroid, local metres
    double moving_speed = 0;  ///< speed from which volume counts as moving [m/s]
    BedFriction friction;
    PlaneStressLaw stress;
    BedExchange exchange;
    ResampleLimits resample;
};

/// Results of one step.
struct StepReport {
    double dt = 0;
    NodeReport nodes;
    ParticleReport particles;
    ResampleCounts resampled;
    double aloft = 0;          ///< volume in the air [m3]
    double aloft_kinetic = 0;  ///< its kinetic energy over density [m5/s2]
    std::size_t moved = 0;     ///< particles that were computed; the others are at rest
};

}  // namespace frana::voellmy_bingham
