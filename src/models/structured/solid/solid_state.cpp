// SPDX-License-Identifier: Apache-2.0
#include "models/structured/solid/solid_state.h"

#include <algorithm>
#include <cmath>

#include "models/structured/solid/material_update.h"
#include "models/structured/solid/pore_stage.h"
#include "models/structured/solid/transfer.h"

namespace frana::structured {
namespace {

template <class Kind>
SolidStages stages_of() {
    SolidStages stages;
    stages.update_material = update_material<Kind>;
    stages.solids_to_nodes = solids_to_nodes<Kind>;
    stages.nodes_to_solids = nodes_to_solids<Kind>;
    if constexpr (Kind::pressed) stages.advance_pore_pressure = advance_pore_pressure<Kind>;
    return stages;
}

template <bool Pressed>
SolidStages stages_of(bool cohesive, bool wet) {
    if (cohesive)
        return wet ? stages_of<SolidKind<true, true, Pressed>>() : stages_of<SolidKind<true, false, Pressed>>();
    return wet ? stages_of<SolidKind<false, true, Pressed>>() : stages_of<SolidKind<false, false, Pressed>>();
}

// Which particles are bonded: cohesive, and strong enough to bear their weight.
void find_bonds(SolidState& state, const SolidLaws& laws) {
    const ParticleSet& particles = state.particles;
    state.work.resize(particles.size());
    if (!particles.mask().has(Field::cohesion)) return;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double bears = DruckerPrager::of(particles[Field::friction][p], particles[Field::cohesion][p]).uniaxial();
        const double weight = laws.gravity * particle_mass(laws, particles, p) / particles[Field::area][p];
        state.work[SolidWork::bonds][p] = particles[Field::cohesion_ratio][p] > 0 && 2 * bears >= weight;
    }
}

}  // namespace

bool fits(const SolidState& state) {
    constexpr double k_anywhere = 1e12;  // [m]: node numbers of farther places would overflow
    const std::size_t count = state.particles.size();
    const bool unused = state.order.rows() == 0 && count == 0;
    for (const std::vector<double>& array : state.work.arrays) {
        if (array.size() != count && !unused) return false;
    }
    for (const Field field : {Field::x, Field::y}) {
        const double* const place = state.particles[field];
        if (!std::all_of(place, place + count, [](double x) { return std::abs(x) < k_anywhere; })) return false;
    }
    return state.order.orders(count);
}

SolidStages choose_solid_stages(bool cohesive, bool wet, const PorePressure& pores) {
    SolidStages stages = pores.active() ? stages_of<true>(cohesive, wet) : stages_of<false>(cohesive, wet);
    stages.fields = solid_fields(cohesive, wet);
    if (pores.active()) stages.fields = stages.fields | k_pore_fields;
    if (pores.dilates()) stages.fields = stages.fields | FieldMask{Field::solid_fraction};
    stages.releases = cohesive && wet;
    return stages;
}

void sort_solids(SolidState& state, const SolidLaws& laws, const NodeGrid& grid, ThreadPool& pool) {
    ParticleSet& particles = state.particles;
    std::vector<std::uint8_t> keep;
    double px = 0, py = 0, mass = 0;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double x = particles[Field::x][p], y = particles[Field::y][p];
        const double u = particles[Field::u][p], v = particles[Field::v][p], solids = particles[Field::volume][p];
        const double confined = particles[Field::confined] ? particles[Field::confined][p] : 0;
        const double m = particle_mass(laws, particles, p);
        if (grid.bounds().contains(x, y)) {
            mass += m;
            px += m * u;
            py += m * v;
            continue;
        }
        if (keep.empty()) keep.assign(particles.size(), 1);
        keep[p] = 0;
        state.left.solids += solids;
        state.left.confined += confined;
        state.left.mass += m;
        state.left.px += m * u;
        state.left.py += m * v;
    }
    state.order.sort(particles, keep, pool);
    state.mean = mass > 0 ? Point{px / mass, py / mass} : Point{};
    state.drift = state.moved = 0;
    find_bonds(state, laws);
}

void gather_solids(SolidState& state, const SolidStages& stages, const SolidLaws& laws, const NodeGrid& grid,
                   ThreadPool& pool) {
    SolidNodes& nodes = state.nodes;
    nodes.clear(grid, pool);
    nodes.find_tiles(state.particles, state.order, grid, pool);
    state.order.for_each_strip(4 * grid.cell_size(), pool, [&](ParticleRun run) {
        stages.solids_to_nodes(run, laws, state.particles, grid, nodes);
    });
}

}  // namespace frana::structured
