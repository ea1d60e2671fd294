// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <functional>

#include "bench/lattice.h"
#include "models/structured/solid/placement.h"
#include "models/structured/step.h"

namespace frana::structured::test {

inline const double k_degree = M_PI / 180;

/// Everything of a run; particles three a cell side, smoothing length half a cell.
struct Case {
    explicit Case(double cell) : laws(0.5 * cell), cell_size(cell) {
        laws.solid.spacing = cell / 3;
        laws.solid.elastic = Elasticity::from_young_and_bulk(1e8, 1e8 / 1.5);
        material.solid_fraction = 1;
        material.grain_density = 1700;
        material.cohesion = 1e12;
        material.friction = std::tan(28 * k_degree);
        material.bed_friction = material.friction;
    }

    /// Fills a rectangle with a lattice of columns.
    void fill(double x0, double y0, std::int64_t nx, std::int64_t ny, const std::function<bench::Seed(Point)>& seed) {
        const double spacing = laws.solid.spacing;
        for (std::int64_t j = 0; j < ny; ++j) {
            for (std::int64_t i = 0; i < nx; ++i) {
                const Point at{x0 + (static_cast<double>(i) + 0.5) * spacing,
                               y0 + (static_cast<double>(j) + 0.5) * spacing};
                const bench::Seed s = seed(at);
                if (!(s.depth > 0)) continue;
                ParticleRow r = ParticleSet::initial_row();
                get(r, Field::x) = at.x;
                get(r, Field::y) = at.y;
                get(r, Field::u) = s.u;
                get(r, Field::v) = s.v;
                get(r, Field::volume) = s.depth * spacing * spacing;
                get(r, Field::area) = spacing * spacing;
                columns.push_back(r);
            }
        }
    }

    /// The run's state, in order and on the nodes.
    State start(const Raster& bed, ThreadPool& pool, bool wet = false) {
        double lightest = material.grain_density;
        laws.solid.basal.gravity = laws.coupling.drag.fluid.gravity = laws.fluid.gravity = laws.solid.gravity;
        if (wet) {
            laws.solid.basal.fluid_density = 1000;
            lightest = material.solid_fraction * material.grain_density + (1 - material.solid_fraction) * 1000;
        }
        laws.solid.wave_speed = laws.solid.elastic.wave_speed(lightest);
        laws.solid.viscosity.length = laws.solid.kernel.length();
        laws.solid.viscosity.sound = laws.solid.wave_speed;
        const SolidStages stages = choose_solid_stages(material.cohesion > 0, wet);
        const auto of_place = [this](Point) { return material; };
        const ParticleSet solids = give_material(split_phases(columns, of_place), stages.fields, of_place);
        State state(NodeGrid(bed), laws, solids, stages, wet);
        prepare(state, laws, pool);
        return state;
    }

    Laws laws;
    double cell_size;
    SolidMaterial material;
    ParticleSet columns;
};

inline Raster flat(std::int64_t columns, std::int64_t rows, double cell_size) {
    return Raster(bench::plain_grid(columns, rows, cell_size), 0.0);
}

inline void advance_to(State& state, const Laws& laws, double time, ThreadPool& pool) {
    while (time - state.time > 1e-9 * time) step(state, laws, time - state.time, pool);
}

/// Mass times velocity of all solids with what they hold [kg m/s], and the sum of its sizes.
struct Momentum {
    double x = 0, y = 0, size = 0;
};
inline Momentum momentum(const ParticleSet& p, double fluid_density) {
    Momentum m;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const double confined = p[Field::confined] ? p[Field::confined][i] : 0;
        const double mass = p[Field::grain_density][i] * p[Field::volume][i] + fluid_density * confined;
        m.x += mass * p[Field::u][i];
        m.y += mass * p[Field::v][i];
        m.size += mass * std::hypot(p[Field::u][i], p[Field::v][i]);
    }
    return m;
}

}  // namespace frana::structured::test
