// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "models/structured/solid/column_state.h"
#include "models/structured/solid/cubic_stencil.h"
#include "particles/cell_order.h"

namespace frana::structured {

/// Adds a run of particles to the nodes: mass, momentum, volumes. Runs that share no node may be added concurrently.
template <class Kind>
void solids_to_nodes(ParticleRun run, const SolidLaws& laws, const ParticleSet& particles, const NodeGrid& grid,
                     SolidNodes& nodes) {
    for (std::size_t p = run.begin; p < run.end; ++p) {
        const CubicStencil stencil(particles[Field::x][p], particles[Field::y][p], grid, nodes);
        if (!stencil.any) continue;
        const ParticleLoad column = particle_load<Kind>(laws, particles, p);
        const double u = particles[Field::u][p], v = particles[Field::v][p], area = particles[Field::area][p];
        const double solids = particles[Field::volume][p];
        const double friction = Kind::wet ? area * column.bearing * particles[Field::bed_friction][p] : 0;
        for (int b = 0; b < 4; ++b) {
            const std::size_t row = stencil.first + static_cast<std::size_t>(b * grid.stride());
            for (int a = 0; a < 4; ++a) {
                const double w = stencil.weight[b][a];
                SolidSums& node = nodes.sums[row + static_cast<std::size_t>(a)];
                node.mass += w * column.mass;
                node.px += w * column.mass * u;
                node.py += w * column.mass * v;
                node.solids += w * solids;
                node.structured += w * solids * column.structured;
                if constexpr (Kind::wet) {
                    node.confined += w * particles[Field::confined][p];
                    CouplingSums& more = nodes.coupling[row + static_cast<std::size_t>(a)];
                    more.diameter += w * solids * particles[Field::grain_diameter][p];
                    more.friction += w * friction;
                    more.area += w * area;
                    more.pores += w * particles[Field::pores][p];
                }
            }
        }
    }
}

/// Values that particles gather from the nodes over a step of dt: accelerations as increments (FLIP), so that momentum
/// is conserved; the bed's flatness; how far the pores are filled. Freely flowing columns can spread until their
/// particles have no neighbours within reach; their area therefore follows the depth at the nodes, as fast as gravity
/// levels a cell.
template <class Kind>
void nodes_to_solids(ParticleRun run, const SolidLaws& laws, double dt, const NodeGrid& grid, const SolidNodes& nodes,
                     ParticleSet& particles) {
    for (std::size_t p = run.begin; p < run.end; ++p) {
        const CubicStencil stencil(particles[Field::x][p], particles[Field::y][p], grid, nodes);
        double ax = 0, ay = 0, flatness = 0, submergence = 0, depth = 0;
        for (int b = 0; b < 4; ++b) {
            const std::size_t row = stencil.first + static_cast<std::size_t>(b * grid.stride());
            for (int a = 0; a < 4; ++a) {
                const double w = stencil.weight[b][a];
                const std::size_t n = row + static_cast<std::size_t>(a);
                const NodePush& node = nodes.push[n];
                ax += w * node.ax;
                ay += w * node.ay;
                flatness += w * node.flatness;
                submergence += w * node.submergence;
                depth += w * nodes.depth[n];
            }
        }
        particles[Field::push_x][p] = ax;
        particles[Field::push_y][p] = ay;
        particles[Field::flatness][p] = stencil.any ? flatness : 1;
        if constexpr (Kind::wet) particles[Field::submergence][p] = submergence;
        const ParticleLoad column = particle_load<Kind>(laws, particles, p);
        if (!(depth > 0) || !flows_freely(column)) continue;
        const double speed = std::hypot(particles[Field::u][p], particles[Field::v][p]);
        const double fraction = std::min(1.0, dt * (speed + std::sqrt(laws.gravity * depth)) / grid.cell_size());
        double& area = particles[Field::area][p];
        area += fraction * (area * column.depth / depth - area);
    }
}

}  // namespace frana::structured
