// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <utility>

#include "bench/set_up/solid_block.h"

namespace frana::structured::test {

inline const double k_degree = M_PI / 180;

struct Case : bench::SolidBlock {
    explicit Case(double cell) : SolidBlock(cell), cell_size(cell) {}
    Case(double cell, double damage_length) : SolidBlock(cell, damage_length), cell_size(cell) {}
    double cell_size;
};

inline Raster flat(std::int64_t columns, std::int64_t rows, double cell_size) {
    return Raster(bench::plain_grid(columns, rows, cell_size), 0.0);
}

using bench::advance_to;
using bench::incline;

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
