// SPDX-License-Identifier: Apache-2.0
#include "models/structured/solid/placement.h"

#include <algorithm>
#include <cmath>

namespace frana::structured {
namespace {

constexpr FieldMask k_placed_fields = k_basic_fields | FieldMask{Field::confined};

double sum_of(const ParticleSet& particles, Field field) {
    double sum = 0;
    for (std::size_t p = 0; p < particles.size(); ++p) sum += particles[field][p];
    return sum;
}

void scale_to(double sum, ParticleSet& particles, Field field) {
    const double now = sum_of(particles, field);
    if (!(now > 0)) return;
    for (std::size_t p = 0; p < particles.size(); ++p) particles[field][p] *= sum / now;
}

}  // namespace

ParticleSet split_phases(const ParticleSet& columns, const std::function<SolidMaterial(Point)>& material,
                         double thinnest) {
    ParticleSet particles(k_placed_fields);
    double solids = 0, confined = 0;
    for (std::size_t p = 0; p < columns.size(); ++p) {
        ParticleRow r = columns.row(p);
        const double whole = get(r, Field::volume);
        const SolidMaterial m = material({get(r, Field::x), get(r, Field::y)});
        if (!(m.solid_fraction > 0)) continue;
        get(r, Field::volume) = m.solid_fraction * whole;
        get(r, Field::confined) = m.confined_fluid() * whole;
        solids += get(r, Field::volume);
        confined += get(r, Field::confined);
        if (whole >= thinnest * get(r, Field::area)) particles.push_back(r);
    }
    if (particles.size() == 0 && solids > 0) return split_phases(columns, material);  // nothing but thin columns
    if (thinnest > 0) {
        scale_to(solids, particles, Field::volume);
        scale_to(confined, particles, Field::confined);
    }
    return particles;
}

ParticleSet assign_material(const ParticleSet& placed, FieldMask fields,
                            const std::function<SolidMaterial(Point)>& material) {
    ParticleSet particles(fields);
    particles.resize(placed.size());
    for (std::size_t p = 0; p < placed.size(); ++p) {
        ParticleRow r = placed.row(p);
        const SolidMaterial m = material({get(r, Field::x), get(r, Field::y)});
        get(r, Field::confined_start) = get(r, Field::confined);
        get(r, Field::pores) = (1 - m.solid_fraction) / m.solid_fraction * get(r, Field::volume);
        get(r, Field::pore_pressure) = m.pore_pressure;
        get(r, Field::solid_fraction) = m.solid_fraction;
        get(r, Field::cohesion) = m.cohesion;
        get(r, Field::cohesion_ratio) = m.cohesion > 0 ? 1 : 0;
        get(r, Field::friction) = m.friction;
        get(r, Field::bed_friction) = m.bed_friction;
        get(r, Field::grain_density) = m.grain_density;
        get(r, Field::grain_diameter) = m.grain_diameter;
        particles.set_row(p, r);
    }
    return particles;
}

}  // namespace frana::structured
