// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <functional>
#include <utility>

#include "bench/set_up/setup.h"
#include "models/structured/solid/column_state.h"
#include "models/structured/solid/placement.h"
#include "models/structured/step.h"

namespace frana::structured::test {

inline const double k_degree = M_PI / 180;

/// Structured solids for a test: laws, one material, columns on a lattice. Three particles per cell side,
/// 2.5 nodes of the stress; dry, cohesive, E = 100 MPa, nu = 1/4, 1700 kg/m3, 28 degrees, unless changed.
struct SolidBlock {
    explicit SolidBlock(double cell) : SolidBlock(cell, 0.5 * cell) {}
    SolidBlock(double cell, double damage_length) : laws(cell, damage_length) {
        laws.solid.spacing = cell / 3;
        laws.solid.elastic = Elasticity::from_young_and_bulk(1e8, 1e8 / 1.5);
        material.solid_fraction = 1;
        material.grain_density = 1700;
        material.cohesion = 1e12;
        material.friction = material.bed_friction = std::tan(28 * M_PI / 180);
    }

    /// Fills a rectangle of nx by ny lattice places from (x0, y0) on.
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

    /// Returns the run's state, sorted and on the nodes.
    State start(const Raster& bed, ThreadPool& pool, bool wet = false) {
        double lightest = material.grain_density;
        laws.solid.basal.gravity = laws.coupling.drag.fluid.gravity = laws.fluid.gravity = laws.solid.gravity;
        if (wet) {
            laws.solid.basal.fluid_density = 1000;
            lightest = material.solid_fraction * material.grain_density + (1 - material.solid_fraction) * 1000;
        }
        laws.solid.wave_speed = laws.solid.elastic.wave_speed(lightest);
        SolidStages stages = choose_solid_stages(material.cohesion > 0, wet);
        const auto of_place = [this](Point) { return material; };
        const ParticleSet solids = assign_material(split_phases(columns, of_place), stages.fields, of_place);
        State state(NodeGrid(bed), laws, solids, stages, wet);
        prepare(state, laws, pool);
        return state;
    }

    Laws laws;
    SolidMaterial material;
    ParticleSet columns;
};

/// Steps until a time is reached; returns particles times substeps.
inline std::int64_t advance_to(State& state, const Laws& laws, double time, ThreadPool& pool) {
    std::int64_t particle_steps = 0;
    while (time - state.time > 1e-9 * time) {
        const StepReport report = step(state, laws, time - state.time, pool);
        particle_steps += report.substeps * static_cast<std::int64_t>(state.solid->particles.size());
    }
    return particle_steps;
}

/// A plane that falls to the right.
inline Raster incline(double slope_deg, std::int64_t columns, std::int64_t rows, double cell) {
    const GridSpec grid = bench::plain_grid(columns, rows, cell);
    return bench::sample_raster(grid, [&](Point p) { return (grid.east() - p.x) * std::tan(slope_deg * M_PI / 180); });
}

struct Case : SolidBlock {
    explicit Case(double cell) : SolidBlock(cell), cell_size(cell) {}
    Case(double cell, double damage_length) : SolidBlock(cell, damage_length), cell_size(cell) {}
    double cell_size;
};

inline Raster flat(std::int64_t columns, std::int64_t rows, double cell_size) {
    return Raster(bench::plain_grid(columns, rows, cell_size), 0.0);
}

/// Stress, strain and forces of a lone particle that is deformed with the velocity gradient l [1/s] over dt: what one
/// alone gives to the nodes of the stress it takes back.
inline void deform(State& state, const SolidLaws& laws, const Matrix2d& l, double dt) {
    SolidState& solid = *state.solid;
    const std::pair<Field, double> affine[] = {
        {Field::c_xx, l(0, 0)}, {Field::c_xy, l(0, 1)}, {Field::c_yx, l(1, 0)}, {Field::c_yy, l(1, 1)}};
    for (const auto& [field, value] : affine) solid.particles[field][0] = value;
    solid.stress.begin();
    solid.stress.add_momentum(solid.particles, 0, particle_mass(laws, solid.particles, 0),
                              solid.work[SolidWork::bonds][0] > 0);
    state.stages.update_material({0, 1}, dt, laws, solid.stress, solid.particles, solid.work);
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
