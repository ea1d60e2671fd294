// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mpm/vector/kernels.h"
#include "mpm/vector/nodes_to_particles.h"
#include "mpm/vector/particles_to_nodes.h"
#include "mpm/vector/pressure.h"

// Included once by the source of each instruction set; everything here belongs to that source alone.
namespace frana {
namespace {

template <bool Stress>
ParticleReport vector_nodes_to_particles_stage(const ParticleTile& tile, const ParticleUpdate& update,
                                               const BinghamStress& stress, const NodeGrid& nodes,
                                               ParticleSet& particles) {
    if constexpr (Stress) {
        return vector_nodes_to_particles(tile, update, stress, nodes, particles);
    } else {
        return vector_nodes_to_particles(tile, update, NoStress{}, nodes, particles);
    }
}

constexpr VectorKernels kernel_table(const char* name) {
    return {name,
            vector_particles_to_nodes<false>,
            vector_particles_to_nodes<true>,
            vector_pressure_to_nodes<false>,
            vector_pressure_to_nodes<true>,
            vector_nodes_to_particles_stage<false>,
            vector_nodes_to_particles_stage<true>};
}

}  // namespace
}  // namespace frana
