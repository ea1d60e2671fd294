// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "models/structured/solid/column_state.h"
#include "mpm/curvature.h"
#include "mpm/node_grid.h"
#include "particles/cell_order.h"
#include "physics/pore_pressure.h"

namespace frana::structured {

/// Pore pressure of the solids over dt, by the law of the first model (PorePressure), each particle with its own
/// hydrostatic ratio: that of the pressure that the load on the bed (BasalPressure) already counts when the pores are
/// full, over the weight of the saturated solids. Where structure that breaks lets hydrostatic pressure reach the bed,
/// it takes the place of excess pressure, so that no pressure counts twice and none is lost; what is not above it
/// follows it. In a step of no
/// length only that. Reads places, velocities, volumes, area, flatness, strength; writes pore_pressure, hydrostatic
/// and, with dilatancy, solid_fraction.
template <class Kind>
void advance_pore_pressure(ParticleRun run, double dt, const SolidLaws& laws, const NodeGrid& grid,
                           ParticleSet& particles) {
    double *const solid = particles[Field::solid_fraction], *const area = particles[Field::area];
    for (std::size_t p = run.begin; p < run.end; ++p) {
        const Saturated whole = Saturated::of<Kind>(laws, particles, p);
        double hydrostatic = 0;
        if constexpr (Kind::wet) {
            const ParticleLoad load = particle_load<Kind>(laws, particles, p);
            const Column full{particles[Field::volume][p] / area[p], load.kept, load.structured, 1};
            if (particles[Field::pores][p] > 0)
                hydrostatic = 1 - laws.basal(full, particles[Field::grain_density][p]) /
                                      (laws.basal.gravity * whole.density * whole.depth);
        }
        double &ratio = particles[Field::pore_pressure][p], &before = particles[Field::hydrostatic][p];
        ratio = ratio > before ? std::max(ratio, hydrostatic) : ratio + hydrostatic - before;
        before = hydrostatic;
        if (!(dt > 0)) continue;
        PorePressure law = laws.pores;
        law.hydrostatic = hydrostatic;
        law.density = whole.density;
        const double x = particles[Field::x][p], y = particles[Field::y][p];
        const double u = particles[Field::u][p], v = particles[Field::v][p];
        double climb = 0, root = 1;
        if (laws.steep) {
            root = std::sqrt(particles[Field::flatness][p]);
            if (law.dilates() && grid.bounds().contains(x, y))
                climb =
                    climb_at(grid.bed.data() + grid.scale().node_of(x, y), grid.stride(), 0.5 / grid.cell_size(), u, v);
        }
        const auto after = law.after({ratio, solid != nullptr ? solid[p] : 0}, root * whole.depth,
                                     speed_along_bed(u, v, climb), root * laws.gravity, dt);
        ratio = after.ratio;
        if (solid != nullptr) solid[p] = after.solid_fraction;
    }
}

}  // namespace frana::structured
