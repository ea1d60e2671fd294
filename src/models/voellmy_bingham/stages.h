// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "models/voellmy_bingham/state.h"
#include "mpm/node_grid.h"
#include "mpm/update_nodes.h"
#include "mpm/vector/kernels.h"

namespace frana::voellmy_bingham {

/// The compile-time variants of a step's stages, chosen once at set-up. Each is called once per tile, so the function
/// pointer costs nothing inside the inner loops, and variants multiply only where they share a loop. A stage that a
/// scene does not need is null.
struct Stages {
    void (*particles_to_nodes)(const ParticleTile&, const ParticleSet&, NodeGrid&) = nullptr;
    VectorKernels::Pressure pressure_to_nodes = nullptr;
    void (*pore_pressure_to_nodes)(const ParticleTile&, const PorePressure&, double dt, double gravity, bool along_bed,
                                   const NodeGrid&, ParticleSet&, double* sums) = nullptr;
    void (*fill_bed_states)(const NodeRange&, const NodeUpdate&, const NodeGrid&, BedState*) = nullptr;
    void (*find_held_nodes)(const NodeRange&, const NodeUpdate&, const BedFriction&, BedState*, NodeGrid&) = nullptr;
    NodeReport (*update_nodes)(const NodeRange&, const NodeUpdate&, const BedFriction&, BedState*, double time,
                               NodeGrid&, Maxima&) = nullptr;
    void (*exchange_with_particles)(std::size_t begin, std::size_t end, const NodeGrid&, const ErodibleBed*,
                                    ParticleSet&, double* kept, double* lost, ExchangeReport&) = nullptr;
    ParticleReport (*nodes_to_particles)(const ParticleTile&, const ParticleUpdate&, const PlaneStressLaw&,
                                         const NodeGrid&, ParticleSet&) = nullptr;
    const VectorNodeKernels* fast_nodes = nullptr;  ///< for tiles that they compute; null: none
    bool references = false;                        ///< pressure is relative to a still level or mean depth per node
    bool leapfrog = false;     ///< velocities are half a step before the positions; otherwise at the same time
    bool resamples = false;    ///< particles split and merge
    bool flies = false;        ///< particles leave a bed that falls away faster than free fall (Flights)
    bool follows_bed = false;  ///< particles carry the velocity along the bed (Curved), otherwise in map view
    double kept = 0;           ///< share of their own velocity that particles keep in a step
    FieldMask fields;          ///< fields of the particles for all of this
};

}  // namespace frana::voellmy_bingham
